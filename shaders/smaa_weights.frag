#version 460
#extension GL_GOOGLE_include_directive : require
// SMAA's second pass (Jimenez, Echevarria, Sousa and Gutierrez 2012, "Pattern handling"): how long the line is that an
// edge is part of, and what crosses its ends; from a table (smaa_tables.cpp) how much the two pixels at the edge take
// of each other. Diagonals go before rows and columns; where a line ends at a corner, little is rounded. Edges are
// fetched one by one, as bits: the paper's search texture, which takes filtered fetches apart, has nothing to do here.
// Loops end with their condition: a software device runs a body once more for no pixel when it stands in front.
#include "shared/pixel_reads.glsl"
#include "shared/smaa.h"

layout(set = SET_INPUTS, binding = INPUT_SMAA_EDGES) uniform PIXEL_IMAGE edge_buffer;
layout(set = SET_INPUTS, binding = INPUT_SMAA_AREAS, std430) readonly buffer AreaBlock { uint areas[]; };
// Of the edge above: what this pixel takes of the other one, and that of this; the same of the edge at the left. Codes
// 0 … 127 for 0 … 0.5, and 128 more on a diagonal.
layout(location = 0) out vec4 out_weights;

const float corner_rounding = 0.25;  // of the weights, how much stays at a corner

int edges_in(ivec2 inside) { return int(pixel_read(edge_buffer, inside).r * 255.0 + 0.5); }
int edges_at(ivec2 at) {
    ivec2 inside = clamp(at, ivec2(0), last_pixel());
    return at == inside ? edges_in(inside) : 0;
}

vec2 areas_at(int index) { return unpackUnorm2x16(areas[index]); }

// A line of edges along `way`, as seen in a row: `across` leads over it, from this pixel to the other. Bits: `own` is
// the line's; `near` and `far` cross it where a pixel begins, on this side and on the other.
struct Line {
    ivec2 way, across;
    int own, near, far;
};

// How many pixels of `limit` the line goes on after `at`, or before it, until it ends or something crosses it. `edges`:
// of `at`, and then of the last pixel.
int search(Line line, ivec2 at, int step, int limit, inout int edges) {
    int found = 0, crossings = line.near | line.far;
    bool on = limit > 0;
    do {
        int next = edges_in(at + (on ? step * (found + 1) : 0) * line.way);
        on = on && (next & line.own) != 0 && ((step > 0 ? next : edges) & crossings) == 0;
        edges = on ? next : edges;
        found += on ? 1 : 0;
        on = on && found < limit;
    } while (on);
    return found;
}

int crossings_of(Line line, int edges) {
    return ((edges & line.far) != 0 ? SMAA_CROSSING_ABOVE : 0) + ((edges & line.near) != 0 ? SMAA_CROSSING_BELOW : 0);
}

// How much of both weights a corner at this end of the line takes: there what crosses goes on for a pixel more.
vec2 corner_share(Line line, ivec2 corner) {
    return vec2(edges_at(corner - line.across) & line.near, edges_at(corner + line.across) & line.far);
}

vec2 line_weights(Line line, ivec2 at, int edges, int pixels_before, int pixels_after) {
    int first_edges = edges, last_edges = edges;
    int left = search(line, at, -1, min(SMAA_REACH, pixels_before), first_edges);
    int right = search(line, at, 1, min(SMAA_REACH, pixels_after), last_edges);
    ivec2 first = at - left * line.way, last = at + (right + 1) * line.way;
    int before = crossings_of(line, first_edges), after = crossings_of(line, edges_at(last));
    // At the nearer end: that is a corner, not a step.
    vec2 rounded = vec2(0.0);
    if (left <= right)
        rounded += min(corner_share(line, first), 1.0);
    if (right <= left)
        rounded += min(corner_share(line, last), 1.0);
    rounded *= (1.0 - corner_rounding) * (left == right ? 0.5 : 1.0);
    return areas_at(smaa_area_index(before, after, left, right)) * (1.0 - rounded);
}

// Steps of the staircase beyond the edge above `at`, to the `right` (1) or left (−1), down (1) or up (−1): each is an
// edge along a column and one along a row. `crossings`: of its end, none where that is out of reach.
int steps(ivec2 at, int right, int down, int edges, out int crossings) {
    ivec2 way = ivec2(right, down), room = mix(at, last_pixel() - at, greaterThan(way, ivec2(0)));
    int limit = min(SMAA_DIAGONAL_REACH, min(room.x, room.y)), found = 0;
    int column = (right > 0) == (down > 0) ? SMAA_LEFT_OF_UPPER : SMAA_LEFT;  // of the next pixel, or of this one
    bool on = limit > 0;
    do {
        int next = edges_in(at + (on ? found + 1 : 0) * way);
        on = on && (next & SMAA_ABOVE) != 0 && ((right > 0 ? next : edges) & column) != 0;
        edges = on ? next : edges;
        found += on ? 1 : 0;
        on = on && found < limit;
    } while (on);
    if (right > 0) {
        int beside = edges_at(at + found * way + ivec2(1, 0));
        crossings = ((beside & SMAA_ABOVE) != 0 ? SMAA_CROSSING_LEVEL : 0) +
                    ((beside & (down > 0 ? SMAA_LEFT : SMAA_LEFT_OF_UPPER)) != 0 ? SMAA_CROSSING_UPRIGHT : 0);
    } else {
        crossings = ((edges & SMAA_ABOVE_BEFORE) != 0 ? SMAA_CROSSING_LEVEL : 0) +
                    ((edges & column) != 0 ? SMAA_CROSSING_UPRIGHT : 0);
    }
    crossings = found < SMAA_DIAGONAL_REACH ? crossings : 0;
    return found;
}

// `rises`: from below left to above right. Adds to `weights`; whether there is such a diagonal.
bool add_diagonal(ivec2 at, bool rises, int edges, inout vec2 weights) {
    int down = rises ? 1 : -1;  // to the left
    int before, after, left = steps(at, -1, down, edges, before), right = steps(at, 1, -down, edges, after);
    // Four steps are seven edges; so are three between columns.
    bool is_diagonal = left + right + 1 >= ((before & after & SMAA_CROSSING_UPRIGHT) != 0 ? 3 : 4);
    vec2 found = is_diagonal ? areas_at(smaa_diagonal_index(before, after, left, right)) : vec2(0.0);
    weights += rises ? found : found.yx;
    return is_diagonal;
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy), after = last_pixel() - at;
    int edges = edges_in(at);
    vec4 codes = vec4(0.0);
    if ((edges & SMAA_ABOVE) != 0) {
        vec2 weights = vec2(0.0);
        bool rises = add_diagonal(at, true, edges, weights), falls = add_diagonal(at, false, edges, weights);
        if (!rises && !falls) {
            Line row = Line(ivec2(1, 0), ivec2(0, -1), SMAA_ABOVE, SMAA_LEFT, SMAA_LEFT_OF_UPPER);
            weights = line_weights(row, at, edges, at.x, after.x);
        }
        codes.xy = round(min(weights, 0.5) * 254.0) + (rises || falls ? 128.0 : 0.0);
    }
    if ((edges & SMAA_LEFT) != 0) {
        Line column = Line(ivec2(0, 1), ivec2(-1, 0), SMAA_LEFT, SMAA_ABOVE, SMAA_ABOVE_BEFORE);
        codes.zw = round(line_weights(column, at, edges, at.y, after.y) * 254.0);
    }
    out_weights = codes / 255.0;
}
