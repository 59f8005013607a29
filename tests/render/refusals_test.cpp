// What a renderer refuses, and with which words.
#include "garden.hpp"
#include <prelight/error.hpp>

namespace prelight {
namespace {

template <class E>
std::string refusal(const RenderOptions& options) {
    try {
        create_renderer("light-prepass", &test_device(), options);
    } catch (const E& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Refusals, SettingsAndCombinations) {
    RenderOptions options;
    options.settings = {{"normals", "oct99"}};
    EXPECT_THAT(refusal<UsageError>(options), testing::HasSubstr("oct24"));
    options.settings = {{"nonsense", "1"}};
    EXPECT_THAT(refusal<UsageError>(options), testing::HasSubstr("nonsense"));
    options.settings = {{"model", "full"}};
    EXPECT_THAT(refusal<UsageError>(options), testing::HasSubstr("reference"));
    options.settings = {{"model", "mono"}};
    EXPECT_THAT(refusal<UsageError>(options), testing::HasSubstr("packed"));
    options.settings = {{"model", "weighted"}, {"light-buffer", "packed-rgba8"}};
    EXPECT_THAT(refusal<UsageError>(options), testing::HasSubstr("mono"));
    options.settings = {{"light-scale", "zero"}};
    EXPECT_THAT(refusal<UsageError>(options), testing::HasSubstr("0.01"));
    options.settings = {};
    options.msaa = 3;
    EXPECT_THAT(refusal<UsageError>(options), testing::HasSubstr("--msaa"));
    options.msaa = 1;
    options.views = {"nothing"};
    EXPECT_THAT(refusal<UsageError>(options), testing::HasSubstr("nothing"));
    options.views = {};
    options.preset = "nothing";
    EXPECT_THAT(refusal<UsageError>(options), testing::HasSubstr("nothing"));
}

TEST(Refusals, PictureSizes) {
    RenderOptions options;
    options.width = 0;
    EXPECT_THAT(refusal<Error>(options), testing::HasSubstr("0x720"));
    options.width = 1u << 20;
    EXPECT_THAT(refusal<Error>(options), testing::HasSubstr("limit"));
}

TEST(Refusals, UnknownRendererAndViewsNotAskedFor) {
    EXPECT_THROW(create_renderer("nonsense", &test_device(), {}), UsageError);
    EXPECT_THROW(create_renderer("light-prepass", nullptr, {}), Error);
    Garden garden;
    const auto renderer = create_renderer("light-prepass", &test_device(), {.width = 8, .height = 8});
    EXPECT_THROW(renderer->render(garden.camera), Error);
    renderer->set_world(garden.world);
    renderer->render(garden.camera);
    EXPECT_THROW(renderer->read("depth"), UsageError);
}

} // namespace
} // namespace prelight
