#version 460
#extension GL_GOOGLE_include_directive : require
// The alpha mask, for a depth-only pass [Z1]; the passes after it rely on depth.
#include "shared/surface.glsl"

void main() {
    if (base_colour().a < material.emissive.w)
        discard;
}
