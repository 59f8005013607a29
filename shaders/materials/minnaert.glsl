// Minnaert's law of the moon's surface, as the appendix of [E] has it: (N·L)^k (N·V)^(1−k), N·L from the
// luminance of the light buffer. Above 1, k darkens what is seen from the front: velvet; below, edges.
PARAMETERS {
    float k DEFAULT(1.6) RANGE(0.0, 4.0); // 1: Lambert
};

Surface surface(Point p) { return gltf_surface(p); }

vec3 shade(Point p, Surface s, Light light) {
    float nv = clamp(dot(s.normal, p.to_viewer), 0.05, 1.0);
    // The lights' colour stays: their luminance alone is raised.
    float minnaert = light.luminance > 0.0 ? pow(light.luminance, k - 1.0) * pow(nv, 1.0 - k) : 0.0;
    return s.base * (light.diffuse * minnaert + light.ambient) + s.emissive;
}
