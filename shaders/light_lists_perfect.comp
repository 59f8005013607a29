#version 460
#extension GL_GOOGLE_include_directive : require
// variants: STENCIL_ROUGHNESS
// For measuring: leaves in each tile's list only lights that contribute to one of its pixels at least, or none at
// all. One invocation a tile and, while lights are marked that do not, a few of its lights; slow, and not part of any
// frame that is timed.
#include "shared/lit_pixel.glsl"
#define LIGHT_LISTS_ACCESS
#include "shared/light_lists.glsl"

layout(constant_id = CONSTANT_LIST_TILE_SIZE) const int tile_size = 16;
layout(constant_id = CONSTANT_LIST_TRIM) const int trim = LIST_TRIM_MARK;
layout(constant_id = CONSTANT_LIST_TRIM_LIGHTS) const uint some = 1u;
layout(local_size_x = LIST_GROUP) in;

const uint no_light = 0xffffffffu;

bool contributes(uvec2 tile, LightSource source) {
    ivec2 low = ivec2(tile) * tile_size, high = min(low + tile_size, ivec2(raster.size.xy));
    for (int y = low.y; y < high.y; ++y)
        for (int x = low.x; x < high.x; ++x)
            if (light_terms(source, read_pixel(ivec2(x, y)).point).contributes)
                return true;
    return false;
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= lists.cells.w)
        return;
    LightCell cell = light_cells[index];
    if (trim == LIST_TRIM_EMPTY) {
        light_cells[index].count = 0u;
        return;
    }
    if (cell.first == lists.lights.x)
        return; // did not fit: all lights
    if (trim == LIST_TRIM_MARK) {
        uint begin = min(gl_GlobalInvocationID.y * some, cell.count), end = min(begin + some, cell.count);
        for (uint i = begin; i < end; ++i)
            if (!contributes(uvec2(index % lists.cells.x, index / lists.cells.x), light_source(lights[light_entries[cell.first + i]])))
                light_entries[cell.first + i] = no_light;
        return;
    }
    uint kept = 0u;
    for (uint i = 0u; i < cell.count; ++i) {
        uint light = light_entries[cell.first + i];
        if (light != no_light) {
            light_entries[cell.first + kept] = light;
            ++kept;
        }
    }
    light_cells[index].count = kept;
}
