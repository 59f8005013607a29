// The one place where a vertex gets its position: `invariant`, so that depth test EQUAL is exact in
// every later pass over the same geometry.
#ifndef PRELIGHT_VERTEX_GLSL
#define PRELIGHT_VERTEX_GLSL
#include "shared/frame.glsl"

layout(location = VERTEX_POSITION) in vec3 in_position;
invariant gl_Position;

vec3 transform(ObjectData object, vec3 position) {
    vec4 p = vec4(position, 1.0);
    return vec3(dot(object.world_row[0], p), dot(object.world_row[1], p), dot(object.world_row[2], p));
}

vec3 vertex_position() {
    vec3 world = transform(objects[gl_InstanceIndex], in_position);
    gl_Position = frame.clip_from_world * vec4(world, 1.0);
    return world;
}
#endif
