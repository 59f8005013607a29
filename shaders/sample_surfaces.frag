#version 460
#extension GL_GOOGLE_include_directive : require
// variants: ROUGHNESS_TARGET|DEFERRED_TARGET
// One surface a pixel out of its samples, which lights see as if there were no others: where the samples share a
// surface, that under the pixel's centre, for depth is linear over a triangle and the standard sample locations have
// their mean there; else that of the first sample that has one. Normals are never averaged. And which of the samples
// share a surface, where not all do: the pixel is an edge then (after Lauritzen 2010, who compares normals, and depth
// with its slope).
#define SAMPLES
#include "shared/gbuffer.glsl"

layout(constant_id = CONSTANT_EVERY_EDGE) const bool every_pixel = false; // is an edge, where a surface is
layout(location = 0) out vec4 out_normal;
layout(location = 1) out uvec4 out_edge; // as shared/edge_samples.glsl reads it
#ifdef ROUGHNESS_TARGET
layout(location = 2) out float out_roughness;
#endif
#ifdef DEFERRED_TARGET // the rest of a G-buffer, whose samples share a surface only where it is of one colour, too
layout(set = SET_INPUTS, binding = INPUT_COLOUR_BEFORE) uniform PIXEL_IMAGE own_light;   // RT0
layout(set = SET_INPUTS, binding = INPUT_MATERIAL) uniform PIXEL_IMAGE material_buffer;  // RT2
layout(set = SET_INPUTS, binding = INPUT_ALBEDO) uniform PIXEL_IMAGE albedo_buffer;      // RT3
layout(location = 2) out vec4 out_light;
layout(location = 3) out vec4 out_material;
layout(location = 4) out vec4 out_albedo;

// Half a code of eight bits is not seen.
bool alike(vec4 a, vec4 b) { return all(lessThanEqual(abs(a - b), max(abs(a), vec4(0.02)) / 128.0)); }
#endif

const float least_cosine = 0.99, most_roughness = 0.05, most_slope = 10.0; // as docs/anti-aliasing.md has them

// A sample as it is stored, fetched once. Samples are named one by one below: a software device keeps arrays in memory.
struct Stored {
    float depth; // device depth; 0: nothing is there
    vec4 normal; // of the normal buffer
#ifdef ROUGHNESS_TARGET
    float roughness;
#endif
#ifdef DEFERRED_TARGET
    vec4 light, material, albedo;
#endif
};

Stored fetch(ivec2 pixel, int i) {
    pixel_sample = min(i, samples - 1);
    Stored s;
    s.depth = i < samples ? pixel_read(depth_buffer, pixel).r : 0.0;
    s.normal = pixel_read(normal_buffer, pixel);
#ifdef ROUGHNESS_TARGET
    s.roughness = pixel_read(roughness_buffer, pixel).r;
#endif
#ifdef DEFERRED_TARGET
    s.light = pixel_read(own_light, pixel);
    s.material = pixel_read(material_buffer, pixel);
    s.albedo = pixel_read(albedo_buffer, pixel);
#endif
    return s;
}

// Of one fragment, as far as all but depth can tell.
bool same(Stored a, Stored b) {
    bool equal = a.normal == b.normal;
#ifdef ROUGHNESS_TARGET
    equal = equal && a.roughness == b.roughness;
#endif
#ifdef DEFERRED_TARGET
    equal = equal && a.light == b.light && a.material == b.material && a.albedo == b.albedo;
#endif
    return equal;
}

// What lights see of it.
struct Seen {
    Stored stored;
    bool there;
    float z; // view depth
    vec3 normal;
    float roughness;
    float within; // metres that depth may change by within a pixel: much on steep surfaces
    uint number;  // of its surface among those of the pixel; 3 where there is none, for then there are three at most
};

float depth_of(Stored s) { return view_depth(max(s.depth, 1e-30)); }

// All but `within`, of a sample at view depth `z`.
Seen seen_of(Stored s, float z) {
    Seen seen;
    seen.stored = s;
    seen.there = s.depth > 0.0;
    seen.z = z;
    seen.normal = stored_normal(s.normal);
#ifdef ROUGHNESS_TARGET
    seen.roughness = s.roughness;
#else
    seen.roughness = roughness_decode(s.normal.a);
#endif
    seen.within = 0.0;
    seen.number = 3u;
    return seen;
}

float within(Seen seen, vec3 viewer) {
    float nv = max(abs(dot(seen.normal, viewer)), 1e-9);
    return pixel_metres(seen.z) * (1.0 + 2.0 * min(sqrt(max(1.0 - nv * nv, 0.0)) / nv, most_slope));
}

bool share_surface(Seen a, Seen b, float cosine, float roughness) {
    bool alike_to_lights = a.there && b.there && abs(a.z - b.z) <= a.within && dot(a.normal, b.normal) >= cosine &&
                           abs(a.roughness - b.roughness) <= roughness * a.roughness; // smooth ones: sharp highlights
#ifdef DEFERRED_TARGET
    return alike_to_lights && alike(a.stored.albedo, b.stored.albedo) && alike(a.stored.light, b.stored.light) &&
           abs(a.stored.material.b - b.stored.material.b) <= 1.0 / 128.0;
#else
    return alike_to_lights;
#endif
}

// Whether the pixel is no edge, as far as these two can tell.
bool are_one(Seen a, Seen b) { return share_surface(a, b, least_cosine, most_roughness); }
// At an edge, only samples that are as good as of one fragment share their light: of a round object's outline each
// triangle is another shade.
bool share_light(Seen a, Seen b) {
#ifdef DEFERRED_TARGET
    if (a.stored.light != b.stored.light || a.stored.material != b.stored.material || a.stored.albedo != b.stored.albedo)
        return false;
#endif
    return share_surface(a, b, 0.9995, 0.01);
}

// The next surface, unless the sample shares one.
void number(inout Seen seen, uint known, inout uint surfaces) {
    seen.number = !seen.there ? 3u : known < 3u ? known : surfaces;
    surfaces += seen.there && known == 3u ? 1u : 0u;
}

uint known(bool shares, Seen with, uint otherwise) { return shares ? with.number : otherwise; }

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 clip = clip_of(vec2(pixel) + 0.5);
    vec3 viewer = to_viewer(clip.x * frame.ray_right.xyz + clip.y * frame.ray_up.xyz + frame.forward.xyz);
    Stored p = fetch(pixel, 0), q = fetch(pixel, 1), r = fetch(pixel, 2), s = fetch(pixel, 3);
    bool four = samples == 4;
    bool all_there = min(p.depth, q.depth) > 0.0 && (!four || min(r.depth, s.depth) > 0.0);
    bool none_there = max(max(p.depth, q.depth), max(r.depth, s.depth)) <= 0.0;
    Seen a = seen_of(p, depth_of(p));
    a.within = within(a, viewer);
    vec3 z = vec3(depth_of(q), four ? vec2(depth_of(r), depth_of(s)) : vec2(a.z)), away = abs(z - a.z);
    bool all_share = all_there && same(p, q) && (!four || (same(p, r) && same(p, s))) && all(lessThanEqual(away, vec3(a.within)));
    uint edge = 0u;
    Stored own = p; // the first that shows something
    if (!all_share && !none_there) {
        Seen b = seen_of(q, z.x), c = seen_of(r, z.y), d = seen_of(s, z.z);
        all_share = all_there && are_one(a, b) && (!four || (are_one(a, c) && are_one(a, d)));
        b.within = within(b, viewer);
        c.within = within(c, viewer);
        uint surfaces = 0u;
        number(a, 3u, surfaces);
        number(b, known(share_light(a, b), a, 3u), surfaces);
        number(c, known(share_light(a, c), a, known(share_light(b, c), b, 3u)), surfaces);
        number(d, known(share_light(a, d), a, known(share_light(b, d), b, known(share_light(c, d), c, 3u))), surfaces);
        if (!all_share && !a.there)
            own = b.there ? q : c.there ? r : s;
        edge = all_share ? 0u : a.number | b.number << 2 | c.number << 4 | d.number << 6 | surfaces << 8;
    }
    out_normal = own.normal;
#ifdef ROUGHNESS_TARGET
    out_roughness = own.roughness;
#endif
#ifdef DEFERRED_TARGET
    out_light = own.light;
    out_material = own.material;
    out_albedo = own.albedo;
#endif
    gl_FragDepth = all_share ? (p.depth + q.depth + r.depth + s.depth) / float(samples) : own.depth;
    uint each = 0xe4u | uint(samples) << 8; // 3, 2, 1, 0: a surface a sample
    out_edge = uvec4(every_pixel && !none_there ? each : edge, 0u, 0u, 0u);
}
