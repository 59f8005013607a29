// Images that outlive a frame, and passes that draw into another image between their own draws; with
// synchronization validation on both drivers.
#include "devices.hpp"
#include "programs.hpp"
#include <gmock/gmock.h>

namespace prelight {
namespace {

using graph::FrameGraph;
using graph::ImageId;
using graph::Load;
using testing::Each;

constexpr VkExtent2D square_extent{64, 64};

/// Clears a part of the depth attachment.
void clear_depth(VkCommandBuffer commands, float depth, VkRect2D area) {
    VkClearAttachment clear{};
    clear.aspectMask = VK_IMAGE_ASPECT_DEPTH_BIT;
    clear.clearValue.depthStencil.depth = depth;
    const VkClearRect cleared{area, 0, 1};
    vkCmdClearAttachments(commands, 1, &clear, 1, &cleared);
}

class FrameGraphPersistTest : public OnEachDevice {};
INSTANTIATE_TEST_SUITE_P(Drivers, FrameGraphPersistTest, testing::Values(Driver::lavapipe, Driver::swiftshader),
                         driver_name);

TEST_P(FrameGraphPersistTest, WhatOneFrameDrewIsThereInTheNext) {
    FrameGraph graph(context());
    const ImageId image = graph.image("atlas", {VK_FORMAT_D32_SFLOAT, square_extent});
    graph.persist(image);
    graph.keep(image);
    int frame = 0;
    graph.pass("part").depth_write(image, Load::keep).record([&](const graph::PassContext& pass) {
        clear_depth(pass.commands, frame == 0 ? 0.25f : 0.5f, {{frame == 0 ? 0 : 32, 0}, {32, 64}});
        ++frame;
    });
    // It would lie in the same memory, for its pass comes when the atlas is done.
    const ImageId other = graph.image("other", {VK_FORMAT_R32_SFLOAT, square_extent});
    graph.pass("other").colour(other, Load::clear, {7}).record([](const auto&) {});
    graph.keep(other);
    graph.compile();
    run_frame(context(), graph);
    run_frame(context(), graph);
    const std::vector<float> depth = texels<float>(graph, image);
    for (size_t i = 0; i < depth.size(); ++i)
        ASSERT_EQ(depth[i], i % 64 < 32 ? 0.25f : 0.5f) << i;
}

// Each frame draws another column; images that only the frame needs are drawn before and after.
TEST_P(FrameGraphPersistTest, AColourImageIsEmptyBeforeItsFirstFrame) {
    FrameGraph graph(context());
    const graph::ImageDesc colours{VK_FORMAT_R16G16B16A16_SFLOAT, {64, 32}};
    const ImageId early = graph.image("early", colours), image = graph.image("columns", colours),
                  seen = graph.image("seen", colours);
    graph.pass("early").colour(early, Load::clear, {9, 9, 9, 9}).record([](const auto&) {});
    int32_t column = 0;
    graph::Pass& pass = graph.pass("one column");
    pass.colour(image, Load::keep).sample(0, early);
    auto program = std::make_shared<std::unique_ptr<Program>>();
    pass.prepare([=, this](const graph::PassInterface& interface) {
        *program = std::make_unique<Program>(context(), "constant.frag", interface.inputs, interface.attachments);
    });
    pass.record([=, &column](const graph::PassContext& c) {
        const VkRect2D one{{column, 0}, {1, 32}};
        vkCmdSetScissor(c.commands, 0, 1, &one);
        (*program)->run(c.commands, c.inputs, {1, 1, 1, 1});
    });
    graph.pass("late").colour(seen, Load::clear, {9, 9, 9, 9}).sample(0, image).record([](const auto&) {});
    graph.persist(image);
    graph.keep(image);
    graph.keep(seen);
    graph.compile();
    for (; column < 3; ++column) {
        run_frame(context(), graph);
        const auto values = texels<std::array<uint16_t, 4>>(graph, image);
        for (size_t i = 0; i < values.size(); ++i)
            ASSERT_EQ(values[i][0], static_cast<int32_t>(i % 64) <= column ? 0x3c00 : 0) << i << ", frame " << column;
    }
}

// Each draw sees what was drawn just before it, and none of the pass's own pixels is lost.
TEST_P(FrameGraphPersistTest, DrawsBetweenThePassesOwn) {
    FrameGraph graph(context());
    const ImageId maps = graph.image("maps", {VK_FORMAT_D32_SFLOAT, square_extent});
    graph.persist(maps);
    const ImageId zero = graph.image("zero", {VK_FORMAT_R32_SFLOAT, square_extent});
    graph.pass("zero").colour(zero, Load::clear, {0}).record([](const auto&) {});
    const ImageId target = graph.image("target", {VK_FORMAT_R32_SFLOAT, square_extent});
    graph::Pass& pass = graph.pass("lights");
    pass.colour(target, Load::clear, {9}).draws_between(0, maps).sample(1, zero).sample(2, zero);
    std::optional<Program> program;
    pass.prepare([&](const graph::PassInterface& interface) {
        program.emplace(context(), "mix.frag", interface.inputs, interface.attachments);
    });
    pass.record([&](const graph::PassContext& now) {
        for (int strip = 0; strip < 3; ++strip) { // the fourth stays cleared
            now.between([&] { clear_depth(now.commands, 0.25f * float(strip + 1), {{0, 0}, square_extent}); });
            const VkRect2D area{{16 * strip, 0}, {16, 64}};
            vkCmdSetScissor(now.commands, 0, 1, &area);
            program->run(now.commands, now.inputs);
        }
    });
    graph.keep(target);
    graph.compile();
    for (int frame = 0; frame < 2; ++frame) {
        run_frame(context(), graph);
        const std::vector<float> values = texels<float>(graph, target);
        const float expected[] = {0.25f, 0.5f, 0.75f, 9};
        for (size_t i = 0; i < values.size(); ++i)
            ASSERT_EQ(values[i], expected[i % 64 / 16]) << "frame " << frame << ", texel " << i;
    }
}

} // namespace
} // namespace prelight
