#version 460
#extension GL_GOOGLE_include_directive : require
// A decal's box.
#include "shared/decal.h"
#include "shared/frame.glsl"

layout(push_constant) uniform DecalBlock { DecalConstants decal; };

void main() {
    // Two triangles a side, counter-clockwise from outside; bits: x, y, z.
    const uint corners[36] = uint[](0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                    2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5);
    uint c = corners[gl_VertexIndex];
    vec4 corner = vec4(vec3(c & 1u, c >> 1u & 1u, c >> 2u) - 0.5, 1.0);
    vec3 world = vec3(dot(decal.world_row[0], corner), dot(decal.world_row[1], corner), dot(decal.world_row[2], corner));
    gl_Position = frame.clip_from_world * vec4(world, 1.0);
    // Seen from inside no depth is tested, and neither the near nor the far plane may cut the box.
    if (decal.fade.w > 0.5)
        gl_Position.z = 0.5 * gl_Position.w;
}
