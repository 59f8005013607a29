// Storage buffers in the frame graph: a write is seen by the next pass and by the host.
#include "devices.hpp"
#include "programs.hpp"
#include "vulkan_spy.hpp"
#include <algorithm>

namespace prelight {
namespace {

constexpr uint32_t elements = 1 << 16;

class FrameGraphBuffers : public OnEachDevice {
protected:
    gpu::Buffer make(const char* name) {
        gpu::Buffer buffer(context(), name, elements * 4, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                           gpu::BufferPlace::readback);
        std::fill_n(buffer.mapped<uint32_t>(), elements, 0xdeadbeef);
        return buffer;
    }
    graph::Pass& counts(graph::FrameGraph& graph, graph::BufferId target, float first) {
        graph::Pass& pass = graph.pass("count");
        pass.storage(0, target, true);
        run_program(pass, context(), "count.comp", {first}, elements / 64);
        return pass;
    }
    graph::Pass& mirrors(graph::FrameGraph& graph, graph::BufferId source, graph::BufferId target) {
        graph::Pass& pass = graph.pass("mirror");
        pass.storage(0, source, false).storage(1, target, true);
        run_program(pass, context(), "mirror.comp", {}, elements / 64);
        return pass;
    }
};
INSTANTIATE_TEST_SUITE_P(Drivers, FrameGraphBuffers, testing::Values(Driver::lavapipe, Driver::swiftshader),
                         driver_name);

TEST_P(FrameGraphBuffers, AWriteIsSeenByTheNextPassAndByTheHost) {
    const gpu::Buffer first = make("first"), second = make("second");
    graph::FrameGraph graph(context());
    const graph::BufferId a = graph.buffer("first", first), b = graph.buffer("second", second);
    counts(graph, a, 5);
    mirrors(graph, a, b);
    graph.compile();
    for (int frame = 0; frame < 2; ++frame) {
        run_frame(context(), graph);
        for (uint32_t i = 0; i < elements; ++i) {
            ASSERT_EQ(first.mapped<uint32_t>()[i], i + 5);
            ASSERT_EQ(second.mapped<uint32_t>()[i], 2 * (elements - 1 - i + 5));
        }
        std::fill_n(second.mapped<uint32_t>(), elements, 0u);
    }
}

// Two names for one buffer would be two buffers to the barriers, and no pass would wait for the other.
TEST_P(FrameGraphBuffers, TheSameBufferHasTheSameId) {
    const gpu::PerFrame<gpu::Buffer> turns{make("a"), make("b")};
    graph::FrameGraph graph(context());
    const graph::BufferId both = graph.buffer("turns", turns), first = graph.buffer("first", turns[0]);
    EXPECT_EQ(graph.buffer("again", turns).index, both.index);
    EXPECT_EQ(graph.buffer("first again", turns[0]).index, first.index);
    EXPECT_NE(both.index, first.index);
    EXPECT_NE(graph.buffer("second", turns[1]).index, first.index);
}

// Neither validation nor a driver without caches of its own notices when this one is missing.
TEST_P(FrameGraphBuffers, TheHostsReadWaitsForEveryWrite) {
    const gpu::Buffer first = make("first"), second = make("second");
    graph::FrameGraph graph(context());
    const graph::BufferId a = graph.buffer("first", first), b = graph.buffer("second", second);
    counts(graph, a, 5);
    mirrors(graph, a, b);
    graph.compile();
    const VulkanSpy spy;
    run_frame(context(), graph);
    for (const gpu::Buffer* buffer : {&first, &second}) {
        const auto last = std::find_if(spy.buffer_barriers.rbegin(), spy.buffer_barriers.rend(),
                                       [&](const auto& seen) { return seen.buffer == buffer->handle(); });
        ASSERT_NE(last, spy.buffer_barriers.rend());
        EXPECT_EQ(last->dstStageMask, VK_PIPELINE_STAGE_2_HOST_BIT);
        EXPECT_EQ(last->dstAccessMask, VK_ACCESS_2_HOST_READ_BIT);
        EXPECT_TRUE(last->srcStageMask & VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT);
        EXPECT_TRUE(last->srcAccessMask & VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
    }
}

// Write, read, write again: the second write waits for the read, and the last value is the second's.
TEST_P(FrameGraphBuffers, AWriteAfterAReadAndAWriteAfterAWriteWait) {
    const gpu::Buffer first = make("first"), second = make("second");
    graph::FrameGraph graph(context());
    const graph::BufferId a = graph.buffer("first", first), b = graph.buffer("second", second);
    counts(graph, a, 5);
    mirrors(graph, a, b);
    counts(graph, a, 1000);
    counts(graph, a, 2000);
    graph.compile();
    run_frame(context(), graph);
    for (uint32_t i = 0; i < elements; ++i) {
        ASSERT_EQ(first.mapped<uint32_t>()[i], i + 2000);
        ASSERT_EQ(second.mapped<uint32_t>()[i], 2 * (elements - 1 - i + 5));
    }
}

TEST_P(FrameGraphBuffers, FramesFollowEachOtherWithoutAWait) {
    const gpu::Buffer first = make("first"), second = make("second");
    graph::FrameGraph graph(context());
    const graph::BufferId a = graph.buffer("first", first), b = graph.buffer("second", second);
    counts(graph, a, 5);
    mirrors(graph, a, b);
    graph.compile();
    context().run("two frames", [&](VkCommandBuffer commands) {
        graph.record(commands);
        graph.record(commands);
    });
    for (uint32_t i = 0; i < elements; ++i)
        ASSERT_EQ(second.mapped<uint32_t>()[i], 2 * (elements - 1 - i + 5));
}

TEST_P(FrameGraphBuffers, HostWritesBeforeAFrameAreSeen) {
    const gpu::Buffer first = make("first"), second = make("second");
    graph::FrameGraph graph(context());
    mirrors(graph, graph.buffer("first", first), graph.buffer("second", second));
    graph.compile();
    for (uint32_t frame = 0; frame < 2; ++frame) {
        for (uint32_t i = 0; i < elements; ++i)
            first.mapped<uint32_t>()[i] = i * 3 + frame;
        run_frame(context(), graph);
        for (uint32_t i = 0; i < elements; ++i)
            ASSERT_EQ(second.mapped<uint32_t>()[i], 2 * (3 * (elements - 1 - i) + frame));
    }
}

// A buffer that grows: from the next frame on passes and barriers have the new one, the old one is left.
TEST_P(FrameGraphBuffers, AReboundBufferTakesTheOldOnesPlace) {
    const gpu::Buffer first = make("first"), second = make("second"), grown = make("grown");
    graph::FrameGraph graph(context());
    const graph::BufferId a = graph.buffer("first", first), b = graph.buffer("second", second);
    counts(graph, a, 5);
    mirrors(graph, a, b);
    int frames = 0;
    graph.before_frame([&] {
        if (++frames == 2)
            graph.rebind(a, grown);
    });
    graph.compile();
    run_frame(context(), graph);
    EXPECT_EQ(first.mapped<uint32_t>()[1], 6u);
    std::fill_n(first.mapped<uint32_t>(), elements, 7u);
    std::fill_n(second.mapped<uint32_t>(), elements, 0u);
    const VulkanSpy spy;
    run_frame(context(), graph);
    for (uint32_t i = 0; i < elements; ++i) {
        ASSERT_EQ(first.mapped<uint32_t>()[i], 7u);
        ASSERT_EQ(grown.mapped<uint32_t>()[i], i + 5);
        ASSERT_EQ(second.mapped<uint32_t>()[i], 2 * (elements - 1 - i + 5));
    }
    for (const VkBufferMemoryBarrier2& barrier : spy.buffer_barriers)
        EXPECT_NE(barrier.buffer, first.handle());
}

// Two frames in flight, each with the buffers of its own slot.
TEST_P(FrameGraphBuffers, EachFrameInFlightHasItsOwn) {
    gpu::PerFrame<gpu::Buffer> first{make("first 0"), make("first 1")}, second{make("second 0"), make("second 1")};
    for (uint32_t slot = 0; slot < gpu::frames_in_flight; ++slot)
        for (uint32_t i = 0; i < elements; ++i)
            first[slot].mapped<uint32_t>()[i] = 3 * i + slot;
    graph::FrameGraph graph(context());
    mirrors(graph, graph.buffer("first", first), graph.buffer("second", second));
    std::vector<gpu::FrameTurn> turns;
    graph.before_frame([&](const gpu::FrameTurn& turn) { turns.push_back(turn); });
    graph.compile();
    const VulkanSpy spy;
    context().run("two frames", [&](VkCommandBuffer commands) {
        graph.record(commands, {0, true});
        graph.record(commands, {1, false});
    });
    for (uint32_t slot = 0; slot < gpu::frames_in_flight; ++slot)
        for (uint32_t i = 0; i < elements; ++i)
            ASSERT_EQ(second[slot].mapped<uint32_t>()[i], 2 * (3 * (elements - 1 - i) + slot)) << "slot " << slot;
    ASSERT_EQ(turns.size(), 2u);
    EXPECT_EQ(turns[1].slot, 1u);
    EXPECT_FALSE(turns[1].alone);
    std::vector<VkBuffer> waited; // the first frame's buffer in its barriers, the second's in its own
    for (const VkBufferMemoryBarrier2& barrier : spy.buffer_barriers)
        waited.push_back(barrier.buffer);
    ASSERT_EQ(waited.size(), 4u) << "before the pass and after it, twice";
    EXPECT_EQ(waited[0], second[0].handle());
    EXPECT_EQ(waited[1], second[0].handle());
    EXPECT_EQ(waited[2], second[1].handle());
    EXPECT_EQ(waited[3], second[1].handle());
    for (uint32_t slot = 0; slot < gpu::frames_in_flight; ++slot)
        EXPECT_GT(graph.pass_times(slot).at(0).second, 0) << "slot " << slot;
}

// A buffer grows while a frame in flight still uses the old one: that stays until the frame is done.
TEST_P(FrameGraphBuffers, ARetiredBufferStaysForTheFrameOnItsWay) {
    gpu::Buffer first = make("first");
    const gpu::Buffer second = make("second"), grown = make("grown");
    graph::FrameGraph graph(context());
    const graph::BufferId a = graph.buffer("first", first), b = graph.buffer("second", second);
    counts(graph, a, 5);
    mirrors(graph, a, b);
    int frames = 0;
    graph.before_frame([&] {
        if (++frames == 2) {
            graph.rebind(a, grown);
            graph.retire(std::move(first));
        }
    });
    graph.compile();
    const uint64_t held = context().device_bytes();
    context().run("two frames", [&](VkCommandBuffer commands) {
        graph.record(commands, {0, true});
        graph.record(commands, {1, false});
        EXPECT_EQ(context().device_bytes(), held);
    });
    for (uint32_t i = 0; i < elements; ++i)
        ASSERT_EQ(grown.mapped<uint32_t>()[i], i + 5);
    std::fill_n(grown.mapped<uint32_t>(), elements, 0u);
    context().run("third frame", [&](VkCommandBuffer commands) { graph.record(commands, {0, false}); });
    EXPECT_LT(context().device_bytes(), held);
    for (uint32_t i = 0; i < elements; ++i) {
        ASSERT_EQ(grown.mapped<uint32_t>()[i], i + 5) << "slot 0 has the old buffer still";
        ASSERT_EQ(second.mapped<uint32_t>()[i], 2 * (elements - 1 - i + 5));
    }
}

TEST_P(FrameGraphBuffers, ComputeReadsADrawnImage) {
    const gpu::Buffer target = make("target");
    graph::FrameGraph graph(context());
    const graph::ImageId image = graph.image("image", {VK_FORMAT_R16G16B16A16_SFLOAT, {256, 256}});
    graph.pass("clear").colour(image, graph::Load::clear, {1.25f}).record([](const auto&) {});
    graph::Pass& pass = graph.pass("read");
    pass.storage(0, graph.buffer("target", target), true).sample(1, image);
    run_program(pass, context(), "read_image.comp", {}, elements / 64);
    graph.compile();
    run_frame(context(), graph);
    for (uint32_t i = 0; i < elements; ++i)
        ASSERT_EQ(target.mapped<uint32_t>()[i], 5);
}

} // namespace
} // namespace prelight
