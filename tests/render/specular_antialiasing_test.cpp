// specular-antialiasing=on: highlights smaller than a pixel, under a camera that turns, against pictures of 64 times as
// many pixels.
#include "garden.hpp"
#include <cmath>

namespace prelight {
namespace {

constexpr int turn_frames = 6, finer = 8;
constexpr uint32_t coarse_width = 96, coarse_height = 54;

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

/// A smooth wall with waves of about ten texels in its normal map, twelve texels to a pixel.
struct Hammered : TestWorld {
    Hammered() {
        constexpr uint32_t size = 1024;
        std::vector<uint8_t> rgba(size_t(size) * size * 4, 255);
        const auto slope = [](float a, float b) {
            return 0.14f *
                   (std::sin(0.71f * a) + std::sin(0.23f * a + 0.53f * b + 1) + std::sin(0.47f * a - 0.37f * b + 2));
        };
        for (uint32_t y = 0; y < size; ++y)
            for (uint32_t x = 0; x < size; ++x) {
                const auto a = static_cast<float>(x), b = static_cast<float>(y);
                const glm::vec3 n = glm::normalize(glm::vec3(slope(a, b), slope(b, a), 1));
                for (int c = 0; c < 3; ++c)
                    rgba[4 * (size_t(y) * size + x) + c] = static_cast<uint8_t>(std::lround(127.5f * (n[c] + 1)));
            }
        Material material{.name = "hammered", .base_colour = {0.9f, 0.8f, 0.6f, 1}, .metallic = 1, .roughness = 0.35f};
        material.normal_texture.image = add_image(size, size, std::move(rgba));
        add_material(material);
        add(square(6));
        add_light({.kind = LightKind::point, .intensity = 200, .range = 60}, {2, 3, 14});
    }
};

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

Image turned_picture(const World& world, int frame, uint32_t scale, const std::string& renderer, const char* setting) {
    Camera lens;
    lens.yfov = 0.35;
    const double turn = 0.0013 * frame; // a fifth of a pixel
    const PlacedCamera camera = look_at(lens, {0, 0, 22}, {22 * std::sin(turn), 0, 22 - 22 * std::cos(turn)});
    const auto made = create_renderer(renderer, &test_device(),
                                      {.width = coarse_width * scale,
                                       .height = coarse_height * scale,
                                       .settings = {{"specular-antialiasing", setting}},
                                       .views = {"linear"}});
    made->set_world(world);
    made->render(camera);
    return made->read("linear");
}

struct Sparkle {
    double error = 0;  ///< against the fine pictures
    double change = 0; ///< from frame to frame
};

Sparkle turning(const World& world, const std::vector<Image>& fine, const std::string& renderer, const char* setting) {
    Sparkle figures;
    Image before;
    for (int f = 0; f < turn_frames; ++f) {
        const Image now = turned_picture(world, f, 1, renderer, setting);
        if (f > 0)
            figures.change += difference(now, before) / (turn_frames - 1);
        figures.error += difference(now, fine[f]) / turn_frames;
        before = now;
    }
    return figures;
}

std::vector<Image> fine_pictures(const World& world) {
    std::vector<Image> fine;
    for (int f = 0; f < turn_frames; ++f)
        fine.push_back(shrunk(turned_picture(world, f, finer, "light-prepass", "off")));
    return fine;
}

void print(const std::string& renderer, const Sparkle& off, const Sparkle& on) {
    std::printf("    %s: against 64 times the pixels %.2e without, %.2e with; from frame to frame %.2e and %.2e\n",
                renderer.c_str(), off.error, on.error, off.change, on.change);
}

TEST(SpecularAntialiasing, KeepsHighlightsFromSparkling) {
    const Beads beads;
    const std::vector<Image> fine = fine_pictures(beads.world);
    for (const std::string& renderer : device_renderers) {
        const Sparkle off = turning(beads.world, fine, renderer, "off");
        const Sparkle on = turning(beads.world, fine, renderer, "on");
        print(renderer, off, on);
        EXPECT_LT(on.error, 0.75 * off.error) << renderer; // what is left are mostly silhouettes, in both
        EXPECT_LT(on.change, 0.3 * off.change) << renderer;
    }
    expect_validation_clean(test_device());
}

TEST(SpecularAntialiasing, KnowsWhatMipMapsOfNormalsAverageAway) {
    const Hammered wall;
    const std::vector<Image> fine = fine_pictures(wall.world);
    for (const std::string& renderer : device_renderers) {
        const Sparkle off = turning(wall.world, fine, renderer, "off"), on = turning(wall.world, fine, renderer, "on");
        print(renderer, off, on);
        EXPECT_LT(on.error, 0.5 * off.error) << renderer;
    }
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
