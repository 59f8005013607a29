#version 460
// One for each surface, which add up to the layers of a pixel.
layout(location = 0) out float out_count;

void main() { out_count = 1.0; }
