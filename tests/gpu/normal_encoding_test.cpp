// The normal encodings as C++ compiles them, against an implementation written here from the
// definitions in double precision, and against figures computed outside this project.
#include "directions.hpp"
#include <gtest/gtest.h>
#include <shared/normal_encoding.h>

namespace prelight {
namespace {

constexpr uint32_t count = 2'000'000;

// ---- The targets: what comes back from an unsigned normalised format of so many bits.
float stored(float value, int bits) {
    const float steps = static_cast<float>((1 << bits) - 1);
    return std::floor(value * steps + 0.5f) / steps;
}
glm::vec3 through_oct24(glm::vec3 n) {
    const glm::vec3 e = shared::oct24_encode(n);
    return shared::oct24_decode({stored(e.x, 8), stored(e.y, 8), stored(e.z, 8)});
}
glm::vec3 through_oct32(glm::vec3 n) {
    const glm::vec2 e = shared::oct32_encode(n);
    return shared::oct32_decode({stored(e.x, 16), stored(e.y, 16)});
}
glm::vec3 through_rgb10(glm::vec3 n) {
    const glm::vec3 e = shared::rgb10_encode(n);
    return shared::rgb10_decode({stored(e.x, 10), stored(e.y, 10), stored(e.z, 10)});
}

// ---- The definitions. Meyer and others 2010: the sphere is projected on the octahedron
// |x| + |y| + |z| = 1, whose lower faces are folded out over its equator: (x, y) is mirrored at the
// equator's edge of its own quadrant.
glm::dvec2 mirror_at_equator(glm::dvec2 p) {
    const glm::dvec2 outward(std::copysign(1, p.x), std::copysign(1, p.y));
    return p + (1 - glm::dot(p, outward)) * outward;
}
/// `half`: steps from 0 to 1.
glm::dvec3 octahedral_by_definition(glm::dvec3 n, double half) {
    const glm::dvec3 on_octahedron = n / (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
    glm::dvec2 p(on_octahedron);
    if (on_octahedron.z < 0)
        p = mirror_at_equator(p);
    p = {std::round(p.x * half) / half, std::round(p.y * half) / half};
    const double z = 1 - std::abs(p.x) - std::abs(p.y);
    return glm::dvec3(z < 0 ? mirror_at_equator(p) : p, z);
}
glm::dvec3 rgb10_by_definition(glm::dvec3 n) {
    const auto channel = [](double v) { return std::round((v + 1) / 2 * 1023) / 1023 * 2 - 1; };
    return {channel(n.x), channel(n.y), channel(n.z)};
}

struct Figures {
    Angles ours, by_definition;
};
template <class Ours, class Definition>
Figures measure(Ours ours, Definition definition) {
    Figures figures;
    for (uint32_t i = 0; i < count; ++i) {
        const glm::vec3 n(direction(i, count));
        figures.ours.add(angle(n, ours(n)));
        figures.by_definition.add(angle(n, definition(glm::dvec3(n))));
    }
    std::printf("    mean %.6f° max %.6f° (by definition %.6f° and %.6f°)\n", figures.ours.mean(),
                figures.ours.max, figures.by_definition.mean(), figures.by_definition.max);
    return figures;
}
void expect_as_defined(const Figures& f) {
    EXPECT_NEAR(f.ours.mean(), f.by_definition.mean(), f.by_definition.mean() * 0.001);
    EXPECT_NEAR(f.ours.max, f.by_definition.max, f.by_definition.max * 0.01);
}

TEST(NormalEncoding, Oct24AngularError) {
    expect_as_defined(measure(through_oct24, [](glm::dvec3 n) { return octahedral_by_definition(n, 2047); }));
}

TEST(NormalEncoding, Oct32AngularError) {
    const Figures f =
        measure(through_oct32, [](glm::dvec3 n) { return octahedral_by_definition(n, 32767); });
    expect_as_defined(f);
    EXPECT_NEAR(f.ours.mean(), 0.0013, 0.00005);
    EXPECT_NEAR(f.ours.max, 0.0037, 0.00005);
}

TEST(NormalEncoding, Rgb10AngularError) {
    const Figures f = measure(through_rgb10, rgb10_by_definition);
    expect_as_defined(f);
    EXPECT_NEAR(f.ours.mean(), 0.042, 0.0005);
    EXPECT_NEAR(f.ours.max, 0.096, 0.0005);
}

TEST(NormalEncoding, OctahedralAxesAreExact) {
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {1.0f, -1.0f})
            for (const float zero : {0.0f, -0.0f}) {
                glm::vec3 n(zero);
                n[axis] = sign;
                EXPECT_EQ(through_oct24(n), n) << "axis " << axis << " sign " << sign << " zero " << zero;
                EXPECT_EQ(through_oct32(n), n) << "axis " << axis << " sign " << sign << " zero " << zero;
            }
}

// On the edges between octants signs decide where a direction goes; a wrong one throws it far away.
TEST(NormalEncoding, OctantEdgesAndTheirNeighboursStayClose) {
    Angles oct24, oct32;
    for (uint32_t i = 0; i < 100'000; ++i)
        for (int zero_axis = 0; zero_axis < 3; ++zero_axis)
            for (const double aside : {0.0, -0.0, 1e-7, -1e-7, 1e-4, -1e-4}) {
                const double turn = 6.283185307179586 * i / 100'000;
                glm::dvec3 d;
                d[zero_axis] = aside;
                d[(zero_axis + 1) % 3] = std::cos(turn);
                d[(zero_axis + 2) % 3] = std::sin(turn);
                const glm::vec3 n(glm::normalize(d));
                oct24.add(angle(n, through_oct24(n)));
                oct32.add(angle(n, through_oct32(n)));
            }
    EXPECT_LE(oct24.max, 0.0592); // the largest error anywhere, Oct24AngularError
    EXPECT_LE(oct32.max, 0.0037);
}

TEST(NormalEncoding, RoughnessInEightBits) {
    double worst = 0;
    for (uint32_t i = 0; i <= 1'000'000; ++i) {
        const double roughness = 0.089 + (1 - 0.089) * i / 1e6;
        const float back =
            shared::roughness_decode(stored(shared::roughness_encode(static_cast<float>(roughness)), 8));
        worst = std::max(worst, std::abs(back / roughness - 1));
    }
    // 255 even steps of the logarithm between 0.089 and 1; half a step is the largest error.
    const double half_step = std::pow(1 / 0.089, 0.5 / 255) - 1;
    EXPECT_NEAR(worst, half_step, half_step * 0.01);
    EXPECT_EQ(shared::roughness_decode(stored(shared::roughness_encode(1), 8)), 1);
    EXPECT_NEAR(shared::roughness_decode(0), 0.089, 1e-6);
    EXPECT_EQ(shared::roughness_encode(0), shared::roughness_encode(0.089f)) << "what shading uses";
    EXPECT_EQ(shared::roughness_encode(2), 1);
}

} // namespace
} // namespace prelight
