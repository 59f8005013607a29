// glTF's metallic-roughness with the maps of Lee's engine: parallax, details of colour and normal under a mask,
// gloss, incandescence.
#include "shared/relief.glsl"
TEXTURE_LINEAR(0) height_map DEFAULT(white); // R: 1 is the face, 0 the bottom
TEXTURE_LINEAR(1) detail_normal_map DEFAULT(flat); // tangent space, +Y up
TEXTURE_LINEAR(2) detail_mask DEFAULT(white); // R: how much of the details there is
TEXTURE_LINEAR(3) gloss_map DEFAULT(white); // R: factor on specular light, down to none
TEXTURE_COLOUR(4) incandescence_map DEFAULT(black); // light of its own, times `incandescence`
TEXTURE_COLOUR(5) detail_map DEFAULT(white); // factor on base colour; code 128 leaves it as it is
PARAMETERS {
    float depth DEFAULT(0.03) RANGE(0.0, 0.2); // of the relief, in texture coordinates
    float occlusion_steps DEFAULT(0.0) RANGE(0.0, 64.0); // of parallax occlusion; 0: one look, parallax
    float detail DEFAULT(1.0) RANGE(0.0, 4.0); // how strong detail normals are
    float detail_colour DEFAULT(1.0) RANGE(0.0, 1.0); // how much of detail_map there is
    float gloss_roughness DEFAULT(0.0) RANGE(0.0, 1.0); // how rough a surface is where gloss_map is black
    float incandescence DEFAULT(1.0) RANGE(0.0, 1000.0); // radiance of a white texel
};

const float grey_128 = 0.21586050; // of sRGB

#define SURFACE_GLOSS gloss // for a G-buffer
float gloss(Point p) { return has_texture(3) ? texture(gloss_map, texture_place(p, 3)).r : 1.0; }

Surface surface(inout Point p) {
    vec4 detail_tangent = has_texture(1) ? tangent_of(p, MATERIAL_OWN_TEXTURE + 1) : p.tangent;
    if (has_texture(0)) {
        vec3 viewer = viewer_in_tangent_space(p, tangent_of(p, MATERIAL_OWN_TEXTURE));
        vec2 place = texture_place(p, 0);
        vec2 shift = occlusion_steps < 1.0 ? parallax(height_map, place, viewer, depth)
                                           : parallax_occlusion(height_map, place, viewer, depth, int(occlusion_steps));
        p.texcoords = moved_texcoords(p, MATERIAL_OWN_TEXTURE, shift);
    }
    Surface s = gltf_surface(p);
    float mask = 1.0;
    if (has_texture(1) || has_texture(5))
        mask = texture(detail_mask, texture_place(p, 2)).r;
    if (has_texture(1)) {
        vec2 slopes = texture(detail_normal_map, texture_place(p, 1)).xy * 2.0 - 1.0;
        s.normal = with_detail(p, mapped_normal(p), detail_tangent, slopes * (detail * mask));
    }
    if (has_texture(5)) {
        vec3 factor = texture(detail_map, texture_place(p, 5)).rgb / grey_128;
        s.base = min(s.base * mix(vec3(1.0), factor, detail_colour * mask), vec3(1.0));
    }
    if (has_texture(3))
        s.roughness = mix(s.roughness, 1.0, gloss_roughness * (1.0 - gloss(p)));
    if (has_texture(4))
        s.emissive += exposed(texture(incandescence_map, texture_place(p, 4)).rgb * incandescence);
    return s;
}

// Gloss is how much there is of what lies above the diffuse layer: what it does not reflect, it lets through.
vec3 shade(Point p, Surface s, Light light) {
    vec3 diffuse_colour = s.base * (1.0 - s.metallic);
    vec3 f0 = mix(vec3(0.04), s.base, s.metallic);
    float shine = gloss(p);
    vec3 at_diffuse = shine * (f0 + (1.0 - f0) * light.grazing_diffuse), at_specular = shine * (f0 + (1.0 - f0) * light.grazing_specular);
    vec3 around = has(FEATURE_ENVIRONMENT) ? environment_on(light, f0) : light.ambient * f0;
    return diffuse_colour * ((1.0 - at_diffuse) * light.diffuse + light.ambient) + at_specular * light.specular +
           shine * around + s.emissive;
}
