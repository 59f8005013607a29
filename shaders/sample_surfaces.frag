#version 460
#extension GL_GOOGLE_include_directive : require
// variants: ROUGHNESS_TARGET|DEFERRED_TARGET
// One surface a pixel out of its samples, which lights see as if there were no others: where the samples share a
// surface, that under the pixel's centre, for depth is linear over a triangle and the standard sample locations have
// their mean there; else that of the first sample that has one. Normals are never averaged. And whether the pixel is an
// edge: its samples do not share a surface (after Lauritzen 2010, who compares normals, and depth with its slope).
#define SAMPLES
#include "shared/gbuffer.glsl"

layout(constant_id = CONSTANT_EVERY_EDGE) const bool every_pixel = false; // is an edge, where a surface is
layout(location = 0) out vec4 out_normal;
layout(location = 1) out uint out_edge;
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
bool alike(vec4 a, vec4 b) { return all(lessThanEqual(abs(a - b), max(abs(a), vec4(0.25)) / 128.0)); }
#endif

const float least_cosine = 0.99, most_roughness = 0.05, most_slope = 10.0; // as docs/anti-aliasing.md has them

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int first = -1;
    bool all = true;
    float sum = 0.0;
    for (pixel_sample = samples - 1; pixel_sample >= 0; --pixel_sample) {
        float stored = pixel_read(depth_buffer, pixel).r;
        first = stored > 0.0 ? pixel_sample : first;
        all = all && stored > 0.0;
        sum += stored;
    }
    pixel_sample = max(first, 0);
    float own = pixel_read(depth_buffer, pixel).r, z = view_depth(max(own, 1e-30));
    vec3 n = read_normal(pixel), world;
    float roughness = read_roughness(pixel);
    read_position(pixel, world);
    out_normal = pixel_read(normal_buffer, pixel);
#ifdef ROUGHNESS_TARGET
    out_roughness = roughness;
#endif
#ifdef DEFERRED_TARGET
    out_light = pixel_read(own_light, pixel);
    out_material = pixel_read(material_buffer, pixel);
    out_albedo = pixel_read(albedo_buffer, pixel);
#endif
    float nv = max(abs(dot(n, to_viewer(world))), 1e-9);
    float slope = min(sqrt(max(1.0 - nv * nv, 0.0)) / nv, most_slope);
    float most_depth = pixel_metres(z) * (1.0 + 2.0 * slope);
    bool shared_surface = all;
    EACH_SAMPLE {
        float there = view_depth(max(pixel_read(depth_buffer, pixel).r, 1e-30));
        shared_surface = shared_surface && abs(there - z) <= most_depth && dot(read_normal(pixel), n) >= least_cosine &&
                         abs(read_roughness(pixel) - roughness) <= most_roughness;
#ifdef DEFERRED_TARGET
        shared_surface = shared_surface && alike(out_albedo, pixel_read(albedo_buffer, pixel)) &&
                         alike(out_light, pixel_read(own_light, pixel)) &&
                         abs(out_material.b - pixel_read(material_buffer, pixel).b) <= 1.0 / 128.0;
#endif
    }
    gl_FragDepth = shared_surface ? sum / float(samples) : own;
    out_edge = first >= 0 && (every_pixel || !shared_surface) ? 1u : 0u;
}
