#version 460
#extension GL_GOOGLE_include_directive : require
// Ambient occlusion from depth and normals by horizons: Jimenez, Wu, Pesce and Jarabo, "Practical Realtime Strategies
// for Accurate Indirect Occlusion", 2016. Around each pixel, slices through the line of sight; in each, on both sides, the
// highest that the depth buffer rises over the surface's tangent; the cosine-weighted share of directions that is left.
#include "shared/gbuffer.glsl"
#include "shared/occlusion.glsl"

layout(location = 0) out vec2 out_visibility;

const int slices = 2, samples = 4; // on each side of each slice
const float pi = 3.14159265;

// Of directions at an angle between 0 and `h` from the line of sight, weighted by the cosine to a normal at `gamma`.
float arc(float h, float gamma, float cosine, float sine) { return 0.25 * (cosine - cos(2.0 * h - gamma) + 2.0 * h * sine); }

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy), pixel = at * occlusion_scale, last = last_pixel();
    vec3 world;
    bool surface = read_position(pixel, world);
    vec3 n = read_normal(pixel), v = to_viewer(world);
    float z = dot(world, frame.forward.xyz);
    vec3 right = normalize(frame.ray_right.xyz), down = normalize(frame.ray_up.xyz); // of one step of clip space
    // Where the camera is very near, the search goes no farther than half of the picture.
    float reach = min(occlusion_radius / pixel_metres(z), 0.5 * raster.size.y);
    // 4×4 pixels search in different directions and at different distances; the blur brings them together.
    float turn = float((((at.x + at.y) & 3) << 2) | (at.x & 3)) / 16.0, start = (float((at.y - at.x) & 3) + 0.5) / 4.0;

    float seen = 0.0, open = 0.0;
    for (int slice = 0; slice < slices; ++slice) {
        float angle = (float(slice) + turn) * (pi / float(slices));
        vec2 direction = vec2(cos(angle), sin(angle));
        vec3 axis = normalize(cross(right * direction.x + down * direction.y, v));
        vec3 inside = n - axis * dot(n, axis);
        float share = max(length(inside), 1e-4);
        inside /= share;
        vec3 tangent = cross(inside, axis);
        float cosine = clamp(dot(inside, v), -1.0, 1.0), sine = dot(inside, cross(v, axis));
        float gamma = acos(cosine) * (sine < 0.0 ? -1.0 : 1.0);
        vec2 highest = vec2(-1.0); // minus the cosine of the angle over the tangent
        for (int i = 0; i < 2 * samples; ++i) {
            float side = i < samples ? 1.0 : -1.0, step = (float(i < samples ? i : i - samples) + start) / float(samples);
            ivec2 other = ivec2(floor(vec2(pixel) + 0.5 + side * direction * (1.0 + step * step * max(reach - 1.0, 0.0))));
            bool on_picture = all(greaterThanEqual(other, ivec2(0))) && all(lessThanEqual(other, last));
            vec3 there;
            bool something = read_position(clamp(other, ivec2(0), last), there);
            vec3 way = there - world;
            float far2 = dot(way, way), along = side * dot(way, tangent);
            // Less than 2° over the surface is the surface itself, as its normal is stored and pixels lie beside the slice.
            float up = (dot(way, n) - 0.035 * sqrt(far2)) / share;
            // 1 at the surface itself, 0 at the radius.
            float weight = something && on_picture ? clamp(1.0 - far2 / (occlusion_radius * occlusion_radius), 0.0, 1.0) : 0.0;
            float rise = up > 0.0 ? -along * inversesqrt(max(up * up + along * along, 1e-20)) : -1.0;
            rise = mix(-1.0, rise, weight);
            highest = max(highest, i < samples ? vec2(rise, -1.0) : vec2(-1.0, rise));
        }
        vec2 over = acos(-highest);
        float first = min(gamma - 0.5 * pi + over.y, 0.0), second = max(gamma + 0.5 * pi - over.x, 0.0);
        seen += share * (arc(first, gamma, cosine, sine) + arc(second, gamma, cosine, sine));
        open += share * (cosine + gamma * sine);
    }
    float visibility = clamp(seen / max(open, 1e-4), 0.0, 1.0);
    out_visibility = surface ? vec2(visibility, plane_depth(z)) : vec2(1.0, 0.0);
}
