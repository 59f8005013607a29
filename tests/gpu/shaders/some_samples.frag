#version 460
// 1 into some of the samples of each pixel: those whose bits its column has.
layout(location = 0) out float result;

void main() {
    gl_SampleMask[0] = int(gl_FragCoord.x) & 15;
    result = 1.0;
}
