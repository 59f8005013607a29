#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
// The nearest and the farthest depth that the filter of `pcf` may meet from anywhere in a cell of the atlas: for a point
// that is nearer than both, or farther, every comparison says the same (after Dmitriev and Uralsky, "Soft Shadows Using
// Hierarchical Min-Max Shadow Maps", GDC 2007). A fragment is a cell.
#include "shared/bindings.h"
#include "shared/shadow.h"

layout(constant_id = CONSTANT_SHADOWS_TRANSMIT) const bool shadows_transmit = false;
layout(set = SET_INPUTS, binding = INPUT_SHADOW_ATLAS) uniform texture2D shadow_atlas;
layout(set = SET_INPUTS, binding = INPUT_SHADOW_TRANSMITTANCE) uniform texture2D shadow_transmittance;
layout(push_constant) uniform Push { uvec4 tile; }; // xy: its corner in the atlas, z: its side; texels

layout(location = 0) out vec2 out_extremes; // largest depth, which is the nearest, and least

// Texels past the cell: the outermost comparison is 1.452 away (1.5 √(7.5 / 8)) and reads half a texel farther.
const int reach = 2;

void main() {
    ivec2 corner = ivec2(tile.xy), last = corner + int(tile.z) - 1;
    ivec2 first = ivec2(gl_FragCoord.xy) * SHADOW_CELL - reach;
    const int side = SHADOW_CELL + 2 * reach;
    vec2 extremes = vec2(0.0, 1.0);
    for (int y = 0; y < side; ++y) // so short that a driver unrolls them
        for (int x = 0; x < side; ++x) {
            ivec2 texel = clamp(first + ivec2(x, y), corner, last); // as lookups stay in their tile
            float depth = texelFetch(shadow_atlas, texel, 0).r, nearest = depth;
            if (shadows_transmit) // its depths are half floats
                nearest = max(nearest, texelFetch(shadow_transmittance, texel, 0).a * (1.0 + 1.0 / 512.0));
            extremes = vec2(max(extremes.x, nearest), min(extremes.y, depth));
        }
    out_extremes = extremes;
}
