#version 460
#extension GL_GOOGLE_include_directive : require
// variants: GRID_CELLS
// The marks of each coarse cell as a list of lights, in the order of light_order. One invocation a coarse cell.
#include "shared/light_cells.glsl"

layout(local_size_x = LIST_GROUP) in;

void main() {
    uint coarse = gl_GlobalInvocationID.x;
    if (coarse >= lists.coarse.w)
        return;
    LightCell cell = coarse_cells[coarse];
    if (cell.first == lists.lights.x)
        return; // all lights: a list did not fit
    uint start = mask_start(coarse), to = cell.first;
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
                light_entries[to] = light_entries[lists.lights.x + index];
                ++to;
            }
        }
    }
}
