#version 460
#extension GL_GOOGLE_include_directive : require
// variants: OWN_MATERIAL
// materials: all with OWN_MATERIAL
// The alpha mask, for a depth-only pass; the passes after it rely on depth.
#include "shared/material_interface.glsl"

void main() {
    Point p = point();
    if (is_masked(surface(p)))
        discard;
}
