#version 460
#extension GL_GOOGLE_include_directive : require
// SMAA's third pass: each pixel mixed with its neighbours, in linear light, by what smaa_weights.frag found.
#include "shared/displayed.glsl"
#include "shared/pixel_reads.glsl"

layout(set = SET_INPUTS, binding = INPUT_COLOUR_BEFORE) uniform PIXEL_IMAGE picture;
layout(set = SET_INPUTS, binding = INPUT_SMAA_WEIGHTS) uniform PIXEL_IMAGE weight_buffer;
layout(location = 0) out vec4 out_colour;

vec4 codes_at(ivec2 at) {
    bool outside = any(greaterThan(at, last_pixel()));
    return outside ? vec4(0.0) : round(pixel_read(weight_buffer, at) * 255.0);
}

vec4 linear_at(ivec2 at) { return displayed_linear(pixel_read(picture, clamp(at, ivec2(0), last_pixel()))); }

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    const ivec2 right = ivec2(1, 0), down = ivec2(0, 1);
    vec4 own = codes_at(at), colour = pixel_read(picture, at);
    vec2 rows = vec2(own.x, codes_at(at + down).y);  // of the pixels above and below
    vec2 columns = vec2(own.z, codes_at(at + right).w);  // of those at the left and at the right
    // A diagonal counts before all else, even where it takes nothing of this pixel.
    bvec2 diagonal = greaterThanEqual(rows, vec2(128.0));
    if (any(diagonal)) {
        rows = mix(vec2(0.0), rows - 128.0, diagonal);
        columns = vec2(0.0);
    }
    bool by_columns = max(columns.x, columns.y) > max(rows.x, rows.y);
    vec2 weights = (by_columns ? columns : rows) / 254.0;
    ivec2 way = by_columns ? right : down;
    float sum = weights.x + weights.y;
    if (sum > 0.0) {
        vec4 here = linear_at(at);
        vec4 first = mix(here, linear_at(at - way), weights.x), second = mix(here, linear_at(at + way), weights.y);
        colour = displayed_stored((weights.x * first + weights.y * second) / sum);
    }
    out_colour = colour;
}
