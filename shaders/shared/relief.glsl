// Height maps and detail normals: what a material's surface() does to a point before textures are read.
#ifndef PRELIGHT_RELIEF_GLSL
#define PRELIGHT_RELIEF_GLSL
#include "shared/material_interface.glsl"

// The tangent of the texture at a MATERIAL_… binding, w the bitangent's sign: the vertices', or where it reads other
// coordinates than these follow (another set or transform), how its own run over the triangle. Before anything
// moves p.texcoords.
vec4 tangent_of(Point p, int binding) {
    vec4 place = material.uv_offset[binding - 1];
    if (place.w > 0.5)
        return p.tangent;
    vec2 uv = transformed(binding, place.z > 0.5 ? p.texcoords.zw : p.texcoords.xy);
    vec2 ux = dFdx(uv), uy = dFdy(uv);
    vec3 px = dFdx(p.position), py = dFdy(p.position), n = gl_FrontFacing ? p.normal : -p.normal;
    float turn = ux.x * uy.y - uy.x * ux.y < 0.0 ? -1.0 : 1.0;
    vec3 along_u = (px * uy.y - py * ux.y) * turn, along_v = (py * ux.x - px * uy.x) * turn;
    along_u -= n * dot(n, along_u);
    float size = length(along_u);
    return size > 0.0 ? vec4(along_u / size, dot(cross(n, along_u), along_v) > 0.0 ? -1.0 : 1.0) : p.tangent;
}

// The way to the viewer in tangent space: x, y along the texture, z off the surface.
vec3 viewer_in_tangent_space(Point p, vec4 tangent) {
    vec3 t = normalize(tangent.xyz);
    float side = gl_FrontFacing ? 1.0 : -1.0;
    vec3 b = cross(p.normal * side, t) * tangent.w;
    return vec3(dot(t, p.to_viewer), dot(b, p.to_viewer), max(dot(p.normal, p.to_viewer), 0.05));
}

// Texture coordinates where the texture at a MATERIAL_… binding has moved by `shift` on the surface, and every other
// texture with it: a set moves as its coordinates run over the triangle.
vec4 moved_texcoords(Point p, int binding, vec2 shift) {
    vec4 columns = material.uv_linear[binding - 1];
    mat2 linear = mat2(columns.xy, columns.zw);
    bool second = material.uv_offset[binding - 1].z > 0.5;
    vec4 tx = dFdx(p.texcoords), ty = dFdy(p.texcoords);
    mat2 own = second ? mat2(tx.zw, ty.zw) : mat2(tx.xy, ty.xy), other = second ? mat2(tx.xy, ty.xy) : mat2(tx.zw, ty.zw);
    if (determinant(linear) == 0.0)
        return p.texcoords;
    vec2 moved = inverse(linear) * shift;
    vec2 follows = determinant(own) == 0.0 ? vec2(0.0) : other * (inverse(own) * moved);
    return p.texcoords + (second ? vec4(follows, moved) : vec4(moved, follows));
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

// A detail normal's slopes on top of a base normal, each in the tangent space of its own texture: slopes add up
// (Barre-Brisebois and Hill, "Blending in Detail", 2012, their UDN form). Unit, facing the viewer.
vec3 with_detail(Point p, vec3 base, vec4 tangent, vec2 slopes) {
    vec3 n = gl_FrontFacing ? p.normal : -p.normal, t = normalize(p.tangent.xyz), along = normalize(tangent.xyz);
    vec3 bent = t * base.x + cross(n, t) * (p.tangent.w * base.y) + n * base.z;
    bent = normalize(bent + along * slopes.x + cross(n, along) * (tangent.w * slopes.y));
    return gl_FrontFacing ? bent : -bent;
}
#endif
