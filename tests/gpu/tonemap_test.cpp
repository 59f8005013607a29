// The tone mapping pass against prelight::tonemap on the CPU, on colours from black to beyond what a
// half float holds.
#include "devices.hpp"
#include "programs.hpp"
#include "world_view.hpp"
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <passes/tonemap.hpp>
#include <reference/worlds.hpp>

namespace prelight {
namespace {

constexpr uint32_t width = 256, height = 128;

/// Neutral and coloured ramps over 40 stops, and a fine one around where the curves bend.
std::vector<glm::vec4> make_colours() {
    std::vector<glm::vec4> colours;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const float ramp = static_cast<float>(x) / (width - 1);
            const float value = y % 2 ? 1.5f * ramp : std::exp2(40 * ramp - 24);
            const float turn = 6.2831853f * static_cast<float>(y) / height;
            const float saturation = static_cast<float>(y / 2 % 4) / 3;
            const glm::vec3 hue(std::cos(turn), std::cos(turn - 2.0943951f), std::cos(turn + 2.0943951f));
            const glm::vec3 colour = glm::mix(glm::vec3(1), 0.5f + 0.5f * hue, saturation) * value;
            colours.emplace_back(x == 0 ? glm::vec3(0) : glm::min(colour, 65504.0f), 1);
        }
    return colours;
}

struct Case {
    Driver driver;
    Tonemap curve;
    const char* name;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class TonemapPass : public OnDevice, public testing::WithParamInterface<Case> {
protected:
    TonemapPass() : OnDevice(GetParam().driver) {}
};

TEST_P(TonemapPass, AgreesWithTheCpu) {
    TestWorld test; // a frame wants a world; this pass does not look at it
    test.add(square(1));
    const WorldView on_device(context(), test.world, {.raster = {{width, height}}});
    const resident::View& view = on_device.view;
    const std::vector<glm::vec4> colours = make_colours();
    const gpu::Buffer source(context(), "colours", colours.size() * sizeof(glm::vec4),
                             VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::BufferPlace::upload);
    std::copy(colours.begin(), colours.end(), source.mapped<glm::vec4>());

    graph::FrameGraph graph(context());
    const graph::ImageId linear = graph.image("linear", {VK_FORMAT_R16G16B16A16_SFLOAT, {width, height}});
    graph::Pass& pass = graph.pass("colours");
    pass.colour(linear, graph::Load::discard).storage(0, graph.buffer("colours", source), false);
    run_program(pass, context(), "from_buffer.frag", {width});
    const graph::ImageId final = passes::tonemap_pass(graph, view, linear, GetParam().curve);
    graph.keep(linear);
    graph.keep(final);
    graph.compile();
    run_frame(context(), graph);

    // The CPU gets the very half floats that the pass read.
    Image input(width, height);
    const auto halves = texels<std::array<uint16_t, 4>>(graph, linear);
    for (size_t i = 0; i < input.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            input.pixels[i][c] = glm::unpackHalf1x16(halves[i][static_cast<size_t>(c)]);
    const Image expected = tonemap(input, GetParam().curve);
    const auto bytes = texels<std::array<uint8_t, 4>>(graph, final);
    double worst = 0;
    size_t bright = 0, dark = 0, away_from_nearest = 0;
    for (size_t i = 0; i < bytes.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double got = bytes[i][static_cast<size_t>(c)], want = 255.0 * expected.pixels[i][c];
            worst = std::max(worst, std::abs(got - want));
            away_from_nearest += std::abs(got - want) > 0.51;
            bright += got > 250;
            dark += got < 5;
        }
    std::printf("    largest difference %.3f/255, %zu values not the nearest\n", worst, away_from_nearest);
    EXPECT_LE(worst, 1);
    EXPECT_LE(away_from_nearest, bytes.size() * 3 / 1000);
    EXPECT_GT(bright, 1000u) << "the ramps reach the top";
    EXPECT_GT(dark, 1000u) << "and the bottom";
    for (const auto& texel : bytes)
        ASSERT_EQ(texel[3], 255);
}
INSTANTIATE_TEST_SUITE_P(Drivers, TonemapPass,
                         testing::Values(Case{Driver::lavapipe, Tonemap::pbr_neutral, "lavapipe_pbr_neutral"},
                                         Case{Driver::lavapipe, Tonemap::aces, "lavapipe_aces"},
                                         Case{Driver::lavapipe, Tonemap::none, "lavapipe_none"},
                                         Case{Driver::swiftshader, Tonemap::pbr_neutral, "swiftshader_pbr_neutral"},
                                         Case{Driver::swiftshader, Tonemap::aces, "swiftshader_aces"},
                                         Case{Driver::swiftshader, Tonemap::none, "swiftshader_none"}),
                         [](const auto& tested) { return std::string(tested.param.name); });

} // namespace
} // namespace prelight
