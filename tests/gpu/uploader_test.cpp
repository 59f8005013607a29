// Uploads gathered in a few submissions: every byte arrives, whatever lies between them.
#include "devices.hpp"
#include <gpu/uploader.hpp>

namespace prelight {
namespace {

class Uploads : public OnEachDevice {};
INSTANTIATE_TEST_SUITE_P(Drivers, Uploads, testing::Values(Driver::lavapipe, Driver::swiftshader), driver_name);

// 3 × 3 MiB are more than a block, 20 MiB need a block of their own, and two blocks take turns.
TEST_P(Uploads, EveryByteArrives) {
    const std::vector<uint64_t> sizes{5, 3u << 20, 3u << 20, 3u << 20, 20u << 20, 17, 7u << 20, 100};
    std::vector<gpu::Buffer> targets;
    const uint64_t before = context().device_bytes();
    uint64_t held = 0;
    {
        gpu::Uploader uploader(context());
        for (size_t i = 0; i < sizes.size(); ++i) {
            gpu::Buffer& target = targets.emplace_back(context(), "target", sizes[i], VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                                       gpu::BufferPlace::readback);
            const gpu::Uploader::Staging staging = uploader.stage(sizes[i]);
            EXPECT_EQ(staging.offset % 16, 0u);
            for (uint64_t b = 0; b < sizes[i]; ++b)
                staging.bytes[b] = static_cast<std::byte>(b * 7 + b / 1000 + i);
            const VkBufferCopy region{staging.offset, 0, sizes[i]};
            vkCmdCopyBuffer(uploader.commands(), staging.buffer, target.handle(), 1, &region);
            held += sizes[i];
        }
        uploader.finish();
        EXPECT_GE(context().device_bytes(), before + held + (20u << 20));
        uploader.finish(); // nothing more to do
    }
    EXPECT_LT(context().device_bytes(), before + held + (1u << 20)) << "staging memory is given back";
    for (size_t i = 0; i < sizes.size(); ++i)
        for (uint64_t b = 0; b < sizes[i]; ++b)
            ASSERT_EQ(targets[i].mapped<std::byte>()[b], static_cast<std::byte>(b * 7 + b / 1000 + i))
                << "upload " << i << ", byte " << b;
}

} // namespace
} // namespace prelight
