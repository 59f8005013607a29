// Device memory: what is counted, where the pool puts things, what a device cannot hold.
#include "devices.hpp"
#include "programs.hpp"
#include <gmock/gmock.h>
#include <gpu/buffer.hpp>
#include <gpu/texture.hpp>
#include <map>
#include <shared/raster.h>

namespace prelight {
namespace {

using testing::HasSubstr;

class DeviceMemory : public OnEachDevice {
protected:
    uint64_t held() { return context().device_bytes(); }
};
INSTANTIATE_TEST_SUITE_P(Drivers, DeviceMemory, testing::Values(Driver::lavapipe, Driver::swiftshader), driver_name);

TEST_P(DeviceMemory, BuffersAreCountedUntilTheyGo) {
    const uint64_t start = held();
    {
        gpu::Buffer a(context(), "a", 1000, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::BufferPlace::device);
        EXPECT_GE(held(), start + 1000);
        const uint64_t with_a = held();
        const std::vector<std::byte> bytes(5000);
        gpu::Buffer b = gpu::make_device_buffer(context(), "b", bytes, VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
        EXPECT_GE(held(), with_a + 5000);
        EXPECT_LT(held(), with_a + 10000) << "the staging buffer is gone";
        const uint64_t with_both = held();
        gpu::Buffer moved = std::move(b);
        EXPECT_EQ(held(), with_both);
        a = gpu::Buffer();
    }
    EXPECT_EQ(held(), start);
}

TEST_P(DeviceMemory, DeviceBuffersHoldWhatFilledThem) {
    const std::unique_ptr<gpu::Context> device = make_device(GetParam());
    for (const bool hidden : {false, true}) {
        if (hidden)
            device->hide_device_memory();
        for (const uint64_t size : {0, 3, 4, 70001}) {
            const uint64_t buffers = device->created(gpu::Context::Kind::buffer);
            const gpu::Buffer buffer =
                gpu::make_device_buffer(*device, "filled", size, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, [&](std::byte* to) {
                    for (uint64_t i = 0; i < size; ++i)
                        to[i] = static_cast<std::byte>(i * 7 + 1);
                });
            EXPECT_EQ(buffer.mapped<std::byte>() == nullptr, hidden);
            EXPECT_EQ(device->created(gpu::Context::Kind::buffer) - buffers, hidden ? 2u : 1u) << "staging memory";
            ASSERT_EQ(buffer.size(), std::max<uint64_t>(size, 4));
            const gpu::Buffer back(*device, "back", buffer.size(), VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                   gpu::BufferPlace::readback);
            device->run("read", [&](VkCommandBuffer commands) {
                const VkBufferCopy all{0, 0, buffer.size()};
                vkCmdCopyBuffer(commands, buffer.handle(), back.handle(), 1, &all);
            });
            for (uint64_t i = 0; i < back.size(); ++i)
                ASSERT_EQ(back.mapped<std::byte>()[i], static_cast<std::byte>(i < size ? i * 7 + 1 : 0)) << i;
        }
    }
}

TEST_P(DeviceMemory, AFrameGraphGivesItsMemoryBack) {
    const uint64_t start = held();
    {
        graph::FrameGraph graph(context());
        const graph::ImageId image = graph.image("image", {VK_FORMAT_R16G16B16A16_SFLOAT, {300, 200}});
        graph.pass("clear").colour(image, graph::Load::clear).record([](const auto&) {});
        graph.keep(image);
        graph.compile();
        const uint64_t compiled = held();
        {
            const gpu::Buffer raster(
                context(), "raster",
                std::max<uint64_t>(sizeof(shared::RasterConstants), context().limits().minUniformBufferOffsetAlignment),
                VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, gpu::BufferPlace::device);
            EXPECT_EQ(compiled, start + graph.memory_bytes() + held() - compiled)
                << "what the pass knows of its raster";
        }
        EXPECT_GE(graph.memory_bytes(), 300 * 200 * 8);
        run_frame(context(), graph);
        graph.read_back(image);
        EXPECT_EQ(held(), compiled) << "the buffer of read_back() is gone";
    }
    EXPECT_EQ(held(), start);
}

TEST_P(DeviceMemory, TexturesGiveTheirMemoryBackWithTheirPool) {
    const uint64_t start = held();
    {
        gpu::MemoryPool pool(context());
        std::vector<gpu::Texture> textures;
        gpu::Uploader uploader(context());
        const TextureImage image{"image", 33, 70, std::vector<uint8_t>(33 * 70 * 4, 128)};
        for (int i = 0; i < 5; ++i)
            for (const auto encoding : {gpu::TextureEncoding::srgb8, gpu::TextureEncoding::half})
                textures.emplace_back(context(), pool, uploader, image, encoding);
        uploader.finish();
        EXPECT_GT(held(), start);
    }
    EXPECT_EQ(held(), start);
}

TEST_P(DeviceMemory, ThePoolAlignsAndNeverOverlaps) {
    const uint64_t start = held();
    {
        gpu::MemoryPool pool(context());
        const VkMemoryRequirements any{0, 1, 0xffffffffu};
        std::map<VkDeviceMemory, std::map<uint64_t, uint64_t>> taken; // memory → begin → end
        uint32_t state = 1;
        for (int i = 0; i < 300; ++i) {
            VkMemoryRequirements wanted = any;
            wanted.alignment = uint64_t(1) << (state = state * 1664525 + 1013904223, state >> 16) % 17;
            wanted.size = 1 + (state = state * 1664525 + 1013904223, state >> 8) % 700'000;
            const gpu::MemoryPool::Slice slice = pool.take(wanted);
            EXPECT_EQ(slice.offset % wanted.alignment, 0);
            auto& ranges = taken[slice.memory];
            const auto after = ranges.lower_bound(slice.offset);
            const uint64_t next = after == ranges.end() ? UINT64_MAX : after->first;
            const uint64_t before = after == ranges.begin() ? 0 : std::prev(after)->second;
            EXPECT_LE(slice.offset + wanted.size, next);
            EXPECT_GE(slice.offset, before);
            ranges[slice.offset] = slice.offset + wanted.size;
        }
        EXPECT_GT(taken.size(), 1u) << "more than a block was asked for";
        EXPECT_LT(taken.size(), 12u);
        uint64_t furthest = 0;
        for (const auto& [memory, ranges] : taken)
            furthest += ranges.rbegin()->second;
        EXPECT_LE(furthest, held() - start) << "slices lie inside what was allocated";

        VkMemoryRequirements large = any;
        large.size = 40u << 20;
        const uint64_t before = held();
        EXPECT_EQ(pool.take(large).offset, 0);
        EXPECT_EQ(held(), before + large.size) << "more than a block gets memory of its own";
    }
    EXPECT_EQ(held(), start);
}

TEST_P(DeviceMemory, ATextureBeyondTheDevicesLimitIsNamed) {
    const uint64_t start = held();
    gpu::MemoryPool pool(context());
    const uint32_t limit = context().limits().maxImageDimension2D;
    for (const bool tall : {false, true}) {
        TextureImage image{"wallpaper.png", limit + 1, 1, std::vector<uint8_t>((limit + 1) * 4)};
        if (tall)
            std::swap(image.width, image.height);
        gpu::Uploader uploader(context());
        EXPECT_THAT([&] { gpu::Texture(context(), pool, uploader, image, gpu::TextureEncoding::srgb8); },
                    testing::ThrowsMessage<Error>(
                        testing::AllOf(HasSubstr("wallpaper.png"), HasSubstr(std::to_string(limit)))));
    }
    EXPECT_EQ(held(), start);
    const TextureImage largest{"largest", limit, 1, std::vector<uint8_t>(limit * 4)};
    gpu::Uploader uploader(context());
    const gpu::Texture texture(context(), pool, uploader, largest, gpu::TextureEncoding::srgb8);
    EXPECT_NO_THROW(uploader.finish());
}

// Validation, rightly, has a message for this one: a device without it.
TEST(OutOfMemory, IsAnErrorThatNamesTheDeviceAndTheSize) {
    const gpu::Context context({.select = "cpu"});
    const uint32_t type = context.memory_type(0xffffffffu, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    const uint64_t exabyte = uint64_t(1) << 60;
    EXPECT_THAT(
        [&] { gpu::Allocation(context, exabyte, type, false); },
        testing::ThrowsMessage<Error>(testing::AllOf(HasSubstr(context.name()), HasSubstr(std::to_string(exabyte)))));
    EXPECT_EQ(context.device_bytes(), 0);
}

} // namespace
} // namespace prelight
