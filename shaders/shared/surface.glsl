// A point of an object and what its material's textures say about the surface there. Textures that the
// material does not have cost nothing: they are specialised away.
#ifndef PRELIGHT_SURFACE_GLSL
#define PRELIGHT_SURFACE_GLSL
#include "shared/frame.glsl"
#include "shared/material_set.glsl"
#include "shared/reflectance.glsl"

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

// A point of an object under a pixel.
struct Point {
    vec3 position;   // world axes, metres, the camera at the origin; 0 where NO_WORLD
    vec3 to_viewer;  // unit; likewise
    vec3 normal;     // unit, of the geometry, on the side of the viewer; 0 where NO_NORMAL
    vec4 tangent;    // world space, w the bitangent's sign; likewise
    vec4 texcoords;  // sets 0 and 1
    vec4 colour;     // of the vertices, linear
};

Point point() {
    Point p;
#ifdef NO_WORLD
    p.position = p.to_viewer = vec3(0.0);
#else
    p.position = in_world;
    p.to_viewer = to_viewer(in_world);
#endif
#ifdef NO_NORMAL
    p.normal = vec3(0.0);
    p.tangent = vec4(0.0);
#else
    vec3 n = normalize(in_normal);
    p.normal = gl_FrontFacing ? n : -n;
    p.tangent = in_tangent;
#endif
    p.texcoords = in_texcoords;
    p.colour = in_colour;
    return p;
}

// Coordinates of the texture at a MATERIAL_… binding (KHR_texture_transform).
vec2 coordinates(Point p, int binding) {
    vec4 o = material.uv_offset[binding - 1];
    return transformed(binding, o.z > 0.5 ? p.texcoords.zw : p.texcoords.xy) + o.xy;
}

vec4 base_colour(Point p) {
    vec4 colour = material.base_colour * p.colour;
    if (has(FEATURE_BASE_COLOUR_TEXTURE))
        colour *= texture(base_colour_map, coordinates(p, MATERIAL_BASE_COLOUR));
    return colour;
}

// x metallic, y perceptual roughness
vec2 metallic_roughness(Point p) {
    vec2 factors = material.factors.xy;
    if (has(FEATURE_METALLIC_ROUGHNESS_TEXTURE))
        factors *= texture(metallic_roughness_map, coordinates(p, MATERIAL_METALLIC_ROUGHNESS)).bg;
    return factors;
}

// A direction of tangent space in world space, unit, facing the viewer on back faces as p.normal does.
vec3 from_tangent_space(Point p, vec3 direction) {
    vec3 n = gl_FrontFacing ? p.normal : -p.normal;
    vec3 t = normalize(p.tangent.xyz);
    vec3 b = cross(n, t) * p.tangent.w;
    n = normalize(t * direction.x + b * direction.y + n * direction.z);
    return gl_FrontFacing ? n : -n;
}

// The normal map's normal in tangent space, not of unit length; (0, 0, 1) without one.
vec3 mapped_normal(Point p) {
    if (!has(FEATURE_NORMAL_TEXTURE))
        return vec3(0.0, 0.0, 1.0);
    vec3 texel = texture(normal_map, coordinates(p, MATERIAL_NORMAL)).xyz * 2.0 - 1.0;
    return vec3(texel.xy * material.factors.z, texel.z);
}

// Variance of slopes that the level read of the normal map has averaged away; alpha holds its root.
float normal_map_variance(Point p) {
    if (!has(FEATURE_NORMAL_TEXTURE))
        return 0.0;
    float deviation = texture(normal_map, coordinates(p, MATERIAL_NORMAL)).a * material.factors.z;
    return deviation * deviation;
}

// Unit shading normal in world space, after the normal map, facing the viewer on back faces.
vec3 shading_normal(Point p) {
    return has(FEATURE_NORMAL_TEXTURE) ? from_tangent_space(p, mapped_normal(p)) : p.normal;
}

float occlusion(Point p) {
    if (!has(FEATURE_OCCLUSION_TEXTURE))
        return 1.0;
    return 1.0 + material.factors.w * (texture(occlusion_map, coordinates(p, MATERIAL_OCCLUSION)).r - 1.0);
}

// Exposed.
vec3 emissive(Point p) {
    vec3 colour = material.emissive.rgb;
    if (has(FEATURE_EMISSIVE_TEXTURE))
        colour *= texture(emissive_map, coordinates(p, MATERIAL_EMISSIVE)).rgb;
    return colour;
}

// What a material's surface() gives.
struct Surface {
    vec3 normal;      // unit, world space
    float roughness;  // perceptual; lights see at least 0.089
    float alpha;      // below the material's cut-off nothing is there (alphaMode MASK)
    vec3 base;        // base colour, linear
    float metallic;
    float occlusion;  // 0 … 1, on ambient light
    vec3 emissive;    // exposed
};

// As the glTF material's own factors and textures say.
Surface gltf_surface(Point p) {
    vec4 base = base_colour(p);
    vec2 factors = metallic_roughness(p);
    return Surface(shading_normal(p), factors.y, base.a, base.rgb, factors.x, occlusion(p), emissive(p));
}

// What a blended surface covers of what is behind it; an opaque one all.
float blended_coverage(Surface s) { return has(FEATURE_BLENDED) ? clamp(s.alpha, 0.0, 1.0) : 1.0; }
bool is_masked(Surface s) { return has(FEATURE_ALPHA_MASK) && s.alpha < material.emissive.w; }
#endif
