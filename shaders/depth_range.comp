#version 460
#extension GL_GOOGLE_include_directive : require
// The nearest and the farthest surface of each tile [V6].
#include "shared/light_cells.glsl"

layout(local_size_x = LIST_GROUP) in;

void main() {
    uvec3 at = cell_at(gl_WorkGroupID, gl_LocalInvocationIndex);
    if (any(greaterThanEqual(at, lists.cells.xyz)))
        return;
    at = min(at, lists.cells.xyz - 1u);
    ivec2 low = ivec2(at.xy) * tile_size;
    ivec2 high = min(low + tile_size, ivec2(frame.size.xy));
    float least = 3e38, most = 0.0; // stored depth
    for (int y = low.y; y < high.y; ++y)
        for (int x = low.x; x < high.x; ++x) {
            float stored = read_depth(ivec2(x, y));
            least = min(least, stored > 0.0 ? stored : 3e38);
            most = max(most, stored);
        }
    LightCell cell = LightCell(1.0, 0.0, 0u, 0u, 0u);
    if (most > 0.0) {
        cell.nearest = linear_depth ? least : view_depth(most);
        cell.farthest = linear_depth ? most : view_depth(least);
    }
    light_cells[index_in(at, lists.cells.xyz)] = cell;
}
