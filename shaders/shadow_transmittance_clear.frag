#version 460
// Nothing in the light's way.
layout(location = 0) out vec4 out_transmittance;

void main() { out_transmittance = vec4(1.0, 1.0, 1.0, 0.0); }
