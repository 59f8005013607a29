#version 460
#extension GL_GOOGLE_include_directive : require
// The nearest and the farthest surface of each tile, and the depths that its surfaces have [V6].
#include "shared/light_cells.glsl"

layout(local_size_x = LIST_GROUP) in;

void main() {
    uvec3 at = cell_at(gl_WorkGroupID, gl_LocalInvocationIndex);
    if (any(greaterThanEqual(at, lists.cells.xyz)))
        return;
    at = min(at, lists.cells.xyz - 1u);
    ivec2 low = ivec2(at.xy) * tile_size, last = ivec2(frame.size.xy) - 1;
    float least = 3e38, most = 0.0; // stored depth
    uint depths = 0u;
    // Loops that are left at their end: see light_list.comp.
    int y = 0;
    do {
        int x = 0;
        do {
            float stored = read_depth(min(low + ivec2(x, y), last));
            least = min(least, stored > 0.0 ? stored : 3e38);
            most = max(most, stored);
            depths |= stored > 0.0 ? depth_bit(stored) : 0u;
        } while (++x < tile_size);
    } while (++y < tile_size);
    LightCell cell = LightCell(1.0, 0.0, depths, 0u, 0u, 0u);
    if (most > 0.0) {
        cell.nearest = linear_depth ? least : view_depth(most);
        cell.farthest = linear_depth ? most : view_depth(least);
    }
    light_cells[index_in(at, lists.cells.xyz)] = cell;
}
