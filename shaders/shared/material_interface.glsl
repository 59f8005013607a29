// What a material's file is written against: docs/materials.md. It gives
//     Surface surface(Point p)                      run wherever the surface is looked at
//     vec3 shade(Point p, Surface s, Light light)   run where light becomes colour
// and is included here as "material.glsl", whichever material that is. Every file that is compiled with it
// is compiled with each built-in material as well: "// materials: all with OWN_MATERIAL" at its top.
#ifndef PRELIGHT_MATERIAL_INTERFACE_GLSL
#define PRELIGHT_MATERIAL_INTERFACE_GLSL
#include "shared/surface.glsl"

#ifndef PRELIGHT_LIGHTING_GLSL
layout(constant_id = CONSTANT_SHADING) const int shading = SHADING_GGX;
#endif

// What irradiance is divided by to give what a white Lambert surface sends on: the source texts' model knows
// no π.
const float lambert_divisor = shading == SHADING_GGX ? 3.14159265 : 1.0;

// The light on a surface, exposed: of all lights, as the light buffer sums them, or a loop does.
struct Light {
    vec3 diffuse;     // what a white Lambert surface sends on: Σ N·L colour attenuation / lambert_divisor
    vec3 specular;    // what a mirror-coloured surface sends on: Σ … (N·H)^n, or N·L D V without Fresnel
    vec3 ambient;     // radiance from everywhere, occlusion applied; of an environment what a white Lambert
                      // surface sends on
    float luminance;  // of `diffuse`
    vec3 irradiance;  // Σ N·L colour attenuation
    // Mean (1 − V·H)⁵ of the lights, weighted by their luminance in either sum: Schlick's Fresnel term is
    // F0 + (1 − F0) times it. (1 − N·V)⁵ where V·H of each light is not known.
    float grazing_diffuse, grazing_specular;
    // What a mirror of this roughness shows of the environment, occlusion applied; and what of it a surface sends
    // on: F0 · reflectance.x + reflectance.y. Without an environment `ambient`, and 1 and 0.
    vec3 mirrored;
    vec2 reflectance;
    float openness;  // what occlusion leaves of mirrored light
};

// (1 − N·V)⁵
float grazing_at_viewer(Point p, Surface s) {
    float m = clamp(1.0 - dot(s.normal, p.to_viewer), 0.0, 1.0);
    return m * m * m * m * m;
}

// Light that no source sends.
Light light_of_ambient_alone(vec3 ambient, float grazing) {
    return Light(vec3(0.0), vec3(0.0), ambient, 0.0, vec3(0.0), grazing, grazing, ambient, vec2(1.0, 0.0), 1.0);
}

#include "shared/environment.glsl"

// A radiance of the scene as a picture of this exposure has it: what shade() gives is exposed.
vec3 exposed(vec3 radiance) { return radiance * frame.light_buffer.y; }

// Parameters: `PARAMETERS { float width DEFAULT(0.5) RANGE(0.0, 1.0); … };`, read by the host. Types: float,
// vec2, vec3, vec4; a range holds for each component.
#define PARAMETERS layout(set = SET_MATERIAL, binding = MATERIAL_PARAMETERS, std140) uniform ParameterBlock
#define DEFAULT(value)
#define RANGE(low, high)

// Textures of its own: `TEXTURE_LINEAR(0) width_map DEFAULT(white);`, in slots 0 … 7. What stands in for one
// that a material does not have: white, black, flat (a normal map's), or required.
#define TEXTURE_COLOUR(slot) layout(set = SET_MATERIAL, binding = MATERIAL_OWN_TEXTURE + slot) uniform sampler2D
#define TEXTURE_LINEAR(slot) layout(set = SET_MATERIAL, binding = MATERIAL_OWN_TEXTURE + slot) uniform sampler2D
bool has_texture(int slot) { return has(FEATURE_OWN_TEXTURE << slot); }
vec2 texture_place(Point p, int slot) { return coordinates(p, MATERIAL_OWN_TEXTURE + slot); }

#include "material.glsl"

// The surface as light sees it: the material's, under decals where there are any.
#ifdef DECALS
#include "shared/decals.glsl"
#endif
#ifdef LAYER_DECALS
#include "shared/layer_decals.glsl"
#endif
vec3 bare_normal; // the surface's own, for anti-aliasing: decals come pixel by pixel
Surface surface_under_decals(inout Point p) {
    Surface s = surface(p);
    bare_normal = s.normal;
#ifdef DECALS
    apply_decals(s);
#endif
#ifdef LAYER_DECALS
    apply_layer_decals(s, p.position);
#endif
    return s;
}
#endif
