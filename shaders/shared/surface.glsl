// What a material's textures say about the surface under a pixel. Textures that the material does not
// have cost nothing: they are specialised away.
#ifndef PRELIGHT_SURFACE_GLSL
#define PRELIGHT_SURFACE_GLSL
#include "shared/frame.glsl"
#include "shared/reflectance.glsl"

layout(constant_id = CONSTANT_MATERIAL_FEATURES) const uint material_features = 0u;

layout(set = SET_MATERIAL, binding = MATERIAL_CONSTANTS, std140) uniform MaterialBlock { MaterialConstants material; };
layout(set = SET_MATERIAL, binding = MATERIAL_BASE_COLOUR) uniform sampler2D base_colour_map;
layout(set = SET_MATERIAL, binding = MATERIAL_METALLIC_ROUGHNESS) uniform sampler2D metallic_roughness_map;
layout(set = SET_MATERIAL, binding = MATERIAL_NORMAL) uniform sampler2D normal_map;
layout(set = SET_MATERIAL, binding = MATERIAL_OCCLUSION) uniform sampler2D occlusion_map;
layout(set = SET_MATERIAL, binding = MATERIAL_EMISSIVE) uniform sampler2D emissive_map;

// What is left out here is left out in surface_vertex.glsl too: a software device carries each output
// through every triangle, read or not.
#ifndef NO_WORLD
layout(location = 0) in vec3 in_world;
#endif
#ifndef NO_NORMAL
layout(location = 1) in vec3 in_normal;
#endif
#ifdef NO_TEXTURES  // materials without any
const vec4 in_tangent = vec4(1.0, 0.0, 0.0, 1.0), in_texcoords = vec4(0.0);
#else
#ifndef NO_NORMAL
layout(location = 2) in vec4 in_tangent;
#endif
layout(location = 3) in vec4 in_texcoords;
#endif
layout(location = 4) in vec4 in_colour;

bool has(uint feature) { return (material_features & feature) != 0u; }

// Coordinates of the texture at a MATERIAL_… binding (KHR_texture_transform).
vec2 coordinates(int binding) {
    vec4 m = material.uv_linear[binding - 1];
    vec4 o = material.uv_offset[binding - 1];
    vec2 uv = o.z > 0.5 ? in_texcoords.zw : in_texcoords.xy;
    return m.xy * uv.x + m.zw * uv.y + o.xy;
}

vec4 base_colour() {
    vec4 colour = material.base_colour * in_colour;
    if (has(FEATURE_BASE_COLOUR_TEXTURE))
        colour *= texture(base_colour_map, coordinates(MATERIAL_BASE_COLOUR));
    return colour;
}

// x metallic, y perceptual roughness
vec2 metallic_roughness() {
    vec2 factors = material.factors.xy;
    if (has(FEATURE_METALLIC_ROUGHNESS_TEXTURE))
        factors *= texture(metallic_roughness_map, coordinates(MATERIAL_METALLIC_ROUGHNESS)).bg;
    return factors;
}

#ifndef NO_NORMAL
// Unit shading normal in world space, after the normal map, facing the viewer on back faces.
vec3 shading_normal() {
    vec3 n = normalize(in_normal);
    if (has(FEATURE_NORMAL_TEXTURE)) {
        vec3 texel = texture(normal_map, coordinates(MATERIAL_NORMAL)).xyz * 2.0 - 1.0;
        texel.xy *= material.factors.z;
        vec3 t = normalize(in_tangent.xyz);
        vec3 b = cross(n, t) * in_tangent.w;
        n = normalize(t * texel.x + b * texel.y + n * texel.z);
    }
    return gl_FrontFacing ? n : -n;
}
#endif

float occlusion() {
    if (!has(FEATURE_OCCLUSION_TEXTURE))
        return 1.0;
    return 1.0 + material.factors.w * (texture(occlusion_map, coordinates(MATERIAL_OCCLUSION)).r - 1.0);
}

vec3 emissive() {
    vec3 colour = material.emissive.rgb;
    if (has(FEATURE_EMISSIVE_TEXTURE))
        colour *= texture(emissive_map, coordinates(MATERIAL_EMISSIVE)).rgb;
    return colour;
}

// Light that needs no lamp: ambient as a term of the material, and emissive; an unlit surface's colour.
vec3 base_light(vec3 base) {
    if (has(FEATURE_UNLIT))
        return base * frame.light_buffer.y;
    Reflectance r = reflectance(base, metallic_roughness().x);
    return frame.ambient.rgb * occlusion() * (r.diffuse + r.f0) + emissive();
}
#endif
