#version 460
#extension GL_GOOGLE_include_directive : require
// Stage 3: glTF 2.0 metallic-roughness from the light buffer. Fresnel: weighted mean over the lights
// (model=weighted), or at N·V as equation 8.5.8 suggests (nv, mono).
#ifdef ONLY_WEIGHTED  // model=weighted
#define NO_WORLD
#define NO_NORMAL
#endif
#include "shared/display.glsl"
#include "shared/light_buffer.glsl"
#include "shared/surface.glsl"

layout(constant_id = CONSTANT_MODEL) const int model = MODEL_WEIGHTED;
layout(constant_id = CONSTANT_MATERIAL_OUTPUT) const int material_output = MATERIAL_OUTPUT_SHADED;
layout(constant_id = CONSTANT_AMBIENT_AS_LIGHT) const bool ambient_as_light = false;
layout(location = 0) out vec4 out_colour;

void main() {
    vec3 base = base_colour().rgb;
    if (material_output == MATERIAL_OUTPUT_ALBEDO) {
        out_colour = vec4(base, 1.0);
        return;
    }
    if (has(FEATURE_UNLIT)) {
        out_colour = stored_colour(min(base * frame.light_buffer.y, vec3(65504.0)));
        return;
    }
    float metallic = metallic_roughness().x;
    vec3 diffuse_colour = base * (1.0 - metallic);
    vec3 f0 = mix(vec3(0.04), base, metallic);

    Light light = read_light();
    if (material_output == MATERIAL_OUTPUT_DIFFUSE_SUM || material_output == MATERIAL_OUTPUT_SPECULAR_SUM) {
        out_colour = vec4(material_output == MATERIAL_OUTPUT_DIFFUSE_SUM ? light.diffuse.rgb : light.specular.rgb, 1.0);
        return;
    }
    float grazing_diffuse = mean_grazing(light.diffuse), grazing_specular = mean_grazing(light.specular);
#ifndef ONLY_WEIGHTED
    if (model != MODEL_WEIGHTED) {
        float m = clamp(1.0 - dot(shading_normal(), to_viewer(in_world)), 0.0, 1.0);
        grazing_diffuse = grazing_specular = m * m * m * m * m;
    }
#endif
    vec3 diffuse = diffuse_colour / 3.14159265 * (1.0 - f0 - (1.0 - f0) * grazing_diffuse) * light.diffuse.rgb;
    vec3 specular = (f0 + (1.0 - f0) * grazing_specular) * light.specular.rgb;
    vec3 ambient = ambient_as_light ? vec3(0.0) : frame.ambient.rgb * occlusion() * (diffuse_colour + f0);
    out_colour = stored_colour(min(diffuse + specular + ambient + emissive(), vec3(65504.0)));
}
