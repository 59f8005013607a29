// Cells of light lists on the screen: tiles with their depth range, cut into depth slices.
// A coarse cell is 8 × 8 tiles.
#ifndef PRELIGHT_LIGHT_CELLS_SCREEN_GLSL
#define PRELIGHT_LIGHT_CELLS_SCREEN_GLSL
#include "shared/depth_bits.glsl"
#include "shared/gbuffer.glsl"
#include "shared/light_bounds.glsl"
#include "shared/light_lists.h"
#include "shared/light_slices.glsl"

layout(constant_id = CONSTANT_LIST_TILE_SIZE) const int tile_size = 16;

// Pixels of the picture from `low` to `high`, at view depths from `nearest` to `farthest`.
Piece screen_piece(vec2 low, vec2 high, float nearest, float farthest) {
    vec2 clip_low = clip_of(low);
    vec2 clip_high = min(high * raster.size.zw, vec2(1.0)) * 2.0 - 1.0;
    vec2 clip = 0.5 * (clip_low + clip_high);
    vec3 right = frame.ray_right.xyz, up = frame.ray_up.xyz, forward = frame.forward.xyz;
    vec3 middle = right * clip.x + up * clip.y;
    Piece p;
    if (frame.forward.w > 0.5) {
        vec3 rays[4];
        p.w = vec3(0.0);
        for (int i = 0; i < 4; ++i) {
            rays[i] = forward + right * ((i & 1) == 0 ? clip_low.x : clip_high.x) +
                      up * ((i & 2) == 0 ? clip_low.y : clip_high.y);
            p.w += normalize(rays[i]); // where a picture is wide, the middle of the rays is not that of the pixels
        }
        p.w = normalize(p.w);
        p.u = normalize(right - p.w * dot(right, p.w));
        p.v = cross(p.w, p.u);
        p.middle = p.half_size = p.slope = vec2(0.0);
        vec2 along = vec2(1e30, 0.0); // of the rays at view depth 1: least and most
        for (int i = 0; i < 4; ++i) {
            float w = dot(rays[i], p.w);
            p.slope = max(p.slope, abs(vec2(dot(rays[i], p.u), dot(rays[i], p.v))) / w);
            along = vec2(min(along.x, w), max(along.y, w));
        }
        p.low = nearest * along.x;
        p.high = farthest * along.y;
        if (along.x < 1e-3) { // almost half of all directions: no pyramid holds them
            p.slope = vec2(0.0);
            p.half_size = vec2(1e18);
            p.low = -1e18;
            p.high = 1e18;
        }
    } else {
        p.u = normalize(right);
        p.v = normalize(up);
        p.w = forward;
        p.middle = vec2(dot(middle, p.u), dot(middle, p.v));
        p.half_size = 0.5 * (clip_high - clip_low) * vec2(length(right), length(up));
        p.slope = vec2(0.0);
        p.low = nearest;
        p.high = farthest;
    }
    // Rounding of depth, which grows with the distance.
    float slack = 2e-6 * (abs(p.high) + abs(p.low));
    p.low -= slack;
    p.high += slack;
    return p;
}

// Where the light's sphere may lie on the screen, in coarse cells: a box around it, projected. No cell
// when high < low.
void light_extent(LightBounds light, out ivec3 low, out ivec3 high) {
    float z = dot(light.centre, frame.forward.xyz);
    vec2 scale = vec2(dot(frame.ray_right.xyz, frame.ray_right.xyz), dot(frame.ray_up.xyz, frame.ray_up.xyz));
    vec2 centre = vec2(dot(light.centre, frame.ray_right.xyz), dot(light.centre, frame.ray_up.xyz)) / scale;
    vec2 reach = light.radius / sqrt(scale);
    vec2 from = centre - reach, to = centre + reach;
    if (frame.forward.w > 0.5) {
        float near = z - light.radius, far = z + light.radius;
        bool before = near > 1e-4 * light.radius; // wholly before the camera
        from = before ? from / mix(vec2(far), vec2(near), lessThan(from, vec2(0.0))) : vec2(-1.0);
        to = before ? to / mix(vec2(near), vec2(far), lessThan(to, vec2(0.0))) : vec2(1.0);
    }
    vec2 coarse = 0.5 * raster.size.xy / float(LIST_COARSE_TILES * tile_size);
    vec2 most = vec2(lists.coarse.xy);
    low = ivec3(clamp(floor((from + 1.0) * coarse - 0.01), vec2(0.0), most), 0);
    high = ivec3(clamp(floor((to + 1.0) * coarse + 0.01), vec2(-1.0), most - 1.0), 0);
}

// Of a coarse cell within its light_extent(). A pyramid around the coarse cell would leave out a few lights more, and
// takes longer than its tiles take for these.
bool may_reach_coarse(uvec3 at, LightCell cell, LightBounds light) {
    float z = dot(light.centre, frame.forward.xyz);
    return !(z + light.radius < cell.nearest) && !(z - light.radius > cell.farthest);
}

// The stored depths within the light's reach, as depth_bits().
uint depths_of(LightBounds light) {
    float z = dot(light.centre, frame.forward.xyz);
    float near = z - light.radius, far = z + light.radius;
    if (linear_depth)
        return depth_bits(near, far);
    // Nearer than the near plane (1) nothing is stored; an orthographic camera's depth may lie beyond the far one.
    bool before = frame.forward.w < 0.5 || near > 0.0;
    return depth_bits(before ? min(device_depth(near), 1.0) : 1.0, far > 0.0 || frame.forward.w < 0.5 ? device_depth(far) : 1.0);
}
bool holds_depths(LightCell cell, uint depths) { return (cell.depths & depths) != 0u; }

// The cell of an invocation; a workgroup is a coarse cell.
uvec3 cell_at(uvec3 group, uint invocation) {
    return uvec3(group.xy * LIST_COARSE_TILES + uvec2(invocation % LIST_COARSE_TILES, invocation / LIST_COARSE_TILES), 0u);
}

// One bit for each slice that holds a surface of the tile.
uint slices_in_use(uvec3 at, LightCell cell) {
    if (cell.nearest > cell.farthest)
        return 0u;
    if (!sliced)
        return 1u;
    ivec2 low = ivec2(at.xy) * tile_size;
    ivec2 high = min(low + tile_size, ivec2(raster.size.xy));
    uint slices = 0u;
    for (int y = low.y; y < high.y; ++y)
        for (int x = low.x; x < high.x; ++x) {
            EACH_SAMPLE {
                float stored = read_depth(ivec2(x, y));
                slices |= stored > 0.0 ? 1u << slice_of(stored) : 0u;
            }
        }
    return slices;
}

// `whole`: with all of its slices.
Piece cell_piece(uvec3 at, LightCell cell, uint slice, bool whole) {
    vec2 low = vec2(at.xy) * float(tile_size);
    float nearest = cell.nearest, farthest = cell.farthest;
    if (sliced) {
        nearest = max(nearest, whole ? nearest : slice_begin(slice));
        farthest = min(farthest, whole ? farthest : slice_begin(slice + 1u));
    }
    return screen_piece(low, low + float(tile_size), nearest, farthest);
}
#endif
