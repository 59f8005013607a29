#version 460
// Three circles around each light, as far as it reaches.
layout(push_constant) uniform Light {
    mat4 clip_from_world;
    vec4 sphere;  // centre relative to the camera, radius
} light;

void main() {
    const int segments = 32;  // lines of a circle
    float turn = 6.2831853 * float((gl_VertexIndex + 1) / 2 % segments) / float(segments);
    int axis = gl_VertexIndex / (2 * segments);
    vec3 place = vec3(cos(turn), sin(turn), 0.0);
    place = axis == 0 ? place.xyz : axis == 1 ? place.zxy : place.yzx;
    gl_Position = light.clip_from_world * vec4(light.sphere.xyz + light.sphere.w * place, 1.0);
}
