// glTF's metallic-roughness under the environment map: its light from all around, and its reflection, blurred by
// roughness, as strong as one likes. Without one, under ambient light.
PARAMETERS {
    float strength DEFAULT(1.0) RANGE(0.0, 4.0); // of the reflection
};

// Of light that comes from everywhere alike: Karis, "Physically Based Shading on Mobile", 2014.
vec2 uniform_reflectance(float roughness, float nv) {
    vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float a = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
    return vec2(-1.04, 1.04) * a + r.zw;
}

Surface surface(Point p) { return gltf_surface(p); }

vec3 shade(Point p, Surface s, Light light) {
    vec3 diffuse_colour = s.base * (1.0 - s.metallic);
    vec3 f0 = mix(vec3(0.04), s.base, s.metallic);
    vec2 scale = has(FEATURE_ENVIRONMENT) ? light.reflectance : uniform_reflectance(s.roughness, facing(p, s));
    vec3 mirrored = has(FEATURE_ENVIRONMENT) ? light.mirrored : light.ambient * s.occlusion;
    vec3 diffuse = diffuse_colour * (1.0 - f0 - (1.0 - f0) * light.grazing_diffuse) * light.diffuse;
    vec3 specular = (f0 + (1.0 - f0) * light.grazing_specular) * light.specular;
    return diffuse + specular + diffuse_colour * light.ambient + strength * (f0 * scale.x + scale.y) * mirrored + s.emissive;
}
