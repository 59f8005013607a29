// What the passes that build light lists share. Where the cells lie is the business of
// light_cells_screen.glsl or light_cells_grid.glsl.
#ifndef PRELIGHT_LIGHT_CELLS_GLSL
#define PRELIGHT_LIGHT_CELLS_GLSL
#include "shared/bindings.h"
#include "shared/light_lists.h"

layout(push_constant) uniform ListBlock { LightListConstants lists; };
#ifdef GRID_CELLS
#include "shared/light_cells_grid.glsl"
#else
#include "shared/light_cells_screen.glsl"
#endif

layout(set = SET_INPUTS, binding = INPUT_LIGHT_CELLS, std430) buffer CellBlock { LightCell light_cells[]; };
layout(set = SET_INPUTS, binding = INPUT_LIGHT_ENTRIES, std430) buffer EntryBlock { uint light_entries[]; };
layout(set = SET_INPUTS, binding = INPUT_COARSE_CELLS, std430) buffer CoarseBlock { LightCell coarse_cells[]; };
// For each coarse cell a bit for each light that may reach it: words of 32 lights, after words of 32
// bits that say which of those words are not 0.
layout(set = SET_INPUTS, binding = INPUT_LIGHT_MASKS, std430) buffer MaskBlock { uint light_masks[]; };

uint light_words() { return (lists.lights.y + 31u) / 32u; }
uint summary_words() { return (light_words() + 31u) / 32u; }
uint mask_start(uint coarse) { return coarse * lists.lights.w; }

// SwiftShader reads for invocations that have returned or left a loop too: every index that is read
// stays within its buffer.
uint index_in(uvec3 at, uvec3 size) { return (at.z * size.y + at.y) * size.x + at.x; }
#endif
