// At the end of the pass that shades: the picture without a linear image in between.
#include "garden.hpp"
#include <cmath>

namespace prelight {
namespace {

struct FinishingWay {
    const char* renderer;
    std::map<std::string, std::string> settings;
    Shading shading;
    std::vector<std::string> passes; ///< the last two
};
void PrintTo(const FinishingWay& way, std::ostream* out) { *out << way.renderer; }

class FinishedPicture : public testing::TestWithParam<FinishingWay> {
protected:
    FinishedPicture() {
        garden_.add_light(garden_.point(12, 40), {0, 4, 2});
        garden_.add_light(garden_.point(9, 300, {1.0f, 0.3f, 0.2f}), {-3, 3, 1}); // beyond white
    }

    RenderOptions options(Tonemap curve) const {
        RenderOptions options{.width = 160, .height = 90, .shading = GetParam().shading, .tonemap = curve};
        options.exposure = 1;
        options.settings = GetParam().settings;
        return options;
    }

    std::unique_ptr<Renderer> render(const RenderOptions& options) const {
        auto renderer = create_renderer(GetParam().renderer, &test_device(), options);
        renderer->set_world(garden_.world);
        renderer->render(garden_.camera);
        return renderer;
    }

    Garden garden_;
};

TEST_P(FinishedPicture, IsTheToneMappedLinearOne) {
    for (const Tonemap curve : {Tonemap::pbr_neutral, Tonemap::aces, Tonemap::none}) {
        const auto renderer = render(options(curve));
        RenderOptions asks = options(curve);
        asks.views = {"linear"};
        const auto with_linear = render(asks);
        const Image ours = renderer->read("final"), linear = with_linear->read("linear");
        const Image expected = tonemap(linear, curve), in_two_passes = with_linear->read("final");
        size_t differ = 0, white = 0, between = 0;
        for (size_t i = 0; i < ours.pixels.size(); ++i)
            for (int c = 0; c < 3; ++c) {
                const float got = 255 * ours.pixels[i][c], want = 255 * expected.pixels[i][c];
                // Half a code, and what the half float in between is off.
                ASSERT_LE(std::abs(got - want), 0.75f) << "pixel " << i;
                differ += std::abs(got - 255 * in_two_passes.pixels[i][c]) > 0.5f;
                white += got > 250;
                between += got > 20 && got < 230;
            }
        EXPECT_LE(differ, ours.pixels.size() * 3 / 50);
        EXPECT_GT(white, 100u);
        EXPECT_GT(between, 1000u);
    }
    expect_validation_clean(test_device());
}

TEST_P(FinishedPicture, NeedsNoPassOfItsOwn) {
    const auto last = [](const Stats& stats) { return stats.passes.back().name; };
    RenderOptions asks = options(Tonemap::pbr_neutral);
    const auto renderer = render(asks);
    EXPECT_EQ(last(renderer->stats()), GetParam().passes[0]);
    asks.views = {"linear"};
    const auto with_linear = render(asks);
    EXPECT_EQ(last(with_linear->stats()), GetParam().passes[1]);
    EXPECT_LT(renderer->stats().attachment_bytes_unshared, with_linear->stats().attachment_bytes_unshared);

    // Whoever reads it all the same gets it, and the figures stay those of what was rendered.
    const Image linear = renderer->read("linear");
    EXPECT_TRUE(linear.pixels == with_linear->read("linear").pixels);
    EXPECT_EQ(last(renderer->stats()), GetParam().passes[0]);
    expect_validation_clean(test_device());
}

INSTANTIATE_TEST_SUITE_P(All, FinishedPicture,
                         testing::Values(FinishingWay{"light-prepass", {}, Shading::ggx, {"material", "tonemap"}},
                                         FinishingWay{"light-prepass", {}, Shading::phong, {"material", "tonemap"}},
                                         FinishingWay{"deferred", {}, Shading::ggx, {"resolve", "tonemap"}},
                                         FinishingWay{
                                             "z-prepass", {{"lights", "grid"}}, Shading::ggx, {"opaque", "tonemap"}}),
                         [](const auto& tested) {
                             std::string name = std::string(tested.param.renderer) +
                                                (tested.param.shading == Shading::ggx ? "Ggx" : "Phong");
                             std::erase(name, '-');
                             return name;
                         });

TEST(FinishedPictures, LightPrepassHolds24BytesAPixel) {
    Garden garden;
    const RenderOptions options{.width = 320, .height = 192};
    const auto renderer = create_renderer("light-prepass", &test_device(), options);
    renderer->set_world(garden.world);
    renderer->render(garden.camera);
    EXPECT_LE(renderer->stats().attachment_bytes, 24u * options.width * options.height);
}

} // namespace
} // namespace prelight
