// Skin: Lambert whose dark side rolls off into a subsurface colour, after lambSkinDusk as the appendix of [E]
// has it: from the luminance of the light buffer.
PARAMETERS {
    float roll_off DEFAULT(0.4) RANGE(0.0, 2.0); // how much of the dark side the subsurface colour takes
    vec3 subsurface_colour DEFAULT(vec3(0.5, 0.1, 0.06)) RANGE(0.0, 1.0); // what light has become under the skin
    float glow DEFAULT(0.0) RANGE(0.0, 1.0); // of that colour where no light is; the source text's own has 1
};

Surface surface(Point p) { return gltf_surface(p); }

vec3 shade(Point p, Surface s, Light light) {
    float lit = light.luminance;
    float subsurface = max(smoothstep(-roll_off, 1.0, lit) - smoothstep(0.0, 1.0, lit), 0.0);
    subsurface *= mix(smoothstep(0.0, max(roll_off, 0.001), lit), 1.0, glow);
    float fresnel = 0.04 + 0.96 * light.grazing_specular;
    return s.base * (light.diffuse + light.ambient) + subsurface * subsurface_colour + fresnel * light.specular + environment_on(light, vec3(0.04)) + s.emissive;
}
