#version 460
#extension GL_GOOGLE_include_directive : require
// Volumes that circumscribe what a light reaches, one instance a light.
#include "shared/frame.glsl"

layout(constant_id = CONSTANT_VOLUME) const int volume = VOLUME_SPHERE;

// Sphere: xyz is a point of a polyhedron that circumscribes the unit sphere. Cone: x, y are a point
// of a polygon that circumscribes the unit circle, z the ring: 0 apex, 1 rim, 2 cap, 3 cap's centre.
// Box: x, y are −1 or 1, z is 0 at the light and 1 at its range.
layout(location = VERTEX_POSITION) in vec3 in_point;
layout(location = 0) flat out uint out_light;
// The two passes of light-culling=stencil cover the same pixels.
invariant gl_Position;

vec3 spot_point(LightData light, float range) {
    vec3 axis = light.axis;
    vec3 helper = abs(axis.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0);
    vec3 side = normalize(cross(axis, helper));
    vec3 across = side * in_point.x + cross(axis, side) * in_point.y;
    float angle = light.outer_angle;
    if (volume == VOLUME_BOX)
        return (axis * in_point.z + across * sin(angle)) * range;
    // The rim lies where the cone meets the sphere of the range; the cap is the sphere's tangent
    // there, up to the plane that touches the sphere on the axis.
    float radius = in_point.z < 0.5 ? 0.0 : in_point.z < 1.5 ? sin(angle) : in_point.z < 2.5 ? tan(0.5 * angle) : 0.0;
    float along = in_point.z < 0.5 ? 0.0 : in_point.z < 1.5 ? cos(angle) : 1.0;
    return (axis * along + across * radius) * range;
}

void main() {
    out_light = light_order[gl_InstanceIndex];
    LightData light = lights[out_light];
    float range = 1.001 / light.inverse_range;
    vec3 offset = volume == VOLUME_SPHERE ? in_point * range : spot_point(light, range);
    // The apex moves back a little, so that rounding never cuts the volume's tip off.
    if (volume != VOLUME_SPHERE)
        offset -= light.axis * (0.0005 * range);
    gl_Position = frame.clip_from_world * vec4(light.position + offset, 1.0);
}
