// glTF's metallic-roughness with KHR_materials_specular, _ior, _clearcoat, _sheen, _transmission and _volume, from one
// sum of specular light for all layers.
PARAMETERS {
    float ior DEFAULT(1.5) RANGE(1.0, 1000.0); // KHR_materials_ior
    float specular DEFAULT(1.0) RANGE(0.0, 1.0); // KHR_materials_specular: strength of a dielectric's reflection
    vec3 specular_colour DEFAULT(vec3(1.0)) RANGE(0.0, 1000.0); // and its colour at normal incidence
    float clearcoat DEFAULT(0.0) RANGE(0.0, 1.0); // KHR_materials_clearcoat
    float clearcoat_roughness DEFAULT(0.0) RANGE(0.0, 1.0);
    vec3 sheen_colour DEFAULT(vec3(0.0)) RANGE(0.0, 1.0); // KHR_materials_sheen
    float sheen_roughness DEFAULT(0.0) RANGE(0.0, 1.0);
    float transmission DEFAULT(0.0) RANGE(0.0, 1.0); // KHR_materials_transmission: of what is not reflected, the part that comes through
    float thickness DEFAULT(0.0) RANGE(0.0, 1000000.0); // KHR_materials_volume: of what light comes through, in the mesh's units; 0: a thin wall
    float attenuation_distance DEFAULT(1e30) RANGE(1e-6, 1e30); // metres after which white light has the next one's colour
    vec3 attenuation_colour DEFAULT(vec3(1.0)) RANGE(0.0, 1.0);
};
TEXTURE_LINEAR(0) specular_map DEFAULT(white); // A
TEXTURE_COLOUR(1) specular_colour_map DEFAULT(white);
TEXTURE_LINEAR(2) clearcoat_map DEFAULT(white); // R
TEXTURE_LINEAR(3) clearcoat_roughness_map DEFAULT(white); // G
TEXTURE_COLOUR(4) sheen_colour_map DEFAULT(white);
TEXTURE_LINEAR(5) sheen_roughness_map DEFAULT(white); // A
TEXTURE_LINEAR(6) transmission_map DEFAULT(white); // R
TEXTURE_LINEAR(7) thickness_map DEFAULT(white); // G

float coat_strength(Point p) {
    return has_texture(2) ? clearcoat * texture(clearcoat_map, texture_place(p, 2)).r : clearcoat;
}

float coat_roughness(Point p) {
    return has_texture(3) ? clearcoat_roughness * texture(clearcoat_roughness_map, texture_place(p, 3)).g : clearcoat_roughness;
}

// Lights see one roughness: the coat's, as far as there is a coat.
Surface surface(Point p) {
    Surface s = gltf_surface(p);
    s.roughness = mix(s.roughness, coat_roughness(p), coat_strength(p));
    return s;
}

float transmission_at(Point p) {
    return has_texture(6) ? transmission * texture(transmission_map, texture_place(p, 6)).r : transmission;
}

float thickness_at(Point p) { return has_texture(7) ? thickness * texture(thickness_map, texture_place(p, 7)).g : thickness; }

vec3 light_through = vec3(0.0); // with TRANSMISSION: what comes through the body, exposed, before the surface takes its share

// The environment on body and coat, each with its own roughness; `sheen`: what the cloth takes.
vec3 environment_on_layers(Point p, Surface s, Light light, vec3 diffuse_colour, vec3 f0, float f90, vec3 sheen) {
    float body_roughness = metallic_roughness(p).y, coat_rough = coat_roughness(p), nv = facing(p, s);
    vec2 scale = environment_reflectance(body_roughness, nv), coat_scale = environment_reflectance(coat_rough, nv);
    vec3 body = diffuse_colour * light.ambient + (f0 * scale.x + f90 * scale.y) * light.openness * environment_radiance(mirror_direction(p, s, body_roughness), body_roughness);
    vec3 dressed = body * (1.0 - max(sheen.r, max(sheen.g, sheen.b))) + sheen * light.ambient;
    float coat = coat_strength(p) * (0.04 * coat_scale.x + coat_scale.y);
    return dressed * (1.0 - coat) + coat * light.openness * environment_radiance(mirror_direction(p, s, coat_rough), coat_rough);
}

vec3 shade(Point p, Surface s, Light light) {
    float weight = specular;
    vec3 tint = specular_colour, cloth_colour = sheen_colour;
    float cloth_roughness = sheen_roughness;
    if (has_texture(0))
        weight *= texture(specular_map, texture_place(p, 0)).a;
    if (has_texture(1))
        tint *= texture(specular_colour_map, texture_place(p, 1)).rgb;
    if (has_texture(4))
        cloth_colour *= texture(sheen_colour_map, texture_place(p, 4)).rgb;
    if (has_texture(5))
        cloth_roughness *= texture(sheen_roughness_map, texture_place(p, 5)).a;

    float r = (ior - 1.0) / (ior + 1.0);
    vec3 f0 = mix(min(r * r * tint, vec3(1.0)) * weight, s.base, s.metallic);
    float f90 = mix(weight, 1.0, s.metallic);
    vec3 diffuse_colour = s.base * (1.0 - s.metallic), through = vec3(0.0);
#ifdef TRANSMISSION
    float share = transmission_at(p);
    through = diffuse_colour * share * (1.0 - f0 - (f90 - f0) * grazing_at_viewer(p, s)) * light_through;
    diffuse_colour *= 1.0 - share;
#endif
    vec3 ambient = has(FEATURE_ENVIRONMENT) ? vec3(0.0) : light.ambient;
    vec3 body = diffuse_colour * (1.0 - f0 - (f90 - f0) * light.grazing_diffuse) * light.diffuse +
                (f0 + (f90 - f0) * light.grazing_specular) * light.specular + ambient * (diffuse_colour + f0) + s.emissive + through;

    float nv = facing(p, s);
    vec3 sheen = cloth_colour * pow(max(1.0 - nv, 0.0001), 1.0 + 3.0 * (1.0 - cloth_roughness));
    vec3 dressed = body * (1.0 - max(sheen.r, max(sheen.g, sheen.b))) + sheen * (light.diffuse + ambient);

    float strength = coat_strength(p), coat = strength * (0.04 + 0.96 * light.grazing_specular);
    vec3 colour = dressed * (1.0 - coat) + coat * light.specular + 0.04 * strength * ambient;
    return has(FEATURE_ENVIRONMENT) ? colour + environment_on_layers(p, s, light, diffuse_colour, f0, f90, sheen) : colour;
}
