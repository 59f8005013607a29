// The normal encodings as C++ compiles them, against an implementation written here from the
// definitions in double precision, and against figures computed outside this project.
#include "directions.hpp"
#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>
#include <shared/linear_depth.h>
#include <shared/normal_encoding.h>

namespace prelight {
namespace {

constexpr uint32_t direction_count = 2'000'000;

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
glm::vec3 through_oct16(glm::vec3 n) {
    const glm::vec2 e = shared::oct16_encode(n);
    return shared::oct16_decode({stored(e.x, 8), stored(e.y, 8)});
}
glm::vec3 through_rgb10(glm::vec3 n) {
    const glm::vec3 e = shared::xyz_encode(n);
    return shared::xyz_decode({stored(e.x, 10), stored(e.y, 10), stored(e.z, 10)});
}
glm::vec3 through_rgb8(glm::vec3 n) {
    const glm::vec3 e = shared::xyz_encode(n);
    return shared::xyz_decode({stored(e.x, 8), stored(e.y, 8), stored(e.z, 8)});
}
glm::vec3 through_spherical(glm::vec3 n) {
    const glm::vec3 e = shared::spherical_encode(n);
    return shared::spherical_decode({stored(e.x, 8), stored(e.y, 8), stored(e.z, 8)});
}
glm::vec3 through_xy16f(glm::vec3 n) {
    const auto half = [](float v) { return glm::unpackHalf1x16(glm::packHalf1x16(v)); };
    const glm::vec2 e = shared::xy16_encode(n);
    return shared::xy16_decode({half(e.x), half(e.y)});
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
glm::dvec3 xyz_by_definition(glm::dvec3 n, double steps) {
    const auto channel = [&](double v) { return std::round((v + 1) / 2 * steps) / steps * 2 - 1; };
    return {channel(n.x), channel(n.y), channel(n.z)};
}
glm::dvec3 spherical_by_definition(glm::dvec3 n) {
    const double pi = 3.14159265358979324;
    const double theta = std::round(std::acos(n.z) / pi * 4094) / 4094 * pi;
    const double phi = std::round(std::atan2(n.y, n.x) / pi * 2048) / 2048 * pi;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}
/// The pair of halves beside (x, y), out of four, with the smallest angle.
glm::dvec3 xy16f_by_definition(glm::dvec3 n) {
    const auto step = [](double v) {
        return std::exp2(std::max(std::floor(std::log2(std::max(std::abs(v), 1e-9))), -14.0) - 10);
    };
    glm::dvec3 nearest(0);
    double least = 180;
    for (const double a : {0, 1})
        for (const double b : {0, 1}) {
            const double x = (std::floor(n.x / step(n.x)) + a) * step(n.x),
                         y = (std::floor(n.y / step(n.y)) + b) * step(n.y);
            const glm::dvec3 back(x, y, std::copysign(std::sqrt(std::max(1 - x * x - y * y, 0.0)), n.z));
            if (angle(n, back) < least) {
                least = angle(n, back);
                nearest = back;
            }
        }
    return nearest;
}

struct Figures {
    Angles ours, by_definition;
};
template <class Ours, class Definition>
Figures measure(Ours ours, Definition definition) {
    Figures figures;
    for (uint32_t i = 0; i < direction_count; ++i) {
        const glm::vec3 n(direction(i, direction_count));
        figures.ours.add(angle(n, ours(n)));
        figures.by_definition.add(angle(n, definition(glm::dvec3(n))));
    }
    std::printf("    mean %.6f° max %.6f° (by definition %.6f° and %.6f°)\n", figures.ours.mean(), figures.ours.max,
                figures.by_definition.mean(), figures.by_definition.max);
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
    const Figures f = measure(through_oct32, [](glm::dvec3 n) { return octahedral_by_definition(n, 32767); });
    expect_as_defined(f);
    EXPECT_NEAR(f.ours.mean(), 0.0013, 0.00005);
    EXPECT_NEAR(f.ours.max, 0.0037, 0.00005);
}

TEST(NormalEncoding, Oct16AngularError) {
    expect_as_defined(measure(through_oct16, [](glm::dvec3 n) { return octahedral_by_definition(n, 127); }));
}

TEST(NormalEncoding, Rgb10AngularError) {
    const Figures f = measure(through_rgb10, [](glm::dvec3 n) { return xyz_by_definition(n, 1023); });
    expect_as_defined(f);
    EXPECT_NEAR(f.ours.mean(), 0.042, 0.0005);
    EXPECT_NEAR(f.ours.max, 0.096, 0.0005);
}

TEST(NormalEncoding, Rgb8AngularError) {
    expect_as_defined(measure(through_rgb8, [](glm::dvec3 n) { return xyz_by_definition(n, 255); }));
}

TEST(NormalEncoding, SphericalAngularError) {
    const Figures f = measure(through_spherical, spherical_by_definition);
    expect_as_defined(f);
    // Half a step of θ and, at the equator, half a step of φ.
    EXPECT_NEAR(f.ours.max, std::hypot(180.0 / 4094 / 2, 180.0 / 2048 / 2), 0.0002);
}

TEST(NormalEncoding, Xy16fAngularError) { expect_as_defined(measure(through_xy16f, xy16f_by_definition)); }

// Around the poles φ turns fast, and at φ = ±180° its codes go round; one step too far throws a
// direction to the other side.
TEST(NormalEncoding, SphericalHasNoSeamAndBothPoles) {
    Angles angles;
    for (const double aside : {0.0, -0.0, 1e-20, 1e-9, 1e-7, 1e-5, 1e-4, 7e-4, 1e-3, 1e-2})
        for (uint32_t i = 0; i < 10'000; ++i) {
            const double turn = 6.283185307179586 * i / 10'000;
            for (const double pole : {1.0, -1.0}) {
                const glm::vec3 n(glm::normalize(glm::dvec3(aside * std::cos(turn), aside * std::sin(turn), pole)));
                angles.add(angle(n, through_spherical(n)));
            }
            for (const double side : {aside, -aside}) {
                const glm::vec3 n(glm::normalize(glm::dvec3(-std::abs(std::sin(turn)), side, std::cos(turn))));
                angles.add(angle(n, through_spherical(n)));
            }
        }
    EXPECT_LE(angles.max, 0.0492); // the largest error anywhere
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {1.0f, -1.0f}) {
            glm::vec3 n(0);
            n[axis] = sign;
            EXPECT_LE(angle(n, through_spherical(n)), 1e-5) << "axis " << axis << " sign " << sign;
        }
}

// Z's sign lies in the exponents: nothing in front may come back behind, at the equator and at −Z too.
TEST(NormalEncoding, Xy16fKeepsTheSignOfZ) {
    Angles all, poles;
    for (const double z : {0.0, -0.0, 1e-7, 1e-5, 1e-3, 0.01, 0.02, 0.05, 0.5, 0.999, 0.9999999, 1 - 2e-9, 1.0})
        for (const double side : {z, -z})
            for (uint32_t i = 0; i < 10'000; ++i) {
                const double turn = 6.283185307179586 * i / 10'000, across = std::sqrt(1 - z * z);
                const glm::vec3 n(glm::dvec3(across * std::cos(turn), across * std::sin(turn), side));
                const glm::vec3 back = through_xy16f(n);
                all.add(angle(n, back));
                if (std::abs(z) > 0.99)
                    poles.add(angle(n, back));
                ASSERT_TRUE(n.z >= 0 ? back.z >= 0 : back.z <= 0) << "z " << n.z << " came back as " << back.z;
            }
    EXPECT_LE(all.max, 0.9);
    EXPECT_LE(poles.max, 0.006);
    EXPECT_EQ(through_xy16f({0, 0, 1}), glm::vec3(0, 0, 1));
    EXPECT_EQ(through_xy16f({1, 0, 0}), glm::vec3(1, 0, 0));
    EXPECT_EQ(through_xy16f({0, -1, 0}), glm::vec3(0, -1, 0));
    EXPECT_EQ(through_xy16f({0, 0, -1}), glm::vec3(0, 0, -1));
}

TEST(NormalEncoding, OctahedralAxesAreExact) {
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {1.0f, -1.0f})
            for (const float zero : {0.0f, -0.0f}) {
                glm::vec3 n(zero);
                n[axis] = sign;
                EXPECT_EQ(through_oct24(n), n) << "axis " << axis << " sign " << sign << " zero " << zero;
                EXPECT_EQ(through_oct16(n), n) << "axis " << axis << " sign " << sign << " zero " << zero;
                EXPECT_EQ(through_oct32(n), n) << "axis " << axis << " sign " << sign << " zero " << zero;
            }
}

// On the edges between octants signs decide where a direction goes; a wrong one throws it far away.
TEST(NormalEncoding, OctantEdgesAndTheirNeighboursStayClose) {
    Angles oct24, oct32, oct16;
    for (uint32_t i = 0; i < 100'000; ++i)
        for (int zero_axis = 0; zero_axis < 3; ++zero_axis)
            for (const double aside : {0.0, -0.0, 1e-7, -1e-7, 1e-4, -1e-4}) {
                const double turn = 6.283185307179586 * i / 100'000;
                glm::dvec3 d{0};
                d[zero_axis] = aside;
                d[(zero_axis + 1) % 3] = std::cos(turn);
                d[(zero_axis + 2) % 3] = std::sin(turn);
                const glm::vec3 n(glm::normalize(d));
                oct24.add(angle(n, through_oct24(n)));
                oct32.add(angle(n, through_oct32(n)));
                oct16.add(angle(n, through_oct16(n)));
            }
    EXPECT_LE(oct24.max, 0.0592); // the largest error anywhere, Oct24AngularError
    EXPECT_LE(oct32.max, 0.0037);
    EXPECT_LE(oct16.max, 0.951);
}

TEST(NormalEncoding, RoughnessInEightBits) {
    double worst = 0;
    for (uint32_t i = 0; i <= 1'000'000; ++i) {
        const double roughness = 0.089 + (1 - 0.089) * i / 1e6;
        const float back = shared::roughness_decode(stored(shared::roughness_encode(static_cast<float>(roughness)), 8));
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

// The four bytes of a float: nothing may be lost, whatever its exponent.
TEST(LinearDepth, PackedIntoFourBytesIsExact) {
    const auto through = [](float z) {
        const glm::vec4 e = shared::linear_depth_encode(DEPTH_RGBA8, z);
        return shared::linear_depth_decode(DEPTH_RGBA8,
                                           {stored(e.x, 8), stored(e.y, 8), stored(e.z, 8), stored(e.w, 8)});
    };
    EXPECT_EQ(through(0), 0) << "no surface";
    for (uint32_t i = 0; i < 1'000'000; ++i) {
        const float z = std::exp2(-40.0f + 100.0f * static_cast<float>(i) / 1e6f);
        ASSERT_EQ(through(z), z);
    }
}

TEST(LinearDepth, HalfFloatsHoldNoInfinityAndNoFalseBackground) {
    const auto stored_half = [](float z) {
        return glm::unpackHalf1x16(glm::packHalf1x16(shared::linear_depth_encode(DEPTH_R16F, z).x));
    };
    EXPECT_EQ(stored_half(1e9f), 65504);
    EXPECT_GT(stored_half(1e-9f), 0);
    EXPECT_NEAR(stored_half(123.4f), 123.4f, 123.4f / 2048);
}

} // namespace
} // namespace prelight
