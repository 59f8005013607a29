// What the invocations of a subgroup know, handed to each other: software devices load one lane after another,
// and shuffle all at once. Every invocation of the subgroup must come.
#ifndef PRELIGHT_LIGHT_SHARE_GLSL
#define PRELIGHT_LIGHT_SHARE_GLSL
#extension GL_KHR_shader_subgroup_shuffle : require

vec2 shuffled(vec2 v, uint lane) { return vec2(subgroupShuffle(v.x, lane), subgroupShuffle(v.y, lane)); }
vec3 shuffled(vec3 v, uint lane) { return vec3(shuffled(v.xy, lane), subgroupShuffle(v.z, lane)); }
vec4 shuffled(vec4 v, uint lane) { return vec4(shuffled(v.xy, lane), shuffled(v.zw, lane)); }

// Over the subgroup, in log2(size) steps; the same in every invocation.
vec3 shared_sum(vec3 v) {
    uint bit = 1u;
    do
        v += shuffled(v, gl_SubgroupInvocationID ^ bit);
    while ((bit *= 2u) < gl_SubgroupSize);
    return v;
}
vec3 shared_min(vec3 v) {
    uint bit = 1u;
    do
        v = min(v, shuffled(v, gl_SubgroupInvocationID ^ bit));
    while ((bit *= 2u) < gl_SubgroupSize);
    return v;
}
uvec2 shared_or(uvec2 v) {
    uint bit = 1u;
    do
        v |= uvec2(subgroupShuffle(v.x, gl_SubgroupInvocationID ^ bit), subgroupShuffle(v.y, gl_SubgroupInvocationID ^ bit));
    while ((bit *= 2u) < gl_SubgroupSize);
    return v;
}
#endif
