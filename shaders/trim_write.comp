#version 460
#extension GL_GOOGLE_include_directive : require
// Writes the indices of a group's kept triangles behind those of the draw's groups before it, so that they stand in
// the order of the source; the draw's last group writes its command.
#include "shared/trimming.glsl"

layout(set = SET_INPUTS, binding = INPUT_TRIM_MASKS, std430) readonly buffer MaskBlock { TrimMask masks[]; };
layout(set = SET_INPUTS, binding = INPUT_TRIM_INDICES, std430) writeonly buffer IndexBlock { uint indices[]; };
layout(set = SET_INPUTS, binding = INPUT_TRIM_COMMANDS, std430) writeonly buffer CommandBlock { IndexedCommand commands[]; };
layout(set = SET_INPUTS, binding = INPUT_TRIM_COUNTS, std430) writeonly buffer CountBlock { uint counts[]; };
shared uint before[TRIM_THREADS];
shared uint bits[TRIM_WORDS + 1]; // one more: shaderc would take the storage buffer's type, which has a layout, for an equal one

void main() {
    uint me = gl_LocalInvocationIndex, group = group_index();
    TrimGroup work = trim_groups[min(group, groups - 1u)];
    TrimDraw draw = trim_draws[work.draw];
    uvec2 range = source_of(draw, work.draw);
    uint sum = 0u;
    for (uint g = draw.indices.w + me; g < group; g += TRIM_THREADS)
        sum += masks[g].count;
    before[me] = sum;
    if (me < TRIM_WORDS)
        bits[me] = masks[min(group, groups - 1u)].bits[me];
    barrier();
    if (group >= groups)
        return;
    uint first = 0u; // triangle of the output, from the draw's first
    for (int i = 0; i < TRIM_THREADS; ++i)
        first += before[i];
    uint t = me, word = 0u, under = 0u; // `under`: kept ones in the words before
    do {
        while (word < t / 32u)
            under += uint(bitCount(bits[word++]));
        uint bit = 1u << (t % 32u);
        if ((bits[word] & bit) != 0u) {
            uint from = range.x + 3u * (work.first + t);
            uint to = draw.indices.z + 3u * (first + under + uint(bitCount(bits[word] & (bit - 1u))));
            indices[to] = source[from];
            indices[to + 1u] = source[from + 1u];
            indices[to + 2u] = source[from + 2u];
        }
        t += TRIM_THREADS;
    } while (t < TRIM_TRIANGLES);
    if (me == 0u && work.first + TRIM_TRIANGLES >= draw.indices.y / 3u) { // the draw's last group
        uint count = 3u * (first + masks[group].count);
        commands[work.draw] = IndexedCommand(count, 1u, draw.indices.z, int(draw.state.x), work.draw);
        counts[work.draw] = count;
    }
}
