#version 460
#extension GL_GOOGLE_include_directive : require
// variants: OWN_MATERIAL
// materials: all with OWN_MATERIAL
// transparency=half-samples in deferred shading: a G-buffer has no room for alpha, which stands beside the light of the
// samples that show blended surfaces.
#include "shared/half_samples.h"
#include "shared/material_interface.glsl"

layout(location = 0) out vec4 out_colour; // alpha alone is written

void main() {
    Point p = point();
    out_colour = vec4(vec3(0.0), half_samples_alpha(blended_coverage(surface(p))));
}
