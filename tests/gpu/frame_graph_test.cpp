// The frame graph: what is culled, what shares memory, what attachments hold. Values tell where they
// came from, and validation with synchronization validation watches every frame.
#include "devices.hpp"
#include "programs.hpp"
#include <gmock/gmock.h>
#include <random>

namespace prelight {
namespace {

using graph::FrameGraph;
using graph::ImageId;
using graph::Load;
using testing::Each;
using testing::ElementsAre;

constexpr graph::ImageDesc floats{VK_FORMAT_R32_SFLOAT, {64, 64}};

class FrameGraphTest : public OnEachDevice {
protected:
    /// An image that a pass clears to `value`.
    ImageId cleared(FrameGraph& graph, const std::string& name, float value, const graph::ImageDesc& desc = floats) {
        const ImageId image = graph.image(name, desc);
        graph.pass("clear " + name).colour(image, Load::clear, {value}).record([](const auto&) {});
        return image;
    }
    /// An image that a pass draws with mix.frag from three others.
    ImageId mixed(FrameGraph& graph, const std::string& name, std::array<ImageId, 3> from, float constant,
                  const graph::ImageDesc& desc = floats) {
        const ImageId image = graph.image(name, desc);
        graph::Pass& pass = graph.pass("mix " + name);
        pass.colour(image, Load::discard).sample(0, from[0]).sample(1, from[1]).sample(2, from[2]);
        run_program(pass, context(), "mix.frag", {constant});
        return image;
    }
};
INSTANTIATE_TEST_SUITE_P(Drivers, FrameGraphTest, testing::Values(Driver::lavapipe, Driver::swiftshader), driver_name);

std::vector<std::string> names(const FrameGraph& graph) {
    std::vector<std::string> all;
    for (const auto& [name, ms] : graph.pass_times()) {
        EXPECT_GE(ms, 0) << name;
        all.push_back(name);
    }
    return all;
}

TEST_P(FrameGraphTest, PassesThatNobodyNeedsAreCulled) {
    FrameGraph graph(context());
    bool prepared = false, recorded = false;
    const ImageId used = cleared(graph, "used", 1);
    const ImageId feeds_unused = cleared(graph, "feeds unused", 2);
    const ImageId unused = graph.image("unused", floats);
    graph.pass("unused")
        .colour(unused, Load::discard)
        .sample(0, feeds_unused)
        .prepare([&](const auto&) { prepared = true; })
        .record([&](const auto&) { recorded = true; });
    const ImageId kept = mixed(graph, "kept", {used, used, used}, 0);
    graph.keep(kept);
    mixed(graph, "after", {kept, kept, kept}, 0);
    graph.compile();
    run_frame(context(), graph);
    EXPECT_THAT(names(graph), ElementsAre("clear used", "mix kept"));
    EXPECT_FALSE(prepared);
    EXPECT_FALSE(recorded);
    EXPECT_THAT(texels<float>(graph, kept), Each(9));
}

TEST_P(FrameGraphTest, AGraphOfWhichNothingIsNeededIsEmpty) {
    FrameGraph graph(context());
    cleared(graph, "unused", 1);
    graph.compile();
    run_frame(context(), graph);
    EXPECT_THAT(names(graph), ElementsAre());
    EXPECT_EQ(graph.memory_bytes(), 0);
}

TEST_P(FrameGraphTest, OnlyKeptImagesAreReadBack) {
    FrameGraph graph(context());
    const ImageId first = cleared(graph, "first", 1);
    const ImageId kept = mixed(graph, "kept", {first, first, first}, 0);
    graph.keep(kept);
    graph.compile();
    run_frame(context(), graph);
    EXPECT_THAT([&] { graph.read_back(first); }, testing::ThrowsMessage<Error>(testing::HasSubstr("first")));
}

TEST_P(FrameGraphTest, ImagesWhoseLifetimesDoNotMeetShareMemory) {
    FrameGraph graph(context());
    ImageId last = cleared(graph, "0", 1);
    constexpr int links = 7;
    for (int i = 1; i < links; ++i)
        last = mixed(graph, std::to_string(i), {last, last, last}, static_cast<float>(i));
    graph.keep(last);
    graph.compile();
    const uint64_t each = 64 * 64 * 4;
    EXPECT_GE(graph.memory_bytes(), 2 * each);
    EXPECT_LT(graph.memory_bytes(), 3 * each) << "a chain needs two at a time, and here are " << links;
    float expected = 1;
    for (int i = 1; i < links; ++i)
        expected = std::fmod(9 * expected + static_cast<float>(i), 4096.0f);
    for (int frame = 0; frame < 3; ++frame) {
        run_frame(context(), graph);
        EXPECT_THAT(texels<float>(graph, last), Each(expected)) << "frame " << frame;
    }
}

// Random graphs: an image that overlaps another one while both live shows a value that is not its own.
TEST_P(FrameGraphTest, ImagesThatAreAliveTogetherNeverOverlap) {
    std::mt19937 random(7); // its numbers are the same everywhere
    uint64_t shared = 0, sum = 0;
    for (int round = 0; round < 8; ++round) {
        FrameGraph graph(context());
        std::vector<ImageId> images;
        std::vector<float> values;
        std::vector<size_t> kept;
        for (uint32_t i = 0; i < 16; ++i) {
            const uint32_t image_width = 8 + random() % 90, image_height = 8 + random() % 90;
            const graph::ImageDesc desc{VK_FORMAT_R32_SFLOAT, {image_width, image_height}};
            const float constant = static_cast<float>(random() % 4096);
            if (i < 2) {
                images.push_back(cleared(graph, std::to_string(i), constant, desc));
                values.push_back(constant);
                continue;
            }
            // Mostly recent images, so that lifetimes end; sometimes any.
            std::array<size_t, 3> from{};
            for (size_t& f : from)
                f = random() % 4 ? images.size() - 1 - random() % 2 : random() % images.size();
            const auto [a, b, c] = from;
            images.push_back(mixed(graph, std::to_string(i), {images[a], images[b], images[c]}, constant, desc));
            values.push_back(std::fmod(values[a] + 3 * values[b] + 5 * values[c] + constant, 4096.0f));
            if (random() % 5 == 0 || i == 15)
                kept.push_back(i);
        }
        for (const size_t k : kept)
            graph.keep(images[k]);
        graph.compile();
        shared += graph.memory_bytes();
        for (const ImageId image : images)
            sum += uint64_t(graph.raster(image).extent.width) * graph.raster(image).extent.height * 4;
        for (int frame = 0; frame < 2; ++frame) {
            run_frame(context(), graph);
            for (const size_t k : kept)
                EXPECT_THAT(texels<float>(graph, images[k]), Each(values[k]))
                    << "round " << round << " image " << k << " frame " << frame;
        }
    }
    EXPECT_LT(shared, sum * 3 / 4) << "these graphs are meant to share";
}

TEST_P(FrameGraphTest, LoadKeepsOrClears) {
    FrameGraph graph(context());
    const graph::ImageDesc colours{VK_FORMAT_R16G16B16A16_SFLOAT, {64, 32}};
    const ImageId kept = graph.image("kept", colours), cleared_again = graph.image("cleared", colours);
    for (const ImageId image : {kept, cleared_again}) {
        graph.pass("clear").colour(image, Load::clear, {1, 2, 3, 4}).record([](const auto&) {});
        graph.pass("nothing").colour(image, Load::keep).record([](const auto&) {});
        const Load load = image == kept ? Load::keep : Load::clear;
        graph::Pass& pass = graph.pass("left half");
        pass.colour(image, load, {16, 16, 16, 16});
        auto program = std::make_shared<std::unique_ptr<Program>>();
        pass.prepare([=, this](const graph::PassInterface& interface) {
            EXPECT_THAT(interface.attachments.colours, ElementsAre(colours.format));
            *program = std::make_unique<Program>(context(), "constant.frag", interface.inputs, interface.attachments);
        });
        pass.record([=](const graph::PassContext& c) {
            EXPECT_EQ(c.extent.width, 64);
            EXPECT_EQ(c.extent.height, 32);
            const VkRect2D left{{0, 0}, {32, 32}};
            vkCmdSetScissor(c.commands, 0, 1, &left);
            (*program)->run(c.commands, c.inputs, {5, 6, 7, 8});
        });
        graph.keep(image);
    }
    graph.compile();
    run_frame(context(), graph);
    const auto half = [](int value) { return static_cast<uint16_t>(value); };
    // 1, 2, 3, 4; 5, 6, 7, 8; 16 as half floats
    const std::array drawn{half(0x4500), half(0x4600), half(0x4700), half(0x4800)};
    const std::array before{half(0x3c00), half(0x4000), half(0x4200), half(0x4400)};
    const std::array<uint16_t, 4> again{0x4c00, 0x4c00, 0x4c00, 0x4c00};
    for (const ImageId image : {kept, cleared_again}) {
        const auto values = texels<std::array<uint16_t, 4>>(graph, image);
        ASSERT_EQ(values.size(), 64 * 32);
        for (size_t i = 0; i < values.size(); ++i)
            ASSERT_EQ(values[i], i % 64 < 32 ? drawn : image == kept ? before : again) << i;
    }
}

TEST_P(FrameGraphTest, ReadingBackTwiceGivesTheSame) {
    FrameGraph graph(context());
    const ImageId kept = cleared(graph, "kept", 3);
    const ImageId depth = graph.image("depth", {VK_FORMAT_D32_SFLOAT, {16, 16}});
    graph.pass("depth").depth_write(depth).record([](const auto&) {});
    graph.keep(kept);
    graph.keep(depth);
    graph.compile();
    for (int frame = 0; frame < 2; ++frame) {
        run_frame(context(), graph);
        for (int time = 0; time < 2; ++time) {
            EXPECT_THAT(texels<float>(graph, kept), Each(3));
            EXPECT_THAT(texels<float>(graph, depth), Each(0)) << "reversed depth: 0 is the far end";
        }
    }
}

// Both aspects move together; shaders and copies see depth.
TEST_P(FrameGraphTest, DepthWithStencilIsTestedSampledAndReadBack) {
    for (const VkFormat format : {VK_FORMAT_D24_UNORM_S8_UINT, VK_FORMAT_D32_SFLOAT_S8_UINT}) {
        if (!context().supports(format, VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT))
            continue;
        FrameGraph graph(context());
        const ImageId depth = graph.image("depth", {{64, 64}}, {format});
        const ImageId seen = graph.image("seen", floats);
        graph.pass("depth").depth_write(depth).record([](const auto&) {});
        graph::Pass& pass = graph.pass("test and sample");
        pass.colour(seen, Load::clear).depth_test(depth).sample(0, depth);
        pass.record([](const auto&) {});
        const ImageId mix = mixed(graph, "mix", {depth, seen, depth}, 7);
        graph.keep(depth);
        graph.keep(mix);
        graph.compile();
        for (int frame = 0; frame < 2; ++frame) {
            run_frame(context(), graph);
            EXPECT_THAT(texels<uint32_t>(graph, depth), testing::AllOf(testing::SizeIs(64 * 64), Each(0)));
            EXPECT_THAT(texels<float>(graph, mix), Each(7));
        }
    }
}

TEST_P(FrameGraphTest, StencilOfSomeFormatIsAlwaysThere) {
    FrameGraph graph(context());
    const ImageId depth = graph.image("depth", {{64, 64}}, {VK_FORMAT_D24_UNORM_S8_UINT, VK_FORMAT_D32_SFLOAT_S8_UINT});
    const bool d24 = graph.desc(depth).format == VK_FORMAT_D24_UNORM_S8_UINT;
    EXPECT_EQ(d24, context().supports(VK_FORMAT_D24_UNORM_S8_UINT, VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT));
    EXPECT_EQ(graph.notes().size(), d24 ? 0u : 1u);
}

// Frames in one submission: nothing but the graph's own barriers stands between them.
TEST_P(FrameGraphTest, FramesFollowEachOtherWithoutAWait) {
    FrameGraph graph(context());
    ImageId last = cleared(graph, "0", 1);
    for (int i = 1; i < 4; ++i)
        last = mixed(graph, std::to_string(i), {last, last, last}, 1);
    graph.keep(last);
    graph.compile();
    context().run("two frames", [&](VkCommandBuffer commands) {
        graph.record(commands);
        graph.record(commands);
    });
    EXPECT_THAT(texels<float>(graph, last), Each(820)); // 1, 10, 91, 820
}

} // namespace
} // namespace prelight
