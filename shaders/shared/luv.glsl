// CIE 1976 u′v′ chromaticity of linear Rec. 709 light, for the light buffer after Wilson (ShaderX7, 8.6):
// R, G chromaticity, B luminance, A channel 4 of equation 8.5.2.
#ifndef PRELIGHT_LUV_GLSL
#define PRELIGHT_LUV_GLSL

// The triangle of Rec. 709's primaries lies within this corner and size: stored as 0 … 1.
const vec2 luv_corner = vec2(0.12, 0.15);
const vec2 luv_size = vec2(0.34, 0.42);

const mat3 xyz_from_rgb = mat3(0.4123908, 0.2126390, 0.0193308,
                               0.3575843, 0.7151687, 0.1191948,
                               0.1804808, 0.0721923, 0.9505322);
const mat3 rgb_from_xyz = mat3(3.2409699, -0.9692436, 0.0556301,
                               -1.5373832, 1.8759675, -0.2039770,
                               -0.4986108, 0.0415551, 1.0569715);

vec2 luv_encode(vec3 rgb) {
    vec3 xyz = xyz_from_rgb * rgb;
    vec2 uv = vec2(4.0, 9.0) * xyz.xy / max(xyz.x + 15.0 * xyz.y + 3.0 * xyz.z, 1e-12);
    return clamp((uv - luv_corner) / luv_size, 0.0, 1.0);
}

// Of light with luminance 1; a chromaticity that rounding put outside the primaries' triangle is
// brought back to its edge.
vec3 luv_decode(vec2 stored) {
    vec2 uv = luv_corner + luv_size * stored;
    vec3 xyz = vec3(9.0 * uv.x, 4.0 * uv.y, 12.0 - 3.0 * uv.x - 20.0 * uv.y) / (4.0 * uv.y);
    return max(rgb_from_xyz * xyz, vec3(0.0));
}
#endif
