// Textured Blinn-Phong, equation 8.5.3 of [E]. From glTF materials: specular colour = F0, exponent
// 2/α² − 2; no Fresnel.
Surface surface(Point p) { return gltf_surface(p); }

vec3 shade(Point p, Surface s, Light light) {
    vec3 diffuse_colour = s.base * (1.0 - s.metallic);
    vec3 specular_colour = mix(vec3(0.04), s.base, s.metallic);
    vec3 ambient = ambient_on(light, diffuse_colour, specular_colour);
    return ambient + light.diffuse * diffuse_colour + light.specular * specular_colour + s.emissive;
}
