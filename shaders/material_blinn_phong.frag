#version 460
#extension GL_GOOGLE_include_directive : require
// Stage 3: textured Blinn-Phong, equation 8.5.3, with the material's own shininess [L5]. From glTF
// materials: specular colour = F0, exponent 2/α² − 2.
#define NO_WORLD
#define NO_NORMAL
#include "shared/display.glsl"
#include "shared/light_buffer.glsl"
#include "shared/shininess.glsl"
#include "shared/surface.glsl"

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
    vec2 surface = metallic_roughness();
    float metallic = surface.x;
    vec3 diffuse_colour = base * (1.0 - metallic);
    vec3 specular_colour = mix(vec3(0.04), base, metallic);
    Light light = read_light();
    vec3 specular = specular_light_of(light, shininess(surface.y));
    if (material_output == MATERIAL_OUTPUT_DIFFUSE_SUM || material_output == MATERIAL_OUTPUT_SPECULAR_SUM) {
        out_colour = vec4(material_output == MATERIAL_OUTPUT_DIFFUSE_SUM ? light.diffuse.rgb : specular, 1.0);
        return;
    }
    vec3 ambient = ambient_as_light ? vec3(0.0) : frame.ambient.rgb * occlusion() * (diffuse_colour + specular_colour);
    vec3 colour = ambient + light.diffuse.rgb * diffuse_colour + specular * specular_colour + emissive();
    out_colour = stored_colour(min(colour, vec3(65504.0)));
}
