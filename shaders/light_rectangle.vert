#version 460
#extension GL_GOOGLE_include_directive : require
// The rectangle that a light's volume covers on the screen, one instance a light, at the volume's
// near or far side.
#include "shared/frame.glsl"

layout(constant_id = CONSTANT_RECTANGLE_FAR_SIDE) const bool far_side = false;
layout(location = 0) flat out uint out_light;

void main() {
    out_light = light_order[gl_InstanceIndex];
    LightScreenBounds bounds = light_bounds[gl_InstanceIndex];
    // Two triangles: corners 0 1 2, 2 1 3.
    int corner = gl_VertexIndex < 3 ? gl_VertexIndex : gl_VertexIndex == 3 ? 2 : gl_VertexIndex == 4 ? 1 : 3;
    vec2 place = mix(bounds.rectangle.xy, bounds.rectangle.zw, vec2(corner & 1, corner >> 1));
    gl_Position = vec4(place, far_side ? bounds.depth.y : bounds.depth.x, 1.0);
}
