// Height maps and detail normals: what a material's surface() does to a point before textures are read.
#ifndef PRELIGHT_RELIEF_GLSL
#define PRELIGHT_RELIEF_GLSL
#include "shared/material_interface.glsl"

// The way to the viewer in tangent space: x, y along the texture, z off the surface.
vec3 viewer_in_tangent_space(Point p) {
    vec3 t = normalize(p.tangent.xyz);
    float side = gl_FrontFacing ? 1.0 : -1.0;
    vec3 b = cross(p.normal * side, t) * p.tangent.w;
    return vec3(dot(t, p.to_viewer), dot(b, p.to_viewer), max(dot(p.normal, p.to_viewer), 0.05));
}

// How texture coordinates move where the surface lies `depth` below its face, along the line of sight; v runs
// down, the bitangent up.
vec2 relief_shift(vec3 viewer, float depth) { return vec2(-viewer.x, viewer.y) / viewer.z * depth; }

// Parallax mapping (Kaneko and others 2001): one look at the height under the pixel. Height 1 is the face,
// 0 lies `scale` (in texture coordinates) below it.
vec2 parallax(sampler2D heights, vec2 place, vec3 viewer, float scale) {
    return relief_shift(viewer, (1.0 - texture(heights, place).r) * scale);
}

// Parallax occlusion mapping (Tatarchuk 2006): steps down the line of sight until it is below the surface, and
// the crossing between the last two.
vec2 parallax_occlusion(sampler2D heights, vec2 place, vec3 viewer, float scale, int steps) {
    vec2 gx = dFdx(place), gy = dFdy(place);
    float before = 1.0 - textureGrad(heights, place, gx, gy).r;
    float depth = 0.0, found = 1.0;
    bool below = false;
    for (int i = 1; i <= steps; ++i) {
        depth = float(i) / float(steps);
        float surface_depth = 1.0 - textureGrad(heights, place + relief_shift(viewer, depth * scale), gx, gy).r;
        if (!below && surface_depth <= depth) {
            float step_before = depth - 1.0 / float(steps);
            float gap = before - step_before, overlap = depth - surface_depth;
            found = step_before + gap / max(gap + overlap, 1e-6) / float(steps);
            below = true;
        }
        before = surface_depth;
    }
    return relief_shift(viewer, (below ? found : 1.0) * scale);
}

// A detail normal on top of a base normal, both in tangent space: slopes add up (Barre-Brisebois and Hill,
// "Blending in Detail", 2012, their UDN form).
vec3 with_detail(vec3 base, vec3 detail, float amount) { return vec3(base.xy + detail.xy * amount, base.z); }
#endif
