// specular-antialiasing=on: highlights smaller than a pixel, under a camera that turns, against a picture of 64
// times as many pixels.
#include "garden.hpp"
#include <cmath>

namespace prelight {
namespace {

/// Smooth metal spheres a few pixels across.
struct Beads : TestWorld {
    Beads() {
        add_material({.name = "chrome", .base_colour = {0.9f, 0.9f, 0.9f, 1}, .metallic = 1, .roughness = 0.12f});
        for (int y = -2; y <= 2; ++y)
            for (int x = -4; x <= 4; ++x)
                add(sphere(48), glm::scale(glm::translate(glm::dmat4(1), {1.1 * x, 1.1 * y, 0}), glm::dvec3(0.5)));
        add_light({.kind = LightKind::point, .intensity = 60, .range = 40}, {4, 5, 8});
        add_light({.kind = LightKind::point, .colour = {0.6f, 0.8f, 1}, .intensity = 60, .range = 40}, {-6, 2, 7});
    }
};

constexpr int frames = 8, finer = 8;
constexpr uint32_t width = 96, height = 54;

Image shrunk(const Image& fine) {
    Image out(fine.width / finer, fine.height / finer);
    for (uint32_t y = 0; y < fine.height; ++y)
        for (uint32_t x = 0; x < fine.width; ++x)
            out.at(x / finer, y / finer) += fine.at(x, y) / float(finer * finer);
    return out;
}

/// Mean square of the difference of two pictures' green, as a screen clips it.
double difference(const Image& a, const Image& b) {
    double sum = 0;
    for (size_t i = 0; i < a.pixels.size(); ++i) {
        const double d = std::min(a.pixels[i].g, 1.0f) - std::min(b.pixels[i].g, 1.0f);
        sum += d * d;
    }
    return sum / double(a.pixels.size());
}

struct Figures {
    double error = 0;  ///< against the fine picture
    double change = 0; ///< from frame to frame
};

Figures turning(const Beads& beads, const std::string& renderer, const char* setting) {
    Figures figures;
    Image before;
    for (int f = 0; f < frames; ++f) {
        Camera lens;
        lens.yfov = 0.35;
        const double turn = 0.0013 * f; // a fifth of a pixel
        const PlacedCamera camera = look_at(lens, {0, 0, 22}, {22 * std::sin(turn), 0, 22 - 22 * std::cos(turn)});
        Shot shot{.world = &beads.world, .camera = camera, .width = width, .height = height, .renderer = renderer};
        shot.settings = {{"specular-antialiasing", setting}};
        const Image picture = render_linear(test_device(), shot);
        if (f > 0)
            figures.change += difference(picture, before) / (frames - 1);
        before = picture;
        shot.settings = {{"specular-antialiasing", "off"}};
        shot.width *= finer;
        shot.height *= finer;
        figures.error += difference(picture, shrunk(render_linear(test_device(), shot))) / frames;
    }
    return figures;
}

class SpecularAntialiasing : public testing::TestWithParam<const char*> {};

TEST_P(SpecularAntialiasing, KeepsHighlightsFromSparkling) {
    const Beads beads;
    const Figures off = turning(beads, GetParam(), "off"), on = turning(beads, GetParam(), "on");
    std::printf("    %s: against 64 times the pixels %.2e without, %.2e with; from frame to frame %.2e and %.2e\n", GetParam(),
                off.error, on.error, off.change, on.change);
    EXPECT_LT(on.error, 0.75 * off.error); // what is left are mostly silhouettes, in both
    EXPECT_LT(on.change, 0.3 * off.change);
    expect_validation_clean(test_device());
}

INSTANTIATE_TEST_SUITE_P(WhereRoughnessIsStored, SpecularAntialiasing, testing::Values("light-prepass", "deferred"),
                         [](const auto& tested) { return tested.index == 0 ? "LightPrepass" : "Deferred"; });

} // namespace
} // namespace prelight
