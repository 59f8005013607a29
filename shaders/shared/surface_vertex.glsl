// Vertex shader of every pass that looks at a surface's material.
#include "shared/vertex.glsl"

layout(location = VERTEX_COLOUR) in vec4 in_colour;
layout(location = 4) out vec4 out_colour;
#ifndef NO_WORLD
layout(location = 0) out vec3 out_world;
#endif
#ifndef NO_NORMAL
#ifndef FACING
layout(location = VERTEX_NORMAL) in vec3 in_normal;
#endif
layout(location = VERTEX_NORMAL_ROW) in vec4 in_normal_row[3];
layout(location = 1) out vec3 out_normal;
#endif
#ifndef NO_TEXTURES
layout(location = VERTEX_TEXCOORD_0) in vec2 in_texcoord_0;
layout(location = VERTEX_TEXCOORD_1) in vec2 in_texcoord_1;
layout(location = 3) out vec4 out_texcoords;
#ifndef NO_NORMAL
layout(location = VERTEX_TANGENT) in vec4 in_tangent;
layout(location = 2) out vec4 out_tangent;
#endif
#endif
#ifdef SURFACE_IDS
layout(location = VERTEX_SMOOTH_GROUP) in uint in_smooth_group;
layout(location = 6) flat out uvec2 out_surface;
#ifdef NO_NORMAL
layout(location = VERTEX_NORMAL_ROW + 1) in vec4 in_second_normal_row;
#endif
#endif
#ifdef MOTION  // where out_world was at the previous state
layout(location = VERTEX_PREVIOUS_POSITION) in vec3 in_previous_position;
layout(location = VERTEX_PREVIOUS_WORLD_ROW) in vec4 in_previous_world_row[3];
layout(location = 5) out vec3 out_previous;
#endif
#ifdef TRANSMISSION
layout(location = 6) flat out float out_scale;
#endif
#ifdef SHADOW_TILE
layout(location = 6) flat out uint out_caster; // of the triangle: another one for most others
#endif

void main() {
    vec3 world = vertex_position();
    out_colour = in_colour;
#ifndef NO_WORLD
    out_world = world;
#endif
#ifdef FACING
#ifndef NO_NORMAL
    out_normal = from_viewer(vec3(0.0, 0.0, 1.0));
#endif
#elif !defined(NO_NORMAL)
    out_normal = vec3(dot(in_normal_row[0].xyz, in_normal), dot(in_normal_row[1].xyz, in_normal),
                      dot(in_normal_row[2].xyz, in_normal));
#endif
#ifndef NO_TEXTURES
    out_texcoords = vec4(in_texcoord_0, in_texcoord_1);
#ifdef FACING
#ifndef NO_NORMAL
    out_tangent = vec4(from_viewer(in_tangent.xyz), in_tangent.w);
#endif
#elif !defined(NO_NORMAL)
    out_tangent = vec4(dot(in_world_row[0].xyz, in_tangent.xyz), dot(in_world_row[1].xyz, in_tangent.xyz),
                       dot(in_world_row[2].xyz, in_tangent.xyz), in_tangent.w * in_normal_row[0].w);
#endif
#endif
#ifdef SURFACE_IDS
#ifdef NO_NORMAL
    float number = in_second_normal_row.w;
#else
    float number = in_normal_row[1].w;
#endif
    out_surface = uvec2(uint(number), in_smooth_group);
#endif
#ifdef TRANSMISSION
    out_scale = in_normal_row[2].w;
#endif
#ifdef SHADOW_TILE
    out_caster = uint(gl_VertexIndex) + uint(gl_InstanceIndex) * 0x9e3779b9u;
#endif
#ifdef MOTION
    vec4 previous = vec4(in_previous_position, 1.0);
    out_previous = vec3(dot(in_previous_world_row[0], previous), dot(in_previous_world_row[1], previous),
                        dot(in_previous_world_row[2], previous));
#ifdef FACING
    out_previous += from_viewer(vec3(in_facing.xy, 0.0));
#endif
#endif
}
