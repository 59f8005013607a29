// glTF 2.0 metallic-roughness. Fresnel: weighted mean over the lights.
Surface surface(Point p) { return gltf_surface(p); }

vec3 shade(Point p, Surface s, Light light) {
    vec3 diffuse_colour = s.base * (1.0 - s.metallic);
    vec3 f0 = mix(vec3(0.04), s.base, s.metallic);
    vec3 diffuse = diffuse_colour / lambert_divisor * (1.0 - f0 - (1.0 - f0) * light.grazing_diffuse) * light.irradiance;
    vec3 specular = (f0 + (1.0 - f0) * light.grazing_specular) * light.specular;
    return diffuse + specular + ambient_on(light, diffuse_colour, f0) + s.emissive;
}
