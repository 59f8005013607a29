#version 460
#extension GL_GOOGLE_include_directive : require
// SMAA's second pass (Jimenez, Echevarria, Sousa and Gutierrez 2012): how long the line is that an edge is part of, and what
// crosses its ends; from a table (smaa_tables.cpp) how much the two pixels at the edge take of each other. Diagonals go before
// rows and columns (section 4.2); where a line ends at a corner, little is rounded (section 4.3). Edges are fetched one by one,
// as bits: the paper's search texture, which takes filtered fetches apart, has nothing to do here.
#include "shared/pixel_reads.glsl"
#include "shared/smaa.h"

layout(set = SET_INPUTS, binding = INPUT_SMAA_EDGES) uniform PIXEL_IMAGE edge_buffer;
layout(set = SET_INPUTS, binding = INPUT_SMAA_AREAS, std430) readonly buffer AreaBlock { uint areas[]; };
// Of the edge above: what this pixel takes of the other one, and that of this; the same of the edge at the left. Codes 0 … 127
// for 0 … 0.5, and 128 more on a diagonal.
layout(location = 0) out vec4 out_weights;

const float corner_rounding = 0.25;  // of the weights, how much stays at a corner

// Bit 0: left, bit 1: above.
int edges_at(ivec2 at) {
    bool outside = any(lessThan(at, ivec2(0))) || any(greaterThan(at, last_pixel()));
    return outside ? 0 : int(pixel_read(edge_buffer, at).r * 255.0 + 0.5);
}
bool left_of(ivec2 at) { return (edges_at(at) & 1) != 0; }
bool above(ivec2 at) { return (edges_at(at) & 2) != 0; }

vec2 areas_at(int index) { return unpackUnorm2x16(areas[index]); }

// An edge along `way` as seen in a row: `across` leads over it, from this pixel to the other. `own` is its bit, `crossing` that
// of what crosses it.
struct Line {
    ivec2 way, across;
    int own, crossing;
};

bool has(ivec2 at, int bit) { return (edges_at(at) & bit) != 0; }

// Pixels that the line goes on beyond `at`, before or after it: until it ends, or something crosses it.
int search(Line line, ivec2 at, bool after) {
    int found = 0;
    while (found < SMAA_REACH) {
        ivec2 next = at + (after ? found + 1 : -found - 1) * line.way, corner = after ? next : next + line.way;
        bool crossed = has(corner, line.crossing) || has(corner + line.across, line.crossing);
        if (crossed || !has(next, line.own))
            break;
        ++found;
    }
    return found;
}

int crossings_at(Line line, ivec2 corner) {
    return (has(corner + line.across, line.crossing) ? SMAA_CROSSING_ABOVE : 0) +
           (has(corner, line.crossing) ? SMAA_CROSSING_BELOW : 0);
}

// How much is left of both weights where the nearer end goes on across for a pixel more: that is a corner, not a step.
vec2 corner_factor(Line line, ivec2 first, ivec2 last, int left, int right) {
    vec2 factor = vec2(1.0);
    float share = (1.0 - corner_rounding) * (left == right ? 0.5 : 1.0);
    for (int i = 0; i < 2; ++i) {
        ivec2 corner = i == 0 ? first : last;
        if (i == 0 ? left <= right : right <= left)
            factor -= share * vec2(has(corner - line.across, line.crossing), has(corner + 2 * line.across, line.crossing));
    }
    return max(factor, 0.0);
}

vec2 line_weights(Line line, ivec2 at) {
    int left = search(line, at, false), right = search(line, at, true);
    ivec2 first = at - left * line.way, last = at + (right + 1) * line.way;
    return areas_at(smaa_area_index(crossings_at(line, first), crossings_at(line, last), left, right)) *
           corner_factor(line, first, last, left, right);
}

// Steps of the staircase beyond the edge above `at`, to the `right` (1) or left (−1), up (−1) or down (1): each is an edge along
// a column and one along a row. `ends`: whether it ended within reach.
int steps(ivec2 at, int right, int down, out bool ends) {
    int found = 0;
    ends = false;
    while (found < SMAA_DIAGONAL_REACH && !ends) {
        // The column that the last row's edge ends at, and the pixel row that the step goes through.
        ivec2 corner = at + ivec2(right * found + (right > 0 ? 1 : 0), down * found + (down > 0 ? 0 : -1));
        ends = !left_of(corner) || !above(at + (found + 1) * ivec2(right, down));
        found += ends ? 0 : 1;
    }
    return found;
}

int diagonal_crossings(ivec2 at, int right, int down) {
    ivec2 corner = at + ivec2(right > 0 ? 1 : 0, down > 0 ? 0 : -1);
    return (above(at + ivec2(right, 0)) ? SMAA_CROSSING_LEVEL : 0) + (left_of(corner) ? SMAA_CROSSING_UPRIGHT : 0);
}

// `rises`: from below left to above right. Adds to `weights`; whether there is such a diagonal.
bool add_diagonal(ivec2 at, bool rises, inout vec2 weights) {
    int down = rises ? 1 : -1;  // to the left
    bool starts, ends;
    int left = steps(at, -1, down, starts), right = steps(at, 1, -down, ends);
    if (left + right < 3)
        return false;
    int before = starts ? diagonal_crossings(at + left * ivec2(-1, down), -1, down) : 0;
    int after = ends ? diagonal_crossings(at + right * ivec2(1, -down), 1, -down) : 0;
    vec2 found = areas_at(smaa_diagonal_index(before, after, left, right));
    weights += rises ? found : found.yx;
    return true;
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    int edges = edges_at(at);
    vec4 codes = vec4(0.0);
    // Loops: a software device runs both sides of an `if`, but no round of a loop that nobody wants.
    for (bool once = (edges & 2) != 0; once; once = false) {
        vec2 weights = vec2(0.0);
        bool rising = add_diagonal(at, true, weights), falling = add_diagonal(at, false, weights), diagonal = rising || falling;
        for (bool row = !diagonal; row; row = false)
            weights = line_weights(Line(ivec2(1, 0), ivec2(0, -1), 2, 1), at);
        codes.xy = round(min(weights, 0.5) * 254.0) + (diagonal ? 128.0 : 0.0);
    }
    for (bool once = (edges & 1) != 0; once; once = false)
        codes.zw = round(line_weights(Line(ivec2(0, 1), ivec2(-1, 0), 1, 2), at) * 254.0);
    out_weights = codes / 255.0;
}
