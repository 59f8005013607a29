// The one place where a vertex gets its position: `invariant`, so that depth test EQUAL is exact in
// every later pass over the same geometry.
#ifndef PRELIGHT_VERTEX_GLSL
#define PRELIGHT_VERTEX_GLSL
#include "shared/frame.glsl"
#ifdef SHADOW_TILE  // world is relative to the world's centre, and a light looks at it
#include "shared/shadow.h"
layout(push_constant) uniform TileBlock { ShadowTileConstants tile; };
#endif

layout(location = VERTEX_POSITION) in vec3 in_position;
// ObjectData comes as vertex attributes that step once an instance: a software device reads them once for
// all vertices, and a storage buffer vertex by vertex.
layout(location = VERTEX_WORLD_ROW) in vec4 in_world_row[3];
#ifdef FACING
layout(location = VERTEX_NORMAL) in vec3 in_facing; // metres along the viewer's right and up

// From the viewer's axes (right, up, towards the viewer) to the world's.
vec3 from_viewer(vec3 v) { return v * mat3(frame.view_from_world); }
#endif
invariant gl_Position;

vec3 vertex_position() {
    vec4 p = vec4(in_position, 1.0);
    vec3 world = vec3(dot(in_world_row[0], p), dot(in_world_row[1], p), dot(in_world_row[2], p));
#ifdef FACING
    world += from_viewer(vec3(in_facing.xy, 0.0));
#endif
#ifdef SHADOW_TILE
    gl_Position = tile.clip_from_centre * vec4(world, 1.0);
#else
    gl_Position = frame.clip_from_world * vec4(world, 1.0);
#endif
    return world;
}
#endif
