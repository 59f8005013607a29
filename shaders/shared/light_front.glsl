// Where the surfaces of a subgroup's pixels lie and which way they face, and whether a light may reach them from
// their front. Conservative, as light_bounds.glsl is.
#ifndef PRELIGHT_LIGHT_FRONT_GLSL
#define PRELIGHT_LIGHT_FRONT_GLSL
#include "shared/light_bounds.glsl"
#include "shared/light_share.glsl"

struct LightFront {
    vec3 normal;  // unit, the mean
    float spread; // sine of the largest angle between a pixel's normal and the mean; 2 when that says nothing
    float behind; // least distance along `normal`, metres
    vec3 low, high; // the box around them, along the world's axes
};

// Of normals whose sum is `normals`; 0 when they point everywhere.
vec3 mean_normal(vec3 normals) { return normals * inversesqrt(max(dot(normals, normals), 1e-12)); }

// `least_cosine`: between the mean and the normals; `size`: largest |x| + |y| + |z| of the points.
LightFront light_front(vec3 mean, float least_cosine, float behind, float size, vec3 low, vec3 high) {
    float spread = least_cosine > 0.0 ? sqrt(max(1.0 - least_cosine * least_cosine, 0.0)) + 1e-3 : 2.0;
    float slack = 1e-5 * size;
    return LightFront(mean, spread, behind - slack, low - slack, high + slack);
}

// A light is behind all surfaces when from each of them the angle between its direction and the mean normal is
// 90° and the spread more, wherever within its range.
bool may_be_before(LightFront front, LightData light) {
    LightBounds b = bounds_of(light);
    float slack = 1e-5 * dot(abs(b.centre), vec3(1.0));
    float before = dot(b.centre, front.normal) + b.radius * front.spread + slack - front.behind;
    vec3 gap = max(max(front.low - b.centre, b.centre - front.high), vec3(0.0));
    bool reaches = !(dot(gap, gap) > b.radius * b.radius);
    return light.inverse_range <= 0.0 || (reaches && (front.spread > 1.5 || !(before <= 0.0)));
}
#endif
