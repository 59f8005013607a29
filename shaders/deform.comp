#version 460
#extension GL_GOOGLE_include_directive : require
// Morph targets, then the skin: glTF 2.0, 3.7.2.2 and 3.7.3. An invocation is a vertex: it writes the position, normal
// and tangent that all passes draw with, and the position that it had at the previous state.
#include "shared/bindings.h"
#include "shared/deformation.h"

layout(local_size_x = DEFORM_GROUP) in;
layout(push_constant) uniform CountBlock { uint groups; };
layout(set = SET_INPUTS, binding = INPUT_DEFORM_JOBS, std430) readonly buffer JobBlock { DeformJob jobs[]; };
layout(set = SET_INPUTS, binding = INPUT_DEFORM_GROUPS, std430) readonly buffer GroupBlock { uvec2 group_list[]; };
layout(set = SET_INPUTS, binding = INPUT_DEFORM_BASE, std430) readonly buffer BaseBlock { float base[]; };
layout(set = SET_INPUTS, binding = INPUT_DEFORM_INFLUENCES, std430) readonly buffer InfluenceBlock { uint influences[]; };
layout(set = SET_INPUTS, binding = INPUT_DEFORM_TARGETS, std430) readonly buffer TargetBlock { float targets[]; };
layout(set = SET_INPUTS, binding = INPUT_DEFORM_STATE, std430) readonly buffer StateBlock { vec4 state[]; };
layout(set = SET_INPUTS, binding = INPUT_DEFORM_POSITIONS, std430) writeonly buffer PositionBlock { float positions[]; };
layout(set = SET_INPUTS, binding = INPUT_DEFORM_PREVIOUS, std430) writeonly buffer PreviousBlock { float previous_positions[]; };
layout(set = SET_INPUTS, binding = INPUT_DEFORM_ATTRIBUTES, std430) writeonly buffer AttributeBlock { float attributes[]; };

DeformJob job;  // the primitive of this workgroup

bool has(uint flag) { return (job.vertices.w & flag) != 0u; }

vec3 base_vector(uint vertex, uint offset) {
    uint at = (job.vertices.z + vertex) * DEFORM_BASE_FLOATS + offset;
    return vec3(base[at], base[at + 1u], base[at + 2u]);
}

// Where the shape's joints and weights stand in the state.
struct Shape {
    uint joints, weights;
};

Shape shape_now() { return Shape(job.state.x, job.state.x + 6u * job.state.y); }
Shape shape_before() {
    return Shape(job.state.x + 3u * job.state.y, job.state.x + 6u * job.state.y + job.state.w);
}

vec3 morphed(uint vertex, uint offset, Shape shape) {
    vec3 sum = base_vector(vertex, offset);
    for (uint t = 0u; t < job.data.w; ++t) {
        float weight = state[shape.weights + t / 4u][t % 4u];
        if (weight == 0.0)
            continue;
        uint at = job.data.z + (t * job.state.z + vertex) * DEFORM_TARGET_FLOATS + offset;
        sum += weight * vec3(targets[at], targets[at + 1u], targets[at + 2u]);
    }
    return sum;
}

// Rows of the vertex's matrix: the sum of its joints'.
mat3x4 joint_rows(uint vertex, Shape shape) {
    mat3x4 sum = mat3x4(0.0);
    for (uint s = 0u; s < job.data.y; ++s) {
        uint at = job.data.x + (vertex * job.data.y + s) * DEFORM_INFLUENCE_WORDS;
        for (uint i = 0u; i < 4u; ++i) {
            uint joint = influences[at + i / 2u] >> (16u * (i % 2u)) & 0xffffu;
            float weight = uintBitsToFloat(influences[at + 2u + i]);
            uint row = shape.joints + 3u * joint;
            sum += weight * mat3x4(state[row], state[row + 1u], state[row + 2u]);
        }
    }
    return sum;
}

vec3 place(uint vertex, Shape shape) {
    vec3 p = morphed(vertex, 0u, shape);
    return job.data.y > 0u ? vec4(p, 1.0) * joint_rows(vertex, shape) : p;
}

vec3 unit_or(vec3 v, vec3 other) {
    float largest = max(abs(v.x), max(abs(v.y), abs(v.z)));
    return largest > 0.0 && largest < 3e38 ? normalize(v / largest) : other;
}

vec3 face_normal(uint vertex) {
    uint first = vertex - vertex % 3u;
    Shape shape = shape_now();
    vec3 a = place(first, shape), b = place(first + 1u, shape), c = place(first + 2u, shape);
    return unit_or(cross(b - a, c - a), vec3(0.0, 0.0, 1.0)) * (has(DEFORM_TURNED) ? -1.0 : 1.0);
}

void main() {
    uint index = gl_WorkGroupID.y * DEFORM_ROW + gl_WorkGroupID.x;
    if (index >= groups)
        return;
    uvec2 group = group_list[index];  // its primitive, and the first of its vertices
    job = jobs[group.x];
    uint vertex = group.y + gl_LocalInvocationID.x;
    if (vertex >= job.vertices.y)
        return;
    Shape now = shape_now();
    mat3x4 rows = job.data.y > 0u ? joint_rows(vertex, now) : mat3x4(mat3(1.0));
    vec3 p = vec4(morphed(vertex, 0u, now), 1.0) * rows;
    mat3 linear = transpose(mat3(rows));
    float side = determinant(linear) < 0.0 ? -1.0 : 1.0;
    // The inverse transpose times the determinant's absolute value.
    mat3 normals = side * mat3(cross(linear[1], linear[2]), cross(linear[2], linear[0]), cross(linear[0], linear[1]));
    vec3 n = has(DEFORM_FLAT) ? face_normal(vertex) : unit_or(normals * morphed(vertex, 3u, now), base_vector(vertex, 3u));
    uint to = job.vertices.x + vertex;
    for (uint i = 0u; i < 3u; ++i) {
        positions[3u * to + i] = p[i];
        attributes[DEFORM_ATTRIBUTE_FLOATS * to + i] = n[i];
    }
    if (has(DEFORM_TANGENTS)) {
        vec3 t = unit_or(linear * morphed(vertex, 6u, now), base_vector(vertex, 6u));
        vec3 inside = t - dot(n, t) * n;
        t = has(DEFORM_FLAT) && length(inside) > 1e-6 ? normalize(inside) : t;
        for (uint i = 0u; i < 3u; ++i)
            attributes[DEFORM_ATTRIBUTE_FLOATS * to + 3u + i] = t[i];
        attributes[DEFORM_ATTRIBUTE_FLOATS * to + 6u] =
            side * base[(job.vertices.z + vertex) * DEFORM_BASE_FLOATS + 9u];
    }
    if (has(DEFORM_PREVIOUS)) {
        vec3 q = place(vertex, shape_before());
        for (uint i = 0u; i < 3u; ++i)
            previous_positions[3u * to + i] = q[i];
    }
}
