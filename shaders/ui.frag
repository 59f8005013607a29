#version 460
#extension GL_GOOGLE_include_directive : require
// Blends in the values that are displayed, as user interfaces are designed; the result is multiplied by its alpha.
#include "shared/bindings.h"

layout(set = 0, binding = UI_TEXTURE) uniform sampler2D picture;
layout(location = 0) in vec2 texcoord;
layout(location = 1) in vec4 colour;
layout(location = 0) out vec4 out_colour;

void main() {
    vec4 value = colour * texture(picture, texcoord);
    out_colour = vec4(value.rgb * value.a, value.a);
}
