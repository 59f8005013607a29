#version 460
#extension GL_EXT_samplerless_texture_functions : require
// Whole numbers below 4096 that tell which three images were read, each at this place (modulo its
// size), and how; exact in 32-bit floats.
layout(push_constant) uniform Push { vec4 constant; } push;
layout(set = 0, binding = 0) uniform texture2D a;
layout(set = 0, binding = 1) uniform texture2D b;
layout(set = 0, binding = 2) uniform texture2D c;
layout(location = 0) out float result;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float sum = texelFetch(a, pixel % textureSize(a, 0), 0).r +
                3.0 * texelFetch(b, pixel % textureSize(b, 0), 0).r +
                5.0 * texelFetch(c, pixel % textureSize(c, 0), 0).r + push.constant.x;
    result = sum - 4096.0 * floor(sum / 4096.0);
}
