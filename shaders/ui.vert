#version 460
#extension GL_GOOGLE_include_directive : require
// What lies over the picture in a window: triangles in pixels from the top left.
#include "shared/bindings.h"

layout(location = UI_POSITION) in vec2 position;
layout(location = UI_TEXCOORD) in vec2 texcoord;
layout(location = UI_COLOUR) in vec4 colour;
layout(location = 0) out vec2 out_texcoord;
layout(location = 1) out vec4 out_colour;

layout(push_constant) uniform Push {
    vec2 scale; // 2 / the window's size in the unit of positions
    vec2 offset;
};

void main() {
    out_texcoord = texcoord;
    out_colour = colour;
    gl_Position = vec4(position * scale + offset, 0.0, 1.0);
}
