#version 460
#extension GL_GOOGLE_include_directive : require
// variants: SHADOW_TILE, FACING
// Position and nothing else.
#include "shared/vertex.glsl"

void main() { vertex_position(); }
