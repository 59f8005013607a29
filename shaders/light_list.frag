#version 460
#extension GL_GOOGLE_include_directive : require
// variants: ONE_TARGET|COUNT_TARGET|DEFERRED_TARGET, SHADOWS, STENCIL_ROUGHNESS|SAMPLES
// never: COUNT_TARGET SHADOWS, DEFERRED_TARGET STENCIL_ROUGHNESS, SAMPLES COUNT_TARGET
// All lights of a pixel's tile or cluster, summed and written once.
#include "shared/light_sums.glsl"
#include "shared/light_lists.glsl"
#include "shared/light_slices.glsl"
#ifdef SAMPLES
#include "shared/edge_reads.glsl"
#endif

layout(constant_id = CONSTANT_LIST_TILE_SIZE) const int tile_size = 16;

layout(early_fragment_tests) in;

void main() {
#ifdef SAMPLES
    ivec2 pixel = edge_pixel_of_fragment();
    if (pixel.x < 0)
        discard;
#else
    ivec2 pixel = ivec2(gl_FragCoord.xy);
#endif
    uvec2 tile = min(uvec2(pixel) / uint(tile_size), lists.cells.xy - 1u); // helper invocations lie outside
    uint slice = sliced ? slice_of(read_depth(pixel)) : 0u;
    LightList list = list_of(tile.y * lists.cells.x + tile.x, slice);
    LitPixel p = read_pixel(pixel);
    LightSums sums = no_light();
#if defined(DEFERRED_TARGET) && defined(SAMPLES)
    first_round = lists.round.z == 0u;
#endif
    uint contributing = 0u;
    for (uint i = 0u; i < list.count; ++i)
        contributing += add_light(sums, p, light_source(light_at(listed_light(list, i)))) ? 1u : 0u;
    count_lights(pixel, list.count, contributing);
    write_sums(pixel, sums);
}
