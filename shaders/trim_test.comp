#version 460
#extension GL_GOOGLE_include_directive : require
// variants: BY_DEPTH, SAMPLES
// only: SAMPLES with BY_DEPTH
// Which triangles of a group may show. The tests and the room for rounding are those of
// src/resident/trim_indices.cpp; with BY_DEPTH a triangle of a few pixels is left out too when at each of them
// stands something nearer.
#include "shared/pixel_reads.glsl"
#include "shared/samples.glsl"
#include "shared/trimming.glsl"

layout(constant_id = CONSTANT_TRIM_SUBPIXEL_BITS) const uint subpixel_bits = 8u;
layout(set = SET_INPUTS, binding = INPUT_TRIM_OBJECTS, std430) readonly buffer ObjectBlock { ObjectData objects[]; };
layout(set = SET_INPUTS, binding = INPUT_TRIM_POSITIONS, std430) readonly buffer PositionBlock { float positions[]; };
layout(set = SET_INPUTS, binding = INPUT_TRIM_MASKS, std430) writeonly buffer MaskBlock { TrimMask masks[]; };
#ifdef BY_DEPTH
layout(set = SET_INPUTS, binding = INPUT_DEPTH) uniform PIXEL_IMAGE depth_buffer;
#endif
shared uint kept[TRIM_WORDS];

// A triangle whose corners share one of the first six is off screen.
const uint OUTSIDE_LEFT = 1u, OUTSIDE_RIGHT = 2u, OUTSIDE_TOP = 4u, OUTSIDE_BOTTOM = 8u, OUTSIDE_NEAR = 16u,
           OUTSIDE_FAR = 32u;
// Behind the camera, or so far off that single precision does not tell where: its triangles are kept.
const uint UNKNOWN_PLACE = 64u;
const float farthest = 16384.0; // pixels from the picture's corner
// Pixels that a vertex may be off where the device sees it, and from a pixel's centre to its samples.
float margin = exp2(-float(subpixel_bits)) + 1.0 / 128.0;
float reach = samples > 1 ? 0.5 : 0.0;

struct View {
    mat4 clip;   // object space → clip space
    vec4 error;  // rounding in clip space, ours and the device's
};

struct Corner {
    vec2 place;  // pixels
    float depth;
    uint outside;
};

View view_of(ObjectData object, vec3 largest) {
    mat4 world = transpose(mat4(object.world_row[0], object.world_row[1], object.world_row[2], vec4(0, 0, 0, 1)));
    View view;
    view.clip = frame.clip_from_world * world;
    mat4 size = mat4(abs(frame.clip_from_world[0]), abs(frame.clip_from_world[1]), abs(frame.clip_from_world[2]),
                     abs(frame.clip_from_world[3])) *
                mat4(abs(world[0]), abs(world[1]), abs(world[2]), abs(world[3]));
    view.error = 4e-7 * (size * vec4(largest, 1.0));
    return view;
}

Corner corner_at(View view, uint vertex) {
    vec4 p = view.clip * vec4(positions[3u * vertex], positions[3u * vertex + 1u], positions[3u * vertex + 2u], 1.0);
    vec2 slack = view.error.xy + 2.0 * view.error.w, half_size = 0.5 * raster.size.xy;
    vec2 beyond = 1.0 + 1e-4 + margin / half_size;
    float rounding = 1e-4 * (abs(p.z) + abs(p.w)) + view.error.z + view.error.w;
    uint outside = (p.x < -p.w * beyond.x - slack.x ? OUTSIDE_LEFT : 0u) |
                   (p.x > p.w * beyond.x + slack.x ? OUTSIDE_RIGHT : 0u) |
                   (p.y < -p.w * beyond.y - slack.y ? OUTSIDE_TOP : 0u) |
                   (p.y > p.w * beyond.y + slack.y ? OUTSIDE_BOTTOM : 0u) |
                   (p.z > p.w + rounding ? OUTSIDE_NEAR : 0u) | (p.z < -rounding ? OUTSIDE_FAR : 0u);
    vec2 place = half_size + half_size * p.xy / p.w;
    bool exact = max(slack.x * half_size.x, slack.y * half_size.y) * 256.0 < p.w; // to a 256th of a pixel
    bool known = exact && p.w > 1e-6 && abs(place.x) < farthest && abs(place.y) < farthest;
    return Corner(known ? place : vec2(0), p.z / p.w, known ? outside : outside | UNKNOWN_PLACE);
}

// Twice the signed area, positive when clockwise on a screen whose y points down.
float turn(vec2 a, vec2 b, vec2 c) { return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y); }

// ≥ 0 on the triangle's side of an edge; both ends may be off by the margin, and so may the sum's rounding be; a sample
// by its reach.
vec3 edge(vec2 from, vec2 to, float side) {
    float a = -side * (to.y - from.y), b = side * (to.x - from.x);
    float size = abs(a) + abs(b), room = 2.0 * margin * (size + margin + 2.0 * reach) + reach * size;
    return vec3(a, b, room - (a * from.x + b * from.y));
}

#ifdef BY_DEPTH
const int most_pixels = 16;
#else
const int most_pixels = 6;
#endif

#ifdef BY_DEPTH
// Of a pixel's samples.
float farthest_depth(ivec2 pixel) {
    float farthest = 1.0;
    EACH_SAMPLE
        farthest = min(farthest, pixel_read(depth_buffer, pixel).r);
    return farthest;
}
#endif

// Whether the triangle may have one of the pixels from `first` to `last`; by depth, whether one of them shows nothing
// that is nearer than `nearest`.
bool covers(vec2 a, vec2 b, vec2 c, ivec2 first, ivec2 last, float nearest) {
    float side = turn(a, b, c) < 0.0 ? -1.0 : 1.0;
    vec3 ab = edge(a, b, side), bc = edge(b, c, side), ca = edge(c, a, side);
    ivec2 size = last - first + 1;
    int pixels = size.x * size.y, i = 0;
    bool any_inside = false;
    do { // loops that are left at their end: see light_list.comp
        ivec2 pixel = first + ivec2(i % size.x, i / size.x);
        vec3 centre = vec3(vec2(pixel) + 0.5, 1.0);
        bool inside = dot(ab, centre) >= 0.0 && dot(bc, centre) >= 0.0 && dot(ca, centre) >= 0.0;
#ifdef BY_DEPTH
        inside = inside && farthest_depth(clamp(pixel, ivec2(0), last_pixel())) <= nearest;
#endif
        any_inside = any_inside || inside;
    } while (++i < pixels);
    return any_inside;
}

bool may_show(View view, uint state, uvec3 vertices) {
    Corner a = corner_at(view, vertices.x), b = corner_at(view, vertices.y), c = corner_at(view, vertices.z);
    bool known = ((a.outside | b.outside | c.outside) & UNKNOWN_PLACE) == 0u;
    bool off = (a.outside & b.outside & c.outside & ~UNKNOWN_PLACE) != 0u;
    vec2 low = min(a.place, min(b.place, c.place)), high = max(a.place, max(b.place, c.place));
    float area = turn(a.place, b.place, c.place), around = high.x - low.x + high.y - low.y;
    // Fronts are counter-clockwise in the picture, and clockwise where the object is mirrored.
    float facing = (state & TRIM_MIRRORED) != 0u ? 1.0 : -1.0;
    bool away = (state & TRIM_DOUBLE_SIDED) == 0u && facing * area < -2.0 * margin * (around + margin);
    // The pixels whose centres lie in the box around it.
    float around_it = margin + reach;
    ivec2 first = ivec2(ceil(low - around_it - 0.5)), last = ivec2(floor(high + around_it - 0.5));
    bool none = any(greaterThan(first, last));
    int pixels = (last.x - first.x + 1) * (last.y - first.y + 1);
    if (off || (known && (away || none)))
        return false;
    float nearest = 3e38;
#ifdef BY_DEPTH
    // A thin triangle's depth is not known between its corners: the device's gradient may be anything. Others' are
    // off by their gradient's rounding, and 1/1000 is kept for the rest.
    float most = max(a.depth, max(b.depth, c.depth)), least = min(a.depth, min(b.depth, c.depth));
    float sure_area = abs(area) - 4.0 * margin * (around + margin);
    float rounding = 2.5e-7 * max(raster.size.x, raster.size.y) * (most - least) * around / sure_area;
    nearest = sure_area > 0.0 && least >= 0.0 && most <= 1.0 ? most * 1.001 + rounding : nearest;
#endif
    return !known || pixels > most_pixels || covers(a.place, b.place, c.place, first, last, nearest);
}

void main() {
    uint me = gl_LocalInvocationIndex, group = group_index();
    TrimGroup work = trim_groups[min(group, groups - 1u)];
    TrimDraw draw = trim_draws[work.draw];
    uvec2 range = source_of(draw, work.draw);
    View view = view_of(objects[work.draw], draw.largest.xyz);
    if (me < TRIM_WORDS)
        kept[me] = 0u;
    barrier();
    uint t = me;
    do {
        uint triangle = work.first + t, at = range.x + 3u * triangle;
        if (3u * triangle + 2u < range.y) {
            uvec3 vertices = uvec3(source[at], source[at + 1u], source[at + 2u]) + draw.state.x;
            if (may_show(view, draw.state.y, vertices))
                atomicOr(kept[t / 32u], 1u << (t % 32u)); // a set: in whatever order they come
        }
        t += TRIM_THREADS;
    } while (t < TRIM_TRIANGLES);
    barrier();
    if (group < groups && me < TRIM_WORDS)
        masks[group].bits[me] = kept[me];
    if (group < groups && me == 0u) {
        uint count = 0u;
        for (int w = 0; w < TRIM_WORDS; ++w)
            count += uint(bitCount(kept[w]));
        masks[group].count = count;
    }
}
