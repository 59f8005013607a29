// glTF's metallic-roughness with a rim: a colour that edges have, from light or of their own.
PARAMETERS {
    vec3 rim_colour DEFAULT(vec3(0.5, 0.7, 1.0)) RANGE(0.0, 1.0); // times `rim`
    float rim DEFAULT(1.0) RANGE(0.0, 16.0); // radiance at the very edge
    float power DEFAULT(3.0) RANGE(0.5, 16.0); // how narrow it is
    float lit DEFAULT(0.0) RANGE(0.0, 1.0); // 1: from the light buffer; 0: of its own
};

Surface surface(Point p) { return gltf_surface(p); }

vec3 shade(Point p, Surface s, Light light) {
    vec3 diffuse_colour = s.base * (1.0 - s.metallic);
    vec3 f0 = mix(vec3(0.04), s.base, s.metallic);
    float edge = pow(clamp(1.0 - dot(s.normal, p.to_viewer), 0.0001, 1.0), power);
    vec3 diffuse = diffuse_colour * (1.0 - f0 - (1.0 - f0) * light.grazing_diffuse) * light.diffuse;
    vec3 specular = (f0 + (1.0 - f0) * light.grazing_specular) * light.specular;
    vec3 source = mix(exposed(vec3(1.0)), light.diffuse + light.ambient, lit);
    return diffuse + specular + ambient_on(light, diffuse_colour, f0) + rim * edge * rim_colour * source + s.emissive;
}
