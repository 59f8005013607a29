// Which lights of a list reach a point, 32 at a time: for devices that read buffers lane by lane and run all of a loop's
// body for every light. One vector of a light tells that most do not reach; only of the others the rest is read.
#ifndef PRELIGHT_REACHING_LIGHTS_GLSL
#define PRELIGHT_REACHING_LIGHTS_GLSL
#include "shared/lighting.glsl"
#include "shared/light_lists.glsl"

// light_entries, four at a time: a load of four takes as long as one of one.
layout(set = SET_INPUTS, binding = INPUT_LIGHT_ENTRIES, std430) readonly buffer EntryVectorBlock { uvec4 light_entry_vectors[]; };

// Lights stand at `next` … `end` − 1 of light_entries.
struct EntryRange {
    uint next, end;
};
bool is_empty(EntryRange range) { return range.next >= range.end; }

// Not where attenuation() or N·L is 0 by distance or side; lights without a range may.
bool may_reach(uint light, LitPoint p) {
    vec4 sphere = fetched_sphere(light);
    vec3 to_light = sphere.xyz - p.world;
    bool reaches = dot(to_light, to_light) * (sphere.w * sphere.w) < 1.0;
#ifndef TRANSMISSION // which lamps behind the surface shine through
    reaches = reaches && dot(to_light, p.n) > 0.0;
#endif
    return reaches || sphere.w == 0.0;
}

// The next lights of the range, of 29 to 32: bit i is set when the one at `first` + i may reach the point.
uint reaching_lights(inout EntryRange range, out uint first, LitPoint p) {
    const uvec4 four = uvec4(0u, 1u, 2u, 3u);
    uint bits = 0u, at = 0u;
    first = is_empty(range) ? 0u : range.next & ~3u;
    do {
        uvec4 entry = uvec4(first + at) + four;
        bvec4 within = bvec4(uvec4(greaterThanEqual(entry, uvec4(range.next))) & uvec4(lessThan(entry, uvec4(range.end))));
        uvec4 light = mix(uvec4(0u), light_entry_vectors[(first + at) / 4u], within);
        bvec4 reaches = bvec4(may_reach(light.x, p), may_reach(light.y, p), may_reach(light.z, p), may_reach(light.w, p));
        uvec4 found = (uvec4(reaches) & uvec4(within)) << four;
        bits |= (found.x | found.y | found.z | found.w) << at;
        at += 4u;
    } while (at < 32u && first + at < range.end);
    range.next = max(range.next, first + at); // of an empty range it stays
    return bits;
}
#endif
