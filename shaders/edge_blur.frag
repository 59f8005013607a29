#version 460
#extension GL_GOOGLE_include_directive : require
// Anti-aliasing by blurring edges of geometry (Shishkovtsov, "Deferred Shading in S.T.A.L.K.E.R.", GPU Gems 2, 2005,
// chapter 9; the edge filter that Quandt's Round 2 speaks of): a weight from normals and depth, then the mean of four
// places around the pixel, as far from its centre as the weight says.
#include "shared/displayed.glsl"
#include "shared/geometry_edges.glsl"

layout(set = SET_INPUTS, binding = INPUT_COLOUR_BEFORE) uniform PIXEL_IMAGE picture;
layout(location = 0) out vec4 out_colour;

const float farthest = 0.5;  // pixels along an axis, at weight 1

float weight_at(ivec2 at) {
    float depths[9];
    for (int i = 0; i < 9; ++i)
        depths[i] = edge_depth(at + ivec2(i % 3, i / 3) - 1);
    float here = depths[4];
    float rows = depth_bend(depths[3], here, depths[5]), columns = depth_bend(depths[1], here, depths[7]);
    float diagonals = max(depth_bend(depths[0], here, depths[8]), depth_bend(depths[2], here, depths[6]));
    // At the picture's borders nobody knows how a plane goes on.
    bvec2 border = bvec2(at.x == 0 || at.x == last_pixel().x, at.y == 0 || at.y == last_pixel().y);
    float bend = max(max(border.x ? 0.0 : rows, border.y ? 0.0 : columns), any(border) ? 0.0 : diagonals);
    float weight = clamp(bend - 1.0, 0.0, 1.0);
    if (has_normals) {
        const ivec2 ways[4] = ivec2[](ivec2(0, -1), ivec2(-1, 0), ivec2(1, 0), ivec2(0, 1));
        vec3 normal = edge_normal(at);
        for (int i = 0; i < 4; ++i)
            weight = max(weight, normal_bend(normal, edge_normal(at + ways[i]), min(here, depths[2 * i + 1]) > 0.0));
    }
    return weight;
}

vec4 linear_at(ivec2 at) { return displayed_linear(pixel_read(picture, clamp(at, ivec2(0), last_pixel()))); }

// The mean of both sides and of the centre, which is what two places at `offset` from it are, between two pixels each.
vec4 across(vec4 before, vec4 here, vec4 after, float offset) {
    return (1.0 - offset) * here + 0.5 * offset * (before + after);
}

vec4 row(ivec2 at, float offset) {
    return across(linear_at(at + ivec2(-1, 0)), linear_at(at), linear_at(at + ivec2(1, 0)), offset);
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 colour = pixel_read(picture, at);
    float offset = farthest * weight_at(at);
    if (offset > 0.0) {
        vec4 upper = row(at - ivec2(0, 1), offset), lower = row(at + ivec2(0, 1), offset);
        colour = displayed_stored(across(upper, row(at, offset), lower, offset));
    }
    out_colour = colour;
}
