// Light of a lower resolution as a pixel sees it: the discontinuity-sensitive filter of inferred lighting (Kircher and
// Lawrance, "Inferred Lighting", SIGGRAPH Game Papers 2009). Of the four texels around a pixel those count that show the
// pixel's own surface. docs/inferred.md has the rules; src/reference has them once more.
#ifndef PRELIGHT_INFERRED_LIGHT_GLSL
#define PRELIGHT_INFERRED_LIGHT_GLSL
#include "shared/pixel_reads.glsl"
#ifdef LAYER
#include "shared/layer.h"
layout(push_constant) uniform LayerBlock { LayerConstants layer; };
#endif

layout(set = SET_INPUTS, binding = INPUT_SURFACE_IDS) uniform ONE_SAMPLE_IMAGE_BITS surface_ids;
layout(set = SET_INPUTS, binding = INPUT_LIGHT_DEPTH) uniform ONE_SAMPLE_IMAGE light_depth;
layout(set = SET_INPUTS, binding = INPUT_UNMATCHED, std430) buffer UnmatchedBlock { uint unmatched_pixels; };
layout(location = 6) flat in uvec2 in_surface;

// Texels of the light's resolution and their shares, which sum up to 1.
struct Taps {
    ivec2 at[4];
    float share[4];
    bool unmatched;  // none of the four shows the pixel's surface
};

// Without a share as large as this a surface counts as missing.
const float least_share = 1e-3;

Taps find_taps() {
    ivec2 low_size = textureSize(surface_ids, 0), last = low_size - 1;
    vec2 ratio = vec2(low_size) / raster.size.xy;
    vec2 place = gl_FragCoord.xy * ratio - 0.5;  // texels
#ifdef LAYER  // every second texel of every second row is the layer's
    ivec2 first = ivec2(layer.slot & 1u, layer.slot >> 1);
    const int step = 2;
#else
    const ivec2 first = ivec2(0);
    const int step = 1;
#endif
    ivec2 last_step = max((last - first) / step, ivec2(0));
    vec2 steps = (place - vec2(first)) / float(step), low = floor(steps), share = steps - low;

    // Device depth is linear on a plane over the screen. Texels count that are off the pixel's plane by no more than half
    // of what depth changes from one to the next, and the width of one.
    float depth = gl_FragCoord.z;
    vec2 slope = vec2(dFdx(depth), dFdy(depth)) / ratio;  // from texel to texel
    float texel = 2.0 * length(frame.ray_up.xyz) / float(low_size.y) * (frame.forward.w > 0.5 ? depth + frame.depth.x : frame.depth.x);
    float most = (0.5 * (abs(slope.x) + abs(slope.y)) + texel) * float(step);

    Taps taps;
    float plain[4], total = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = ivec2(i & 1, i >> 1);
        vec2 side = mix(1.0 - share, share, vec2(corner));
        plain[i] = side.x * side.y;
        taps.at[i] = min(first + step * clamp(ivec2(low) + corner, ivec2(0), last_step), last);
        bool same = one_sample_read(surface_ids, taps.at[i]).rg == in_surface;
        float off = one_sample_read(light_depth, taps.at[i]).r - depth - dot(slope, vec2(taps.at[i]) - place);
        taps.share[i] = same && abs(off) <= most ? plain[i] : 0.0;
        total += taps.share[i];
    }
    taps.unmatched = total < least_share;
    for (int i = 0; i < 4; ++i)
        taps.share[i] = taps.unmatched ? plain[i] : taps.share[i] / total;
    // Of the texels around it that show the same object, the one that is nearest, in depth above all; where there is
    // none, whatever light there is.
    if (taps.unmatched) {
        ivec2 middle = ivec2(floor(place + 0.5)), found = ivec2(-1);
        float least = 3e38;
        for (int i = 0; i < 9; ++i) {
            ivec2 at = clamp(middle + ivec2(i % 3, i / 3) - 1, ivec2(0), last);
            vec2 away = vec2(at) - place;
            // The last term tells texels apart that are as far.
            float score = abs(one_sample_read(light_depth, at).r - depth) / texel + dot(away, away) + 0.01 * float(i);
            if (one_sample_read(surface_ids, at).r == in_surface.r && score < least) {
                least = score;
                found = at;
            }
        }
        if (found.x >= 0) {
            taps.at[0] = found;
            taps.share = float[4](1.0, 0.0, 0.0, 0.0);
        }
    }
    return taps;
}

// Adds the pixel to those that found no texel of their surface.
void count_unmatched(Taps taps) {
    if (taps.unmatched)
        atomicAdd(unmatched_pixels, 1u);
}
#endif
