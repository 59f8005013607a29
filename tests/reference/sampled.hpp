#pragma once
#include "worlds.hpp"

namespace prelight {

using SampleLight = ReferenceSamples::Light;
using SampleRate = ReferenceSamples::Rate;

/// The size of a picture.
inline constexpr uint32_t columns = 24, rows = 16;

/// A camera that sees the plane z = 0 at one metre a pixel, the picture's middle at the origin.
inline PlacedCamera metre_camera(ProjectionKind kind) {
    if (kind == ProjectionKind::perspective)
        return front_camera(rows / 2.0 / std::tan(0.4));
    return look_at({.kind = kind, .ymag = rows / 2.0, .znear = 0.1f}, {0, 0, 5}, {0, 0, 0});
}

/// A point of z = 0 by its place in the picture of `metre_camera`, in pixels from the top left.
inline glm::vec3 at_pixel(double x, double y) {
    return {static_cast<float>(x - columns / 2.0), static_cast<float>(rows / 2.0 - y), 0};
}

/// One triangle in z = 0 that faces +Z, whichever way round its corners come.
inline Primitive triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    Primitive primitive;
    primitive.positions = {a, b, c};
    primitive.normals.assign(3, {0, 0, 1});
    const bool turned = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) < 0;
    primitive.indices = turned ? std::vector<uint32_t>{0, 2, 1} : std::vector<uint32_t>{0, 1, 2};
    return primitive;
}

/// A triangle that fills every picture of `metre_camera`.
inline Primitive wall_triangle() { return triangle({-3000, -1000, 0}, {3000, -1000, 0}, {0, 3000, 0}); }

inline const std::vector<ReferenceSamples> every_form{
    {.count = 4},
    {.count = 2},
    {.count = 4, .material = SampleRate::fragment},
    {.count = 4, .material = SampleRate::fragment, .geometry = SampleRate::fragment},
    {.count = 4, .light = SampleLight::pixel},
    {.count = 4, .light = SampleLight::pixel, .material = SampleRate::fragment},
    {.count = 4, .light = SampleLight::fragment},
    {.count = 4, .light = SampleLight::fragment, .material = SampleRate::fragment, .geometry = SampleRate::fragment},
    {.count = 4, .shadows_per_pixel = true},
    {.count = 4, .light = SampleLight::edges},
    {.count = 4, .light = SampleLight::edges, .material = SampleRate::fragment}};

/// What a forward renderer does.
inline const ReferenceSamples forward_samples = every_form[7];

inline ReferencePicture sampled(const TestWorld& test, const PlacedCamera& camera, const ReferenceSamples& samples,
                                ReferenceForm form = {}, uint32_t width = columns, uint32_t height = rows) {
    form.samples = samples;
    return render_reference(test.world, camera, width, height, 0, form);
}

} // namespace prelight
