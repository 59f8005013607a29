#version 460
#extension GL_GOOGLE_include_directive : require
// variants: GRID_CELLS|SAMPLES
// The lights of each cell, out of those of its coarse cell, in the order of light_order: counted, or
// written where light_lists_offsets.comp has made room. One invocation a cell; all invocations of a workgroup
// walk the same lights, so that each loads another one and hands it to its neighbours.
#include "shared/light_cells.glsl"
#include "shared/shared_bounds.glsl"
#extension GL_KHR_shader_subgroup_vote : require

layout(constant_id = CONSTANT_LIST_FILL) const bool fill = false;

layout(local_size_x = LIST_GROUP) in;

// Number of lights in the piece; writes them from `to` on. Without `wanted` none, but the invocation must come.
uint visit(LightCell coarse, bool wanted, LightCell cell, Piece piece, uint to) {
    uint count = 0u, begin = 0u;
    wanted = wanted && coarse.count > 0u;
    do { // loops that are left at their end: see light_list.comp
        SharedBounds own = load_bounds(coarse, begin);
        uint some = min(gl_SubgroupSize, coarse.count - begin), lane = 0u;
        do {
            SharedBounds light = shared_bounds(own, lane);
            if (reaches(light, cell, piece) && wanted) {
                if (fill)
                    light_entries[to + count] = light.light;
                ++count;
            }
        } while (++lane < some);
        begin += gl_SubgroupSize;
    } while (begin < coarse.count);
    return count;
}

// A driver may end loops after many turns (LightRounds). A cell whose slices together would take more has one list for all of
// its depths instead; of a subgroup all cells or none, for its invocations walk together.
bool one_list(uint slices, uint candidates) {
    uint most = 0u;
    while (most < LIST_SLICES && subgroupAny(uint(bitCount(slices)) > most))
        ++most;
    return sliced && most > 1u && most * (candidates + candidates / 4u + 4u) > lists.round.y;
}

void main() {
    uvec3 at = cell_at(gl_WorkGroupID, gl_LocalInvocationIndex);
    bool inside = all(lessThan(at, lists.cells.xyz));
    at = min(at, lists.cells.xyz - 1u);
    LightCell coarse = coarse_cells[index_in(gl_WorkGroupID, lists.coarse.xyz)];
    uint index = index_in(at, lists.cells.xyz);
    LightCell cell = light_cells[index];
    uint slices = fill ? cell.slices : slices_in_use(at, cell);
    if (!inside)
        slices = 0u;
    bool whole = fill ? sliced && slices == 0u && inside && cell.count > 0u && cell.first != lists.lights.x
                      : one_list(slices, coarse.count);
    if (whole)
        slices = fill || slices != 0u ? 1u : 0u; // to be visited once
    uint used = sliced && !whole ? uint(bitCount(slices)) : 0u; // places for the ends of lists
    uint count = used, end = 0u;
    uint left = slices;
    do {
        Piece piece = cell_piece(at, cell, min(uint(findLSB(left)), LIST_SLICES - 1u), whole);
        count += visit(coarse, left != 0u, cell, piece, cell.first + count);
        if (fill && sliced && !whole && left != 0u)
            light_entries[cell.first + end] = count;
        ++end;
        left &= left - 1u;
    } while (sliced && subgroupAny(left != 0u));
    if (!fill && inside) {
        light_cells[index].slices = whole ? 0u : slices;
        light_cells[index].count = count;
    }
}
