#version 460
#extension GL_GOOGLE_include_directive : require
// All lights of a tile [V6], summed and written once, for devices that read buffers slowly: each invocation
// of a subgroup loads another light of the list, then all of them take each in turn from their
// neighbours. A workgroup is an 8 × 8 block of one tile, an invocation `rows` of its pixels.
#define STORAGE_TARGET
#include "shared/light_sums.glsl"
#include "shared/light_lists.glsl"
#include "shared/light_share.glsl"

layout(constant_id = CONSTANT_LIST_TILE_SIZE) const int tile_size = 16;
layout(constant_id = CONSTANT_LIST_ROWS) const int rows = 8;
layout(constant_id = CONSTANT_AMBIENT_TOO) const bool ambient_too = false;
layout(local_size_x = 8, local_size_y_id = CONSTANT_LIST_GROUP_ROWS) in; // times `rows`: 8

Lamp shuffled(Lamp mine, uint lane) {
    return Lamp(shuffled(mine.position, lane), shuffled(mine.colour, lane), subgroupShuffle(mine.luminance, lane),
                subgroupShuffle(mine.inverse_range2, lane), shuffled(mine.axis, lane), shuffled(mine.cone, lane),
                subgroupShuffle(mine.shininess, lane), subgroupShuffle(mine.falloff, lane));
}

void main() {
    ivec2 first = ivec2(gl_WorkGroupID.xy) * 8 + ivec2(gl_LocalInvocationID.x, gl_LocalInvocationID.y * uint(rows));
    ivec2 last = ivec2(frame.size.xy) - 1;
    uvec2 tile = gl_WorkGroupID.xy / uint(tile_size / 8);
    LightList list = list_of(tile.y * lists.cells.x + tile.x, 0u);

    LitPixel pixels[rows];
    LightSums sums[rows];
    uint contributing[rows];
    for (int row = 0; row < rows; ++row) {
        pixels[row] = read_pixel(min(first + ivec2(0, row), last));
        sums[row] = no_light();
        contributing[row] = 0u;
        if (ambient_too)
            add_ambient(sums[row]);
    }
    for (uint begin = 0u; begin < list.count; begin += gl_SubgroupSize) {
        Lamp mine = lamp_of(lights[listed_light(list, begin + gl_SubgroupInvocationID)]);
        uint count = min(gl_SubgroupSize, list.count - begin);
        for (uint lane = 0u; lane < count; ++lane) {
            Lamp lamp = shuffled(mine, lane);
            for (int row = 0; row < rows; ++row)
                contributing[row] += add_light(sums[row], pixels[row], lamp) ? 1u : 0u;
        }
    }
    for (int row = 0; row < rows; ++row) {
        ivec2 pixel = first + ivec2(0, row);
        if (any(greaterThan(pixel, last)))
            continue;
        if (pixels[row].point.surface)
            count_lights(pixel, list.count, contributing[row]);
        write_sums(pixel, sums[row]);
    }
}
