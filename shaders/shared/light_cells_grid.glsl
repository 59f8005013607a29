// Cells of light lists in the world: a uniform grid over the world's bounds. A coarse cell is
// 4 × 4 × 4 cells.
#ifndef PRELIGHT_LIGHT_CELLS_GRID_GLSL
#define PRELIGHT_LIGHT_CELLS_GRID_GLSL
#include "shared/light_bounds.glsl"
#include "shared/sliced.glsl"

Piece grid_piece(vec3 low, vec3 size) {
    Piece p;
    p.u = vec3(1.0, 0.0, 0.0);
    p.v = vec3(0.0, 1.0, 0.0);
    p.w = vec3(0.0, 0.0, 1.0);
    // A pixel's position is rounded, and with it the choice of its cell.
    vec3 slack = 1e-5 * (size + abs(low));
    p.middle = low.xy + 0.5 * size.xy;
    p.half_size = 0.5 * size.xy + slack.xy;
    p.slope = vec2(0.0);
    p.low = low.z - slack.z;
    p.high = low.z + size.z + slack.z;
    return p;
}

// The coarse cells that the box around the light's sphere meets.
void light_extent(LightBounds light, out ivec3 low, out ivec3 high) {
    vec3 size = lists.grid_cell.xyz * float(LIST_COARSE_CELLS);
    vec3 centre = light.centre - lists.grid_origin.xyz;
    vec3 most = vec3(lists.coarse.xyz);
    low = ivec3(clamp(floor((centre - light.radius) / size - 0.01), vec3(0.0), most));
    high = ivec3(clamp(floor((centre + light.radius) / size + 0.01), vec3(-1.0), most - 1.0));
}

bool may_reach_coarse(uvec3 at, LightCell cell, LightBounds light) {
    vec3 size = lists.grid_cell.xyz * float(LIST_COARSE_CELLS);
    return touches(grid_piece(lists.grid_origin.xyz + vec3(at) * size, size), light);
}

uint depths_of(LightBounds light) { return 0u; }
bool holds_depths(LightCell cell, uint depths) { return true; }

// The cell of an invocation; a workgroup is a coarse cell.
uvec3 cell_at(uvec3 group, uint invocation) {
    return group * LIST_COARSE_CELLS + uvec3(invocation % LIST_COARSE_CELLS, invocation / LIST_COARSE_CELLS % LIST_COARSE_CELLS,
                                             invocation / (LIST_COARSE_CELLS * LIST_COARSE_CELLS));
}

uint slices_in_use(uvec3 at, LightCell cell) { return 1u; }

Piece cell_piece(uvec3 at, LightCell cell, uint slice, bool whole) {
    return grid_piece(lists.grid_origin.xyz + vec3(at) * lists.grid_cell.xyz, lists.grid_cell.xyz);
}
#endif
