// Mip maps made on the host are those that a device makes by blits.
#include "devices.hpp"
#include <cmath>
#include <cstdlib>
#include <gpu/buffer.hpp>
#include <gpu/texture.hpp>
#include <prelight/image.hpp>
#include <resident/mip_levels.hpp>

namespace prelight {
namespace {

using resident::mip_levels;

TextureImage noise(uint32_t width, uint32_t height) {
    TextureImage image{"noise", width, height, std::vector<uint8_t>(size_t(4) * width * height)};
    uint32_t state = 1;
    for (uint8_t& value : image.rgba) {
        state = state * 1664525u + 1013904223u;
        value = static_cast<uint8_t>(state >> 24);
        if ((state >> 20) % 4 == 0)
            value /= 16; // codes lie close in the dark
    }
    return image;
}

class MipLevels : public OnEachDevice {
protected:
    std::vector<uint8_t> level_of(const gpu::Texture& texture, uint32_t level, uint32_t width, uint32_t height) {
        const gpu::Buffer back(context(), "level", size_t(4) * width * height, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                               gpu::BufferPlace::readback);
        context().run("read a level", [&](VkCommandBuffer commands) {
            VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
            barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
            barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
            barrier.dstAccessMask = VK_ACCESS_2_TRANSFER_READ_BIT;
            barrier.oldLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
            barrier.newLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
            barrier.image = texture.image();
            barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, level, 1, 0, 1};
            VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
            info.imageMemoryBarrierCount = 1;
            info.pImageMemoryBarriers = &barrier;
            vkCmdPipelineBarrier2(commands, &info);
            VkBufferImageCopy copy{};
            copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level, 0, 1};
            copy.imageExtent = {width, height, 1};
            vkCmdCopyImageToBuffer(commands, texture.image(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, back.handle(), 1,
                                   &copy);
        });
        const auto* bytes = back.mapped<const uint8_t>();
        return {bytes, bytes + back.size()};
    }
};
INSTANTIATE_TEST_SUITE_P(Drivers, MipLevels, testing::Values(Driver::lavapipe, Driver::swiftshader), driver_name);

TEST_P(MipLevels, AreThoseOfTheDevice) {
    const TextureImage image = noise(64, 16);
    for (const auto encoding : {gpu::TextureEncoding::srgb8, gpu::TextureEncoding::linear8}) {
        gpu::MemoryPool pool(context());
        gpu::Uploader uploader(context());
        const gpu::Texture by_blits(context(), pool, uploader, image, encoding);
        const auto levels = mip_levels(image, encoding == gpu::TextureEncoding::srgb8);
        const gpu::Texture as_given(context(), pool, uploader, image, levels, encoding);
        uploader.finish();
        ASSERT_EQ(levels.size(), 6u);
        int most = 0;
        for (uint32_t l = 0; l < levels.size(); ++l) {
            ASSERT_EQ(std::pair(levels[l].width, levels[l].height), std::pair(32u >> l, std::max(8u >> l, 1u)));
            EXPECT_EQ(level_of(as_given, l + 1, levels[l].width, levels[l].height), levels[l].rgba)
                << "level " << l + 1;
            const auto blitted = level_of(by_blits, l + 1, levels[l].width, levels[l].height);
            for (size_t i = 0; i < blitted.size(); ++i)
                most = std::max(most, std::abs(blitted[i] - levels[l].rgba[i]));
        }
        EXPECT_LE(most, 2) << "codes; each level may round another way, from one that did";
    }
}

TEST(MipLevelsOfOddSides, TakeTheLastOneToo) {
    TextureImage image{"three", 3, 1, {}};
    for (const uint8_t code : {0, 60, 240})
        image.rgba.insert(image.rgba.end(), {code, code, code, code});
    const auto values = mip_levels(image, false), colours = mip_levels(image, true);
    ASSERT_EQ(values.size(), 1u);
    EXPECT_EQ(values[0].rgba, (std::vector<uint8_t>{100, 100, 100, 100}));
    const float light = (srgb_decode(60 / 255.0f) + srgb_decode(240 / 255.0f)) / 3;
    EXPECT_EQ(colours[0].rgba[0], std::lround(srgb_encode(light) * 255));
    EXPECT_EQ(colours[0].rgba[3], 100) << "alpha is no light";
    EXPECT_TRUE(mip_levels({"one", 1, 1, {1, 2, 3, 4}}, true).empty());
    EXPECT_EQ(mip_levels(noise(5, 3), true)[0].rgba.size(), size_t(4) * 2);
}

TEST(MipLevelsOfOneColour, KeepIt) {
    for (int code = 0; code < 256; ++code) {
        const auto value = static_cast<uint8_t>(code);
        TextureImage image{"plain", 4, 4, std::vector<uint8_t>(64, value)};
        for (const TextureImage& level : mip_levels(image, true))
            EXPECT_EQ(level.rgba, std::vector<uint8_t>(level.rgba.size(), value)) << code;
    }
}

} // namespace
} // namespace prelight
