// A convex piece of the world, and whether a light may reach into it. Conservative: a light that
// reaches is never missed.
#ifndef PRELIGHT_LIGHT_BOUNDS_GLSL
#define PRELIGHT_LIGHT_BOUNDS_GLSL
#include "shared/frame.glsl"
#include "shared/light_kinds.glsl"


// Points p with low <= p·w <= high, |p·u − middle.x| <= half_size.x + slope.x p·w, and the same for
// v and y: a box (slopes 0), or a part of a pyramid whose apex is the origin.
struct Piece {
    vec3 u, v, w;  // orthonormal
    float low, high;
    vec2 middle, half_size, slope;
};

// A light's volume: the sphere of its range, and the cone of a spot.
struct LightBounds {
    vec3 centre;
    float radius;
    vec3 axis;
    vec2 cone;  // cosine and sine of the outer angle; x −2 when there is no cone
};

LightBounds bounds_of(LightData light) {
    // Positions that pixels reconstruct are off by a few units in the last place of their distance.
    float range = 1.0 / light.inverse_range;
    LightBounds b = LightBounds(light.position, range * 1.0005, light.axis, vec2(-2.0, 0.0));
    b.radius += 1e-5 * (range + length(light.position));
    if (may_be(LIGHT_KIND_SPOT) && light.cone.x > 0.0) {
        float cosine = clamp(-light.cone.y / light.cone.x, -1.0, 1.0);
        b.cone = vec2(cosine, sqrt(max(1.0 - cosine * cosine, 0.0)));
    }
    return b;
}

// Where the light's centre is beside the piece (a), the pyramid's side leans away by at most `slope`: the
// distance to it is at least a / sqrt(1 + slope²). Before or behind the piece the gap along w is at a right
// angle to that.
bool sphere_touches(Piece p, LightBounds light) {
    float t = dot(light.centre, p.w);
    float inside = clamp(t, p.low, p.high);
    vec2 across = abs(vec2(dot(light.centre, p.u), dot(light.centre, p.v)) - p.middle);
    across = max(across - (p.half_size + p.slope * inside), vec2(0.0));
    float gap = t - inside;
    float squared = gap * gap + dot(across, across) / (1.0 + dot(p.slope, p.slope));
    return !(squared > light.radius * light.radius); // true for NaN too
}

// The sphere around the piece against the line on which the cone's side lies.
bool cone_touches(Piece p, LightBounds light) {
    float t = 0.5 * (p.low + p.high);
    vec2 half_size = p.half_size + p.slope * p.high;
    float radius = sqrt(dot(half_size, half_size) + 0.25 * (p.high - p.low) * (p.high - p.low));
    vec3 from_light = p.u * p.middle.x + p.v * p.middle.y + p.w * t - light.centre;
    float along = dot(from_light, light.axis);
    float across = sqrt(max(dot(from_light, from_light) - along * along, 0.0));
    return !(across * light.cone.x - along * light.cone.y > radius * 1.0005 + 1e-3 * light.radius);
}

bool touches(Piece p, LightBounds light) {
    bool hit = sphere_touches(p, light);
    if (may_be(LIGHT_KIND_SPOT))
        hit = hit && (light.cone.x < -1.5 || cone_touches(p, light));
    return hit;
}
#endif
