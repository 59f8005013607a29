#version 460
#extension GL_GOOGLE_include_directive : require
// Each light marks the coarse cells that it may reach, and is counted there. Marks are bits, so the order in which
// invocations set them does not matter.
#include "shared/light_cells.glsl"

layout(local_size_x = LIST_GROUP) in;

void main() {
    uint index = gl_GlobalInvocationID.x;
    uint all = lists.lights.x + lists.lights.y;
    if (index >= all)
        return;
    index = min(index, all - 1u);
    uint light_index = light_order[index];
    light_entries[index] = light_index;
    if (index < lists.lights.x)
        return;
    uint bit = index - min(index, lists.lights.x);
    LightBounds light = bounds_of(lights[light_index]);
    uint depths = depths_of(light);
    ivec3 low, high;
    light_extent(light, low, high);
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) {
                uvec3 at = uvec3(x, y, z);
                uint coarse = index_in(at, lists.coarse.xyz);
                LightCell cell = coarse_cells[coarse];
                if (!holds_depths(cell, depths) || !touches(coarse_piece(at, cell), light))
                    continue;
                uint start = mask_start(coarse);
                atomicOr(light_masks[start + bit / 1024u], 1u << (bit / 32u & 31u));
                atomicOr(light_masks[start + summary_words() + bit / 32u], 1u << (bit & 31u));
                atomicAdd(coarse_cells[coarse].count, 1u);
            }
}
