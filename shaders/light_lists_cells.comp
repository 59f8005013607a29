#version 460
#extension GL_GOOGLE_include_directive : require
// The lights of each cell, out of those of its coarse cell, in the order of light_order: counted, or
// written where light_lists_offsets.comp has made room. One invocation a cell, whose neighbours in
// the workgroup walk the same lights.
#include "shared/light_cells.glsl"

layout(constant_id = CONSTANT_LIST_FILL) const bool fill = false;

layout(local_size_x = LIST_GROUP) in;

// Number of lights in the piece; writes them from `to` on.
uint visit(uint coarse, Piece piece, uint to) {
    uint count = 0u;
    uint start = mask_start(coarse);
    uint summary = summary_words(), last_word = max(light_words(), 1u) - 1u, last = max(lists.lights.y, 1u) - 1u;
    for (uint s = 0u; s < summary; ++s) {
        uint words = light_masks[start + s];
        while (words != 0u) {
            uint word = min(s * 32u + uint(findLSB(words)), last_word);
            words &= words - 1u;
            uint bits = light_masks[start + summary + word];
            while (bits != 0u) {
                uint index = min(word * 32u + uint(findLSB(bits)), last);
                bits &= bits - 1u;
                uint light = light_entries[lists.lights.x + index];
                if (touches(piece, bounds_of(lights[light]))) {
                    if (fill)
                        light_entries[to + count] = light;
                    ++count;
                }
            }
        }
    }
    return count;
}

void main() {
    uvec3 at = cell_at(gl_WorkGroupID, gl_LocalInvocationIndex);
    if (any(greaterThanEqual(at, lists.cells.xyz)))
        return;
    at = min(at, lists.cells.xyz - 1u);
    uint coarse = index_in(gl_WorkGroupID, lists.coarse.xyz);
    uint index = index_in(at, lists.cells.xyz);
    LightCell cell = light_cells[index];
    uint slices = fill ? cell.slices : slices_in_use(at, cell);
    uint used = sliced ? uint(bitCount(slices)) : 0u; // places for the ends of lists
    uint count = used, end = 0u;
    for (uint left = slices; left != 0u; left &= left - 1u) {
        Piece piece = cell_piece(at, cell, min(uint(findLSB(left)), LIST_SLICES - 1u));
        count += visit(coarse, piece, cell.first + count);
        if (fill && sliced)
            light_entries[cell.first + end] = count;
        ++end;
    }
    if (!fill) {
        light_cells[index].slices = slices;
        light_cells[index].count = count;
    }
}
