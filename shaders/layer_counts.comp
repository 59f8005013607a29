#version 460
#extension GL_GOOGLE_include_directive : require
// variants: SAMPLES
// The largest number of layers in a picture and their sum.
#include "shared/layer_counts.h"
#include "shared/pixel_reads.glsl"

layout(local_size_x = LAYER_COUNT_GROUP, local_size_y = LAYER_COUNT_GROUP) in;
layout(push_constant) uniform CountingBlock { LayerCounting counting; };
layout(set = SET_INPUTS, binding = INPUT_COLOUR) uniform PIXEL_IMAGE layer_counts;
layout(set = SET_INPUTS, binding = INPUT_LAYER_COUNTS, std430) buffer CountBlock { LayerCounts result; };

shared uint most, total, more;

void main() {
    if (gl_LocalInvocationIndex == 0u)
        most = total = more = 0u;
    barrier();
    uint own_most = 0u, own_total = 0u, own_more = 0u;
    ivec2 first = ivec2(gl_GlobalInvocationID.xy) * LAYER_COUNT_BLOCK;
    for (int i = 0; i < LAYER_COUNT_BLOCK * LAYER_COUNT_BLOCK; ++i) {
        ivec2 pixel = first + ivec2(i % LAYER_COUNT_BLOCK, i / LAYER_COUNT_BLOCK);
        bool inside = all(lessThan(uvec2(pixel), counting.size));
        EACH_SAMPLE {
            uint layers = inside ? uint(pixel_read(layer_counts, min(pixel, last_pixel())).r) : 0u;
            own_most = max(own_most, layers);
            own_total += layers;
            own_more += layers - min(layers, counting.exact);
        }
    }
    atomicMax(most, own_most);
    atomicAdd(total, own_total);
    atomicAdd(more, own_more);
    barrier();
    if (gl_LocalInvocationIndex != 0u || total == 0u)
        return;
    atomicMax(result.most, most);
    // No sum of a group comes near 32 bits.
    uint before = atomicAdd(result.total_low, total);
    if (before + total < before)
        atomicAdd(result.total_high, 1u);
    before = atomicAdd(result.more_low, more);
    if (before + more < before)
        atomicAdd(result.more_high, 1u);
}
