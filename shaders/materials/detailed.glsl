// glTF's metallic-roughness with the maps of Lee's engine: parallax, detail normals under a mask, gloss,
// incandescence.
#include "shared/relief.glsl"
TEXTURE_LINEAR(0) height_map DEFAULT(white); // R: 1 is the face, 0 the bottom
TEXTURE_LINEAR(1) detail_normal_map DEFAULT(flat); // tangent space, +Y up
TEXTURE_LINEAR(2) detail_mask DEFAULT(white); // R: how much of the detail there is
TEXTURE_LINEAR(3) gloss_map DEFAULT(white); // R: 1 as smooth as the material says, 0 rough
TEXTURE_COLOUR(4) incandescence_map DEFAULT(black); // light of its own, times `incandescence`
PARAMETERS {
    float depth DEFAULT(0.03) RANGE(0.0, 0.2); // of the relief, in texture coordinates
    float occlusion_steps DEFAULT(0.0) RANGE(0.0, 64.0); // of parallax occlusion; 0: one look, parallax
    float detail DEFAULT(1.0) RANGE(0.0, 4.0); // how strong detail normals are
    float incandescence DEFAULT(1.0) RANGE(0.0, 1000.0); // radiance of a white texel
};

Surface surface(inout Point p) {
    if (has_texture(0)) {
        vec3 viewer = viewer_in_tangent_space(p);
        vec2 place = texture_place(p, 0);
        vec2 shift = occlusion_steps < 1.0 ? parallax(height_map, place, viewer, depth)
                                           : parallax_occlusion(height_map, place, viewer, depth, int(occlusion_steps));
        p.texcoords += shift.xyxy;
    }
    Surface s = gltf_surface(p);
    if (has_texture(1)) {
        vec3 texel = texture(detail_normal_map, texture_place(p, 1)).xyz * 2.0 - 1.0;
        float amount = detail * texture(detail_mask, texture_place(p, 2)).r;
        s.normal = from_tangent_space(p, with_detail(mapped_normal(p), texel, amount));
    }
    if (has_texture(3))
        s.roughness = mix(1.0, s.roughness, texture(gloss_map, texture_place(p, 3)).r);
    if (has_texture(4))
        s.emissive += exposed(texture(incandescence_map, texture_place(p, 4)).rgb * incandescence);
    return s;
}

vec3 shade(Point p, Surface s, Light light) {
    vec3 diffuse_colour = s.base * (1.0 - s.metallic);
    vec3 f0 = mix(vec3(0.04), s.base, s.metallic);
    vec3 diffuse = diffuse_colour * (1.0 - f0 - (1.0 - f0) * light.grazing_diffuse) * light.diffuse;
    vec3 specular = (f0 + (1.0 - f0) * light.grazing_specular) * light.specular;
    return diffuse + specular + ambient_on(light, diffuse_colour, f0) + s.emissive;
}
