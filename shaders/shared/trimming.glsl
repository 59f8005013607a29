// What both shaders of index trimming read: the triangles of a group, in the order of the source.
#ifndef PRELIGHT_TRIMMING_GLSL
#define PRELIGHT_TRIMMING_GLSL
#include "shared/bindings.h"
#include "shared/index_trimming.h"

layout(constant_id = CONSTANT_TRIM_AGAIN) const bool again = false; // the source was trimmed on the device before
layout(local_size_x = TRIM_THREADS) in;
layout(push_constant) uniform TrimBlock { uint groups; };
layout(set = SET_INPUTS, binding = INPUT_TRIM_DRAWS, std430) readonly buffer DrawBlock { TrimDraw trim_draws[]; };
layout(set = SET_INPUTS, binding = INPUT_TRIM_GROUPS, std430) readonly buffer GroupBlock { TrimGroup trim_groups[]; };
layout(set = SET_INPUTS, binding = INPUT_TRIM_SOURCE, std430) readonly buffer SourceBlock { uint source[]; };
layout(set = SET_INPUTS, binding = INPUT_TRIM_SOURCE_COMMANDS, std430) readonly buffer SourceCommandBlock {
    IndexedCommand source_commands[];
};

uint group_index() { return gl_WorkGroupID.y * TRIM_ROW + gl_WorkGroupID.x; }

// The draw's first index in the source and their number.
uvec2 source_of(TrimDraw draw, uint index) {
    return again ? uvec2(draw.indices.z, source_commands[index].index_count) : draw.indices.xy;
}
#endif
