// Passes of a program's own between those of a renderer: prelight/vulkan.hpp.
#include "garden.hpp"
#include <algorithm>
#include <prelight/error.hpp>
#include <prelight/vulkan.hpp>

namespace prelight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;
using PassStage = vulkan::Stage;

constexpr uint32_t pass_width = 96, pass_height = 54;

/// Fills the left half of everything that a pass writes.
struct Paint {
    std::array<float, 4> colour{};
    int prepared = 0, recorded = 0;
    vulkan::PassImages images{};

    vulkan::Pass pass(PassStage stage, std::vector<std::string> writes, std::vector<std::string> reads = {}) {
        return {.name = "paint",
                .stage = stage,
                .reads = std::move(reads),
                .writes = std::move(writes),
                .prepare =
                    [this](const vulkan::PassImages& now) {
                        ++prepared;
                        images = now;
                    },
                .record = [this](const vulkan::PassFrame& frame) { record(frame); }};
    }

    void record(const vulkan::PassFrame& frame) {
        ++recorded;
        EXPECT_EQ(frame.images.writes.size(), images.writes.size());
        if (frame.images.writes.empty())
            return;
        std::vector<VkClearAttachment> clears;
        for (uint32_t i = 0; i < frame.images.writes.size(); ++i) {
            VkClearAttachment& clear = clears.emplace_back();
            clear = {VK_IMAGE_ASPECT_COLOR_BIT, i, {}};
            std::ranges::copy(colour, clear.clearValue.color.float32);
        }
        const VkExtent2D extent = frame.images.writes[0].extent;
        const VkClearRect left{{{0, 0}, {extent.width / 2, extent.height}}, 0, 1};
        vkCmdClearAttachments(frame.commands, uint32_t(clears.size()), clears.data(), 1, &left);
    }
};

struct PaintedGarden : Garden {
    PaintedGarden() { add_lights(20, 3, 4); }
    std::unique_ptr<Renderer> renderer(const char* name = "light-prepass", uint32_t samples = 1,
                                       std::vector<std::string> views = {}) const {
        auto made =
            create_renderer(name, &test_device(),
                            {.width = pass_width, .height = pass_height, .msaa = samples, .views = std::move(views)});
        made->set_world(world);
        return made;
    }
    Image picture(Renderer& drawn, const char* view = "final") const {
        drawn.render(camera);
        return drawn.read(view);
    }
};

/// The left half of `painted` is one colour, the right half that of `plain`.
void expect_painted(const Image& painted, const Image& plain, glm::vec3 colour, float tolerance = 0) {
    for (uint32_t y = 0; y < pass_height; ++y)
        for (uint32_t x = 0; x < pass_width; ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(painted.at(x, y)[c], x < pass_width / 2 ? colour[c] : plain.at(x, y)[c], tolerance)
                    << x << " " << y;
}

class OwnPass : public testing::Test {
protected:
    void TearDown() override { expect_validation_clean(test_device()); }
    const PaintedGarden garden_;
};

TEST_F(OwnPass, DrawsOverTheFinishedPictureOfEveryArchitecture) {
    for (const RendererInfo& info : renderer_infos()) {
        if (!info.needs_device)
            continue;
        SCOPED_TRACE(info.name);
        const auto renderer = garden_.renderer(info.name.c_str());
        const Image plain = garden_.picture(*renderer);
        Paint paint{.colour = {1, 0, 1, 1}};
        const uint64_t pass = vulkan::add_pass(*renderer, paint.pass(PassStage::after_display, {"picture"}));
        expect_painted(garden_.picture(*renderer), plain, {1, 0, 1});
        EXPECT_EQ(paint.prepared, 1);
        EXPECT_EQ(paint.recorded, 1);
        vulkan::remove_pass(*renderer, pass);
        EXPECT_TRUE(garden_.picture(*renderer).pixels == plain.pixels);
        EXPECT_EQ(paint.recorded, 1);
    }
}

TEST_F(OwnPass, DrawsIntoTheSceneLinearPicture) {
    const Image expected = tonemap(
        [] {
            Image one(1, 1);
            one.at(0, 0) = {0.5f, 0.25f, 0.125f};
            return one;
        }(),
        Tonemap::pbr_neutral);
    for (const PassStage stage : {PassStage::after_opaque, PassStage::before_display})
        for (const uint32_t samples : {1u, 4u})
            for (const char* name : {"light-prepass", "multipass"}) {
                SCOPED_TRACE(name);
                const auto renderer = garden_.renderer(name, samples);
                Paint paint{.colour = {0.5f, 0.25f, 0.125f, 1}};
                vulkan::Pass pass = paint.pass(stage, {"picture"});
                pass.depth_test = true;
                vulkan::add_pass(*renderer, std::move(pass));
                const Image plain = garden_.picture(*garden_.renderer(name, samples, {"linear"}));
                expect_painted(garden_.picture(*renderer), plain, expected.at(0, 0), 1.01f / 255);
                EXPECT_EQ(paint.images.writes.at(0).samples, samples);
                EXPECT_EQ(paint.images.depth_test->samples, samples);
            }
}

// What a pass leaves of the light is what materials find.
TEST_F(OwnPass, WritesTheLightBuffer) {
    const auto renderer = garden_.renderer("light-prepass");
    Paint black;
    RenderOptions options{.width = pass_width, .height = pass_height};
    options.settings = {{"light-culling", "volumes"}};
    const auto drawn = create_renderer("light-prepass", &test_device(), options);
    drawn->set_world(garden_.world);
    vulkan::add_pass(*drawn,
                     black.pass(PassStage::after_light, {"diffuse-light", "specular-light"}, {"depth", "normal"}));
    const Image picture = garden_.picture(*drawn);
    const auto dark = garden_.renderer("light-prepass");
    dark->set_lights({});
    const Image unlit = garden_.picture(*dark), lit = garden_.picture(*renderer);
    for (uint32_t y = 0; y < pass_height; ++y)
        for (uint32_t x = 0; x < pass_width; ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(picture.at(x, y)[c], (x < pass_width / 2 ? unlit : lit).at(x, y)[c], 2.01f / 255)
                    << x << " " << y;
}

TEST_F(OwnPass, ReadsSurfacesWithoutWritingAnything) {
    for (const char* name : {"light-prepass", "deferred", "z-prepass"}) {
        SCOPED_TRACE(name);
        const auto renderer = garden_.renderer(name);
        const Image plain = garden_.picture(*renderer);
        Paint looks;
        vulkan::add_pass(*renderer, looks.pass(PassStage::after_surfaces, {}, {"depth"}));
        EXPECT_TRUE(garden_.picture(*renderer).pixels == plain.pixels);
        EXPECT_EQ(looks.recorded, 1);
        ASSERT_EQ(looks.images.reads.size(), 1u);
        EXPECT_EQ(looks.images.reads[0].name, "depth");
        EXPECT_NE(looks.images.reads[0].view, VkImageView(VK_NULL_HANDLE));
        EXPECT_EQ(looks.images.reads[0].extent.width, pass_width);
        EXPECT_EQ(looks.images.reads[0].layout, VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL);
        const Stats stats = renderer->stats();
        const auto at = [&](std::string_view pass) {
            return std::ranges::find(stats.passes, pass, &PassStats::name) - stats.passes.begin();
        };
        EXPECT_LT(size_t(at("paint")), stats.passes.size() - 1);
    }
}

TEST_F(OwnPass, FollowsSizeAndWorld) {
    const auto renderer = garden_.renderer();
    Paint paint{.colour = {0, 1, 0, 1}};
    vulkan::add_pass(*renderer, paint.pass(PassStage::after_display, {"picture"}, {"depth"}));
    garden_.picture(*renderer);
    renderer->resize(40, 20);
    garden_.picture(*renderer);
    EXPECT_EQ(paint.images.writes.at(0).extent.width, 40u);
    EXPECT_EQ(paint.images.reads.at(0).extent.height, 20u);
    renderer->set_world(garden_.world);
    EXPECT_EQ(garden_.picture(*renderer).at(0, 0), glm::vec3(0, 1, 0));
    EXPECT_EQ(paint.prepared, 3);
    EXPECT_EQ(paint.recorded, 3);
}

TEST_F(OwnPass, ComesAfterThoseThatWereAddedBefore) {
    const auto renderer = garden_.renderer();
    Paint red{.colour = {1, 0, 0, 1}}, blue{.colour = {0, 0, 1, 1}};
    vulkan::add_pass(*renderer, red.pass(PassStage::after_display, {"picture"}));
    vulkan::add_pass(*renderer, blue.pass(PassStage::after_display, {"picture"}));
    EXPECT_EQ(garden_.picture(*renderer).at(0, 0), glm::vec3(0, 0, 1));
}

TEST_F(OwnPass, KnowsTheCamera) {
    const auto renderer = garden_.renderer();
    std::vector<glm::dvec3> eyes;
    glm::vec4 middle{0};
    vulkan::add_pass(*renderer, {.name = "looks", .writes = {"picture"}, .record = [&](const vulkan::PassFrame& frame) {
                                     eyes.push_back(frame.eye);
                                     const glm::dvec3 ahead = garden_.camera.position - 3.0 * garden_.camera.axes[2];
                                     middle = frame.clip_from_world * glm::vec4(glm::vec3(ahead - frame.eye), 1);
                                 }});
    garden_.picture(*renderer);
    EXPECT_THAT(eyes, ElementsAre(garden_.camera.position));
    EXPECT_NEAR(middle.x / middle.w, 0, 1e-6);
    EXPECT_NEAR(middle.y / middle.w, 0, 1e-6);
    EXPECT_NEAR(middle.w, 3, 1e-5);
}

TEST_F(OwnPass, RefusesWhatThereIsNot) {
    const auto renderer = garden_.renderer();
    const Image plain = garden_.picture(*renderer);
    Paint paint;
    const auto refusal = [&](Renderer& drawn, vulkan::Pass pass, const char* reason) {
        EXPECT_THAT([&] { vulkan::add_pass(drawn, pass); }, ThrowsMessage<UsageError>(HasSubstr(reason)));
    };
    refusal(*renderer, paint.pass(PassStage::after_display, {"light"}),
            "light: no such image at after_display (there are: picture, depth, normal)");
    refusal(*renderer, paint.pass(PassStage::after_surfaces, {"depth"}), "the depth buffer");
    refusal(*renderer, paint.pass(PassStage::after_display, {"picture"}, {"picture"}), "read or written already");
    refusal(*renderer, {.name = "nothing"}, "record() is missing");
    refusal(*garden_.renderer("multipass"), paint.pass(PassStage::after_light, {}),
            "this renderer has no stage after_light");
    vulkan::Pass tested = paint.pass(PassStage::after_display, {"picture"});
    tested.depth_test = true;
    refusal(*garden_.renderer("light-prepass", 4), tested, "depth has 4 samples");
    EXPECT_THROW(vulkan::remove_pass(*renderer, 99), UsageError);
    EXPECT_TRUE(garden_.picture(*renderer).pixels == plain.pixels) << "none of them was added";
    EXPECT_EQ(paint.recorded, 0);
}

} // namespace
} // namespace prelight
