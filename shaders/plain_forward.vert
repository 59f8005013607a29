#version 460
#extension GL_GOOGLE_include_directive : require
// variants: TEXTURED
// The baseline's vertices: what the fragment shader reads and no more.
#include "shared/vertex.glsl"

#ifdef TEXTURED
layout(location = VERTEX_TEXCOORD_0) in vec2 in_texcoord_0;
layout(location = VERTEX_TEXCOORD_1) in vec2 in_texcoord_1;
layout(location = 1) out vec4 out_texcoords;
#endif
layout(location = VERTEX_COLOUR) in vec4 in_colour;
layout(location = 0) out vec4 out_colour;

void main() {
    vertex_position();
    out_colour = in_colour;
#ifdef TEXTURED
    out_texcoords = vec4(in_texcoord_0, in_texcoord_1);
#endif
}
