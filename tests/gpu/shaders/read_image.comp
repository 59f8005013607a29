#version 460
#extension GL_EXT_samplerless_texture_functions : require
// target[i] = the image's red channel at (i mod width, i / width), times 4 and rounded
layout(local_size_x = 64) in;
layout(set = 0, binding = 0) writeonly buffer Target { uint target[]; };
layout(set = 0, binding = 1) uniform texture2D source;
void main() {
    int i = int(gl_GlobalInvocationID.x), width = textureSize(source, 0).x;
    target[i] = uint(texelFetch(source, ivec2(i % width, i / width), 0).r * 4.0 + 0.5);
}
