// --view sample=N, depth-sample=N and normal-sample=N: one sample of each pixel, against the reference's own.
#include "garden.hpp"
#include <cmath>
#include <prelight/error.hpp>
#include <prelight/views.hpp>

namespace prelight {
namespace {

using testing::HasSubstr;

std::unique_ptr<Renderer> with_sample_views(const Shot& shot, std::vector<std::string> views) {
    RenderOptions options = options_of(shot);
    options.views = std::move(views);
    auto renderer = create_renderer(shot.renderer, shot.renderer == "reference" ? nullptr : &test_device(), options);
    renderer->set_world(*shot.world);
    renderer->render(shot.camera);
    return renderer;
}

/// Pixels that are off by more than 2/255 in a channel, of those that the reference can judge.
size_t pixels_off(const Image& shown, const Image& right, const std::vector<uint8_t>& left_out = {}) {
    size_t off = 0;
    for (size_t i = 0; i < shown.pixels.size(); ++i) {
        const glm::vec3 apart = glm::abs(shown.pixels[i] - right.pixels[i]);
        off += (left_out.empty() || !left_out[i]) && std::max({apart.r, apart.g, apart.b}) > 2.0f / 255;
    }
    return off;
}

TEST(SampleView, AgreesWithTheReference) {
    Garden garden;
    garden.add_lights(6, 5, 6);
    Shot shot = garden.shot();
    shot.width = 112;
    shot.height = 63;
    shot.samples = 4;
    for (const std::string& name : device_renderers) {
        const bool forward = name == "z-prepass" || name == "multipass";
        std::vector<std::string> views{"final"};
        for (const char* of : {"sample=", "depth-sample=", "normal-sample="})
            for (uint32_t i = 0; i < 4 && !(forward && *of == 'n'); ++i)
                views.push_back(of + std::to_string(i));
        shot.renderer = name;
        shot.settings = {};
        const auto renderer = with_sample_views(shot, views);
        const std::vector<uint8_t> left_out =
            render_reference(garden.world, shot.camera, shot.width, shot.height, 0, form_of(shot)).left_out();
        shot.renderer = "reference";
        shot.settings = {{"model", name == "light-prepass" ? "weighted" : "full"},
                         {"msaa-light", forward ? "fragment" : "edges"},
                         {"msaa-material", "fragment"},
                         {"msaa-geometry", "fragment"}};
        const auto truth = with_sample_views(shot, views);
        Image mean(shot.width, shot.height);
        for (const std::string& view : views) {
            SCOPED_TRACE(name + " " + view);
            const Image shown = renderer->read(view);
            EXPECT_LE(pixels_off(shown, truth->read(view), left_out), shown.pixels.size() / 1000);
            if (view.starts_with("sample="))
                for (size_t i = 0; i < mean.pixels.size(); ++i)
                    for (int c = 0; c < 3; ++c)
                        mean.pixels[i][c] += srgb_decode(shown.pixels[i][c]) / 4;
            if (view.ends_with("=1")) { // another sample than the first
                const Image zero = renderer->read(view.substr(0, view.size() - 1) + "0");
                EXPECT_GT(pixels_off(shown, zero), 30u);
            }
        }
        for (glm::vec3& pixel : mean.pixels)
            for (int c = 0; c < 3; ++c)
                pixel[c] = srgb_encode(pixel[c]);
        EXPECT_EQ(pixels_off(mean, renderer->read("final")), 0u) << name;
    }
    expect_validation_clean(test_device());
}

TEST(SampleView, GoesWithALinearPictureToo) {
    Garden garden;
    garden.add_lights(4, 5, 6);
    Shot shot = garden.shot();
    shot.width = 96;
    shot.height = 54;
    shot.samples = 4;
    for (const std::string& name : device_renderers) {
        shot.renderer = name;
        const auto both = with_sample_views(shot, {"linear", "sample=2"}), one = with_sample_views(shot, {"sample=2"});
        EXPECT_EQ(pixels_off(both->read("sample=2"), one->read("sample=2")), 0u) << name;
    }
    expect_validation_clean(test_device());
}

TEST(SampleView, IsNamedByANumberOfAPixelsSamples) {
    EXPECT_EQ(sample_of_view("sample=3")->sample, 3u);
    EXPECT_EQ(sample_of_view("sample=3")->buffer, "final");
    EXPECT_EQ(sample_of_view("depth-sample=0")->buffer, "depth");
    EXPECT_EQ(sample_of_view("normal-sample=1")->buffer, "normal");
    for (const char* name : {"sample=4", "sample=-1", "sample=", "sample", "sample=00", "albedo-sample=1", "Sample=1"})
        EXPECT_FALSE(sample_of_view(name)) << name;
    const Garden garden;
    const auto refusal = [&](const char* renderer, const char* view, uint32_t samples) -> std::string {
        Shot shot = garden.shot();
        shot.renderer = renderer;
        shot.samples = samples;
        try {
            with_sample_views(shot, {view});
        } catch (const UsageError& error) {
            return error.what();
        }
        return "nothing";
    };
    for (const char* renderer : {"light-prepass", "reference"}) {
        EXPECT_THAT(refusal(renderer, "sample=1", 1), HasSubstr("--view sample=1: needs --msaa 2 or 4, and it is 1"));
        EXPECT_THAT(refusal(renderer, "depth-sample=3", 1), HasSubstr("needs --msaa 4, and it is 1"));
        EXPECT_THAT(refusal(renderer, "sample=4", 4), HasSubstr("sample=0 … sample=3"));
    }
    EXPECT_THAT(refusal("reference", "sample=2", 2), HasSubstr("needs --msaa 4, and it is 2"));
    EXPECT_THAT(refusal("z-prepass", "normal-sample=1", 4), HasSubstr("depth-sample=0 … depth-sample=3"));
    EXPECT_THAT(refusal("inferred", "sample=0", 1), HasSubstr("inferred has final"));
}

} // namespace
} // namespace prelight
