// glTF's metallic-roughness under the environment map: its light from all around, and its reflection, blurred by
// roughness. Without one, under ambient light.
#include "shared/environment.glsl"
PARAMETERS {
    float strength DEFAULT(1.0) RANGE(0.0, 4.0); // of the reflection
};

Surface surface(Point p) { return gltf_surface(p); }

vec3 shade(Point p, Surface s, Light light) {
    vec3 diffuse_colour = s.base * (1.0 - s.metallic);
    vec3 f0 = mix(vec3(0.04), s.base, s.metallic);
    float nv = clamp(dot(s.normal, p.to_viewer), 0.0, 1.0);
    vec2 scale = environment_reflectance(s.roughness, nv);
    vec3 mirrored = environment_radiance(reflect(-p.to_viewer, s.normal), s.roughness, light);
    vec3 diffuse = diffuse_colour * (1.0 - f0 - (1.0 - f0) * light.grazing_diffuse) * light.diffuse;
    vec3 specular = (f0 + (1.0 - f0) * light.grazing_specular) * light.specular;
    vec3 ambient = environment_ambient(s.normal, s, light);
    return diffuse + specular + diffuse_colour * ambient + strength * s.occlusion * (f0 * scale.x + scale.y) * mirrored + s.emissive;
}
