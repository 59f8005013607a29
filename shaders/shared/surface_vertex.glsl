// Vertex shader of every pass that looks at a surface's material.
#include "shared/vertex.glsl"

layout(location = VERTEX_NORMAL) in vec3 in_normal;
layout(location = VERTEX_TANGENT) in vec4 in_tangent;
layout(location = VERTEX_TEXCOORD_0) in vec2 in_texcoord_0;
layout(location = VERTEX_TEXCOORD_1) in vec2 in_texcoord_1;
layout(location = VERTEX_COLOUR) in vec4 in_colour;

layout(location = 0) out vec3 out_world;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec4 out_tangent;
layout(location = 3) out vec4 out_texcoords;
layout(location = 4) out vec4 out_colour;

void main() {
    out_world = vertex_position();
    ObjectData object = objects[gl_InstanceIndex];
    out_normal = vec3(dot(object.normal_row[0].xyz, in_normal), dot(object.normal_row[1].xyz, in_normal),
                      dot(object.normal_row[2].xyz, in_normal));
    out_tangent = vec4(dot(object.world_row[0].xyz, in_tangent.xyz), dot(object.world_row[1].xyz, in_tangent.xyz),
                       dot(object.world_row[2].xyz, in_tangent.xyz), in_tangent.w * object.normal_row[0].w);
    out_texcoords = vec4(in_texcoord_0, in_texcoord_1);
    out_colour = in_colour;
}
