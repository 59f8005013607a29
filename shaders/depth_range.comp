#version 460
#extension GL_GOOGLE_include_directive : require
// variants: SAMPLES
// The nearest and the farthest surface of each tile, and the depths that its surfaces have. A tile of a coarse
// cell that no light reaches is as good as one without surfaces: where lights are few, most depths need not be read.
#include "shared/light_cells.glsl"
#extension GL_KHR_shader_subgroup_vote : require

layout(constant_id = CONSTANT_AMBIENT_TOO) const bool ambient_too = false; // light everywhere
layout(local_size_x = LIST_GROUP) in;

// More lights than these reach almost everything, and looking at them takes its time too.
const uint few_lights = 64u;

bool may_be_lit() {
    bool few = !ambient_too && lists.lights.x == 0u && lists.lights.y <= few_lights;
    uint count = few ? lists.lights.y : 0u, begin = 0u;
    bool reached = !few;
    do { // left at its end: see light_list.comp
        uint index = begin + gl_SubgroupInvocationID;
        ivec3 low, high;
        light_extent(bounds_of(lights[light_order[lists.round.x + min(index, max(count, 1u) - 1u)]]), low, high);
        ivec3 at = ivec3(gl_WorkGroupID);
        reached = reached || (index < count && all(lessThanEqual(low, at)) && all(lessThanEqual(at, high)));
        begin += gl_SubgroupSize;
    } while (begin < count);
    return subgroupAny(reached);
}

void main() {
    bool lit = may_be_lit();
    int rows = lit ? tile_size : 1;
    uvec3 at = cell_at(gl_WorkGroupID, gl_LocalInvocationIndex);
    if (any(greaterThanEqual(at, lists.cells.xyz)))
        return;
    at = min(at, lists.cells.xyz - 1u);
    ivec2 low = ivec2(at.xy) * tile_size, last = last_pixel();
    float least = 3e38, most = 0.0; // stored depth
    uint depths = 0u;
    // Loops that are left at their end: see light_list.comp.
    int y = 0;
    do {
        int x = 0;
        do {
            EACH_SAMPLE {
                float stored = read_depth(min(low + ivec2(x, y), last));
                least = min(least, stored > 0.0 ? stored : 3e38);
                most = max(most, stored);
                depths |= stored > 0.0 ? depth_bit(stored) : 0u;
            }
        } while (++x < tile_size);
    } while (++y < rows);
    LightCell cell = LightCell(1.0, 0.0, lit ? depths : 0u, 0u, 0u, 0u);
    if (lit && most > 0.0) {
        cell.nearest = linear_depth ? least : view_depth(most);
        cell.farthest = linear_depth ? most : view_depth(least);
    }
    light_cells[index_in(at, lists.cells.xyz)] = cell;
}
