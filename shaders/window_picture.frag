#version 460
#extension GL_GOOGLE_include_directive : require
// A finished picture in a window: its bytes as they are where both are of one size, else stretched.
#include "shared/bindings.h"

layout(set = 0, binding = WINDOW_PICTURE) uniform sampler2D picture;
layout(push_constant) uniform Push {
    vec2 window; // pixels
};
layout(location = 0) out vec4 out_colour;

void main() {
    vec3 value = window == vec2(textureSize(picture, 0)) ? texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb
                                                         : textureLod(picture, gl_FragCoord.xy / window, 0.0).rgb;
    out_colour = vec4(value, 1.0);
}
