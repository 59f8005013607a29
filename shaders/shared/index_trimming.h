// What index trimming on the device works on: src/resident/device_trimming.hpp.
#ifndef PRELIGHT_INDEX_TRIMMING_H
#define PRELIGHT_INDEX_TRIMMING_H
#include "shared/interop.h"

#define TRIM_THREADS 64
#define TRIM_ROW 4096  // workgroups in a row
#define TRIM_WORDS 8                     // of 32 triangles, a bit each
#define TRIM_TRIANGLES (TRIM_WORDS * 32) // of a group
#define TRIM_MIRRORED 1u
#define TRIM_DOUBLE_SIDED 2u
SHARED_BEGIN

// One visible object; its place in the buffer is that of its ObjectData and of its command.
struct TrimDraw {
    uvec4 indices;  // first index and their number in the source; first index in the output; the first of its groups
    uvec4 state;    // x: vertex offset, y: TRIM_… bits
    vec4 largest;   // xyz: the largest |coordinate| of its vertices, object space
};

// The triangles that one workgroup tests.
struct TrimGroup {
    uint draw;
    uint first;  // triangle of the draw
};

// What it found.
struct TrimMask {
    uint count;
    uint bits[TRIM_WORDS];
};

// VkDrawIndexedIndirectCommand
struct IndexedCommand {
    uint index_count;
    uint instance_count;
    uint first_index;
    int vertex_offset;
    uint first_instance;
};

SHARED_END
#endif
