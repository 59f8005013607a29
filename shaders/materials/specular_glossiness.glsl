// KHR_materials_pbrSpecularGlossiness: a diffuse colour and the reflectance at normal incidence, each its own. glTF's base
// colour holds the diffuse one.
PARAMETERS {
    vec3 specular DEFAULT(vec3(1.0)) RANGE(0.0, 1.0); // F0
    float glossiness DEFAULT(1.0) RANGE(0.0, 1.0); // 1 − perceptual roughness
};
TEXTURE_COLOUR(0) specular_glossiness_map DEFAULT(white); // RGB F0, A glossiness

// rgb F0, a glossiness
vec4 specular_and_gloss(Point p) {
    vec4 own = vec4(specular, glossiness);
    return has_texture(0) ? own * texture(specular_glossiness_map, texture_place(p, 0)) : own;
}

// What the diffuse lobe leaves of the diffuse colour.
vec3 scattered(vec3 diffuse, vec3 f0) { return diffuse * (1.0 - max(f0.r, max(f0.g, f0.b))); }

float brightness(vec3 c) { return sqrt(dot(c * c, vec3(0.299, 0.587, 0.114))); }

// Metallic-roughness that comes closest, for whoever knows nothing else (deferred shading, decals): base colour, metallic.
// Solves base (1 − m) = scattered and 0.04 (1 − m) + base m = F0 for their brightness, then colour by colour.
vec4 closest_metallic(vec3 body, vec3 f0) {
    float d = brightness(body), s = brightness(f0), m = 0.0;
    if (s > 0.04) {
        float b = d + s - 0.08;
        m = clamp((sqrt(max(b * b - 0.16 * (0.04 - s), 0.0)) - b) / 0.08, 0.0, 1.0);
    }
    vec3 from_diffuse = body / max(1.0 - m, 1e-4), from_specular = (f0 - 0.04 * (1.0 - m)) / max(m, 1e-4);
    return vec4(clamp(mix(from_diffuse, from_specular, m * m), 0.0, 1.0), m);
}

Surface surface(Point p) {
    Surface s = gltf_surface(p);
    vec4 own = specular_and_gloss(p);
    vec4 closest = closest_metallic(scattered(s.base, own.rgb), own.rgb);
    s.roughness = 1.0 - own.a;
    s.base = closest.rgb;
    s.metallic = closest.a;
    return s;
}

vec3 shade(Point p, Surface s, Light light) {
    // Under a decal the surface is another: what metallic-roughness misses is added to what the surface now is.
    vec3 own_f0 = specular_and_gloss(p).rgb, own_diffuse = scattered(base_colour(p).rgb, own_f0);
    vec4 closest = closest_metallic(own_diffuse, own_f0);
    vec3 diffuse_colour = max(s.base * (1.0 - s.metallic) + own_diffuse - closest.rgb * (1.0 - closest.a), 0.0);
    vec3 f0 = clamp(mix(vec3(0.04), s.base, s.metallic) + own_f0 - mix(vec3(0.04), closest.rgb, closest.a), 0.0, 1.0);
    vec3 diffuse = diffuse_colour * (1.0 - f0 - (1.0 - f0) * light.grazing_diffuse) * light.diffuse;
    vec3 specular_light = (f0 + (1.0 - f0) * light.grazing_specular) * light.specular;
    return diffuse + specular_light + ambient_on(light, diffuse_colour, f0) + s.emissive;
}
