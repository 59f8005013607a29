// Constant blocks and storage records of a frame. "World" below means camera-relative world space:
// the world's axes, metres, with the camera at the origin, so that a scene far from the world's
// origin keeps its precision.
#ifndef PRELIGHT_FRAME_H
#define PRELIGHT_FRAME_H
#include "shared/interop.h"
SHARED_BEGIN

struct FrameConstants {
    mat4 clip_from_world;  // reversed depth: near 1, far 0
    mat4 world_from_clip;
    mat4 view_from_world;  // rotation; the camera looks along −Z
    vec4 ray_right;        // xyz: world vector of one unit of clip x at view depth 1 (perspective)
                           // or at any depth (orthographic)
    vec4 ray_up;           // xyz: the same for clip y
    vec4 forward;          // xyz: unit; w: 1 perspective, 0 orthographic
    vec4 depth;            // x, y: clip.z = −x · view depth + y
    vec4 ambient;          // rgb: radiance × exposure; w: largest value that one light stores
    vec4 light_buffer;     // x: scale that stored light is divided by (32 for float formats);
                           // y: exposure factor; z: x of specular light
    mat4 previous_clip_from_world;  // what clip_from_world was one interval earlier, for positions
                                    // relative to this frame's camera; the same when it stood still
    vec4 sun;  // the first directional light with a shadow: x: its LightData::shadow, 0 without one; y: its number
};

// One light; directional ones are point lights whose vector to the light is constant.
struct LightData {
    vec3 position;        // world position, or the unit vector to a directional light
    float inverse_range;  // 0 when infinite
    vec3 colour;          // colour · intensity · exposure
    uint kind;            // LIGHT_FALLOFF_… | LIGHT_DIRECTIONAL | number of its DistributionData, counted from 1,
                          // << LIGHT_DISTRIBUTION_SHIFT
    vec3 axis;            // unit vector the light shines along (spot)
    float shininess;
    vec2 cone;            // scale and offset of the cone's falloff; scale 0 where there is no cone
    float outer_angle;    // radians
    uint shadow;          // number of its first shadow tile: see shadow.h; 0 without a shadow
};

// What a light sends in which direction: a cookie, a measured profile, or both. Maps lie in one image, level by level
// with a texel around each that continues it.
struct DistributionData {
    vec4 right;    // xyz: the light's +X axis, world; w: 1 / width of that image
    vec4 up;       // xyz: +Y; w: 1 / height
    vec4 cookie;   // x: COOKIE_…; y: its first DistributionLevel; z: the number of its last level;
                   // w: COOKIE_SPOT: 1 / tan(outer cone)
    vec4 detail;   // x: texels of the cookie's level 0 a radian; y: 1 where there is a profile; z, w: the profile's
                   // first and last angle from the axis, radians
    vec4 profile;  // place in its map: x: column at 0°, y: columns a radian, z: row at 0°, w: rows a radian
};

struct DistributionLevel {
    vec4 rectangle;  // texels: x, y of the corner, width, height
};

// What a light covers of the screen, in the order of the lights: light-culling=rectangles.
struct LightScreenBounds {
    vec4 rectangle;  // clip space: low x, low y, high x, high y
    vec4 depth;      // x, y: device depth of the nearest and the farthest point; reversed, so x ≥ y
};

// One object, a vertex attribute that steps once an instance; rows of the 3×4 matrix object → world, and of the inverse transpose.
struct ObjectData {
    vec4 world_row[3];
    vec4 normal_row[3];  // w of the first: −1 when mirrored, else 1; of the second: number of the draw, from 1;
                         // of the third: metres that a unit of the object is
    vec4 previous_world_row[3];  // world_row one interval earlier, relative to this frame's camera
};

struct MaterialConstants {
    vec4 unread;  // what lies first is not read: docs/notes/software-devices.md#uniform-buffers
    vec4 base_colour;
    vec4 emissive;              // rgb × exposure; w: alpha cut-off; of what is blended its softness, metres
    vec4 factors;               // metallic, roughness, normal scale, occlusion strength
    vec4 uv_linear[13];         // MATERIAL_TEXTURES of them, in the order of MATERIAL_… bindings: columns of 2×2
    vec4 uv_offset[13];         // xy: offset; z: texture-coordinate set; w: 1 where vertex tangents follow its coordinates
};

// What of the world's environment map no pixel needs to look up.
struct EnvironmentConstants {
    vec4 irradiance[9];  // rgb: spherical harmonics of what a white Lambert surface sends on; exposed
    vec4 levels;         // x: rows of a map in level 0 of MATERIAL_ENVIRONMENT; y: factor (exposure × intensity);
                         // z: turns that the map is rotated by, added to its u
};

SHARED_END
#endif
