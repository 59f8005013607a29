#include "texture.hpp"
#include "check.hpp"
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <fmt/format.h>
#include <glm/gtc/packing.hpp>
#include <prelight/error.hpp>

namespace prelight::gpu {
namespace {

VkFormat format_of(TextureEncoding encoding) {
    switch (encoding) {
    case TextureEncoding::srgb8: return VK_FORMAT_R8G8B8A8_SRGB;
    case TextureEncoding::linear8: return VK_FORMAT_R8G8B8A8_UNORM;
    case TextureEncoding::half: return VK_FORMAT_R16G16B16A16_SFLOAT;
    }
    return VK_FORMAT_UNDEFINED;
}

VkImageMemoryBarrier2 level_barrier(VkImage image, uint32_t level, VkImageLayout from, VkImageLayout to,
                                    VkAccessFlags2 source, VkAccessFlags2 target) {
    VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    barrier.srcStageMask = source ? VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT : VK_PIPELINE_STAGE_2_NONE;
    barrier.srcAccessMask = source;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    barrier.dstAccessMask = target;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, level, 1, 0, 1};
    return barrier;
}

void submit(VkCommandBuffer commands, const VkImageMemoryBarrier2& barrier) {
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

VkOffset3D corner(uint32_t size_x, uint32_t size_y, uint32_t level) {
    return {static_cast<int32_t>(std::max(1u, size_x >> level)), static_cast<int32_t>(std::max(1u, size_y >> level)),
            1};
}

std::string name_of(const TextureImage& image) { return image.name.empty() ? "texture" : image.name; }

void check_size(const Context& context, const TextureImage& image) {
    const uint32_t limit = context.limits().maxImageDimension2D;
    if (image.width > limit || image.height > limit)
        throw Error(fmt::format("{}: image {}: {}x{} exceeds the device's limit of {}", context.name(), name_of(image),
                                image.width, image.height, limit));
}

Uploader::Staging stage_texels(Uploader& uploader, const TextureImage& image, TextureEncoding encoding) {
    const bool half = encoding == TextureEncoding::half;
    const Uploader::Staging staging = uploader.stage(image.rgba.size() * (half ? 2 : 1));
    if (!half) {
        std::memcpy(staging.bytes, image.rgba.data(), image.rgba.size());
        return staging;
    }
    std::array<uint16_t, 256> halves;
    for (size_t v = 0; v < halves.size(); ++v)
        halves[v] = glm::packHalf1x16(static_cast<float>(v) / 255.0f);
    std::transform(image.rgba.begin(), image.rgba.end(), reinterpret_cast<uint16_t*>(staging.bytes),
                   [&](uint8_t v) { return halves[v]; });
    return staging;
}

} // namespace

Texture::Texture(const Context& context, MemoryPool& pool, Uploader& uploader, const TextureImage& image,
                 TextureEncoding encoding) {
    check_size(context, image);
    const uint32_t levels = static_cast<uint32_t>(std::bit_width(std::max(image.width, image.height)));
    make(context, pool, name_of(image), format_of(encoding), image.width, image.height, levels);
    fill(uploader, image, encoding, levels);
}

Texture::Texture(const Context& context, MemoryPool& pool, Uploader& uploader, const std::string& name,
                 const std::vector<Image>& levels) {
    const auto count = static_cast<uint32_t>(levels.size());
    make(context, pool, name, VK_FORMAT_R16G16B16A16_SFLOAT, levels[0].width, levels[0].height, count);
    for (uint32_t level = 0; level < count; ++level) {
        const Image& image = levels[level];
        const Uploader::Staging staging = uploader.stage(image.pixels.size() * 4 * sizeof(uint16_t));
        auto* halves = reinterpret_cast<uint16_t*>(staging.bytes);
        for (const glm::vec3& p : image.pixels)
            for (int c = 0; c < 4; ++c)
                *halves++ = glm::packHalf1x16(c < 3 ? std::min(p[c], 65504.0f) : 1.0f);
        copy_level(uploader, staging, level, {image.width, image.height});
    }
    finish(uploader.commands(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, count);
}

Texture::Texture(const Context& context, MemoryPool& pool, Uploader& uploader, const TextureImage& image,
                 std::span<const TextureImage> smaller, TextureEncoding encoding) {
    const auto count = static_cast<uint32_t>(1 + smaller.size());
    check_size(context, image);
    make(context, pool, name_of(image), format_of(encoding), image.width, image.height, count);
    for (uint32_t level = 0; level < count; ++level) {
        const TextureImage& texels = level == 0 ? image : smaller[level - 1];
        copy_level(uploader, stage_texels(uploader, texels, encoding), level, {texels.width, texels.height});
    }
    finish(uploader.commands(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, count);
}

void Texture::copy_level(const Uploader& uploader, const Uploader::Staging& staging, uint32_t level,
                         VkExtent2D size) const {
    constexpr auto write = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    submit(uploader.commands(),
           level_barrier(image_, level, VK_IMAGE_LAYOUT_UNDEFINED, write, 0, VK_ACCESS_2_TRANSFER_WRITE_BIT));
    VkBufferImageCopy copy{};
    copy.bufferOffset = staging.offset;
    copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level, 0, 1};
    copy.imageExtent = {size.width, size.height, 1};
    vkCmdCopyBufferToImage(uploader.commands(), staging.buffer, image_, write, 1, &copy);
    submit(uploader.commands(), level_barrier(image_, level, write, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                              VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_ACCESS_2_TRANSFER_READ_BIT));
}

void Texture::make(const Context& context, MemoryPool& pool, const std::string& name, VkFormat format, uint32_t width,
                   uint32_t height, uint32_t levels) {
    VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {width, height, 1};
    info.mipLevels = levels;
    info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    VkImage handle = VK_NULL_HANDLE;
    check(vkCreateImage(context.device(), &info, nullptr, &handle), name);
    image_ = {context.device(), handle};
    context.count_created(Context::Kind::image);
    context.set_name(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<uint64_t>(handle), name);
    VkMemoryRequirements requirements{};
    vkGetImageMemoryRequirements(context.device(), handle, &requirements);
    const MemoryPool::Slice slice = pool.take(requirements);
    check(vkBindImageMemory(context.device(), handle, slice.memory, slice.offset), name);

    VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    view.image = handle;
    view.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view.format = info.format;
    view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, levels, 0, 1};
    VkImageView view_handle = VK_NULL_HANDLE;
    check(vkCreateImageView(context.device(), &view, nullptr, &view_handle), name);
    view_ = {context.device(), view_handle};
    context.set_name(VK_OBJECT_TYPE_IMAGE_VIEW, reinterpret_cast<uint64_t>(view_handle), name);
}

void Texture::fill(Uploader& uploader, const TextureImage& image, TextureEncoding encoding, uint32_t levels) const {
    copy_level(uploader, stage_texels(uploader, image, encoding), 0, {image.width, image.height});
    const VkCommandBuffer commands = uploader.commands();
    constexpr auto write = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    constexpr auto read = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    for (uint32_t level = 1; level < levels; ++level) {
        submit(commands,
               level_barrier(image_, level, VK_IMAGE_LAYOUT_UNDEFINED, write, 0, VK_ACCESS_2_TRANSFER_WRITE_BIT));
        VkImageBlit blit{};
        blit.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level - 1, 0, 1};
        blit.srcOffsets[1] = corner(image.width, image.height, level - 1);
        blit.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level, 0, 1};
        blit.dstOffsets[1] = corner(image.width, image.height, level);
        vkCmdBlitImage(commands, image_, read, image_, write, 1, &blit, VK_FILTER_LINEAR);
        submit(commands, level_barrier(image_, level, write, read, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                       VK_ACCESS_2_TRANSFER_READ_BIT));
    }
    finish(commands, read, levels);
}

void Texture::finish(VkCommandBuffer commands, VkImageLayout from, uint32_t levels) const {
    VkImageMemoryBarrier2 done = level_barrier(image_, 0, from, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                                               VK_ACCESS_2_TRANSFER_READ_BIT, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT);
    done.subresourceRange.levelCount = levels;
    done.dstStageMask = VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
    submit(commands, done);
}

UniqueSampler make_compare_sampler(const Context& context, VkFormat format) {
    VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    info.magFilter = info.minFilter = context.supports(format, VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT)
                                          ? VK_FILTER_LINEAR
                                          : VK_FILTER_NEAREST;
    info.compareEnable = VK_TRUE;
    info.compareOp = VK_COMPARE_OP_GREATER_OR_EQUAL;
    VkSampler handle = VK_NULL_HANDLE;
    check(vkCreateSampler(context.device(), &info, nullptr, &handle), "shadow sampler");
    context.set_name(VK_OBJECT_TYPE_SAMPLER, reinterpret_cast<uint64_t>(handle), "shadow sampler");
    return {context.device(), handle};
}

UniqueSampler make_sampler(const Context& context, const Sampler& sampler, TextureFilter filter) {
    const auto address = [](Wrap wrap) {
        return wrap == Wrap::repeat            ? VK_SAMPLER_ADDRESS_MODE_REPEAT
               : wrap == Wrap::mirrored_repeat ? VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT
                                               : VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    };
    const auto mode = [](Filter f) { return f == Filter::linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST; };
    VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    info.addressModeU = address(sampler.wrap_s);
    info.addressModeV = address(sampler.wrap_t);
    info.addressModeW = VK_SAMPLER_ADDRESS_MODE_REPEAT;
    if (filter == TextureFilter::bilinear) {
        info.magFilter = info.minFilter = VK_FILTER_LINEAR;
        info.maxLod = 0;
    } else {
        info.magFilter = mode(sampler.mag);
        info.minFilter = mode(sampler.min);
        info.mipmapMode =
            sampler.mip == MipFilter::linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
        // Without mip maps a lod of 0.25 keeps minification apart from magnification (Vulkan spec).
        info.maxLod = sampler.mip == MipFilter::none ? 0.25f : VK_LOD_CLAMP_NONE;
        // Only where everything is linear anyway: with anisotropy drivers choose filters themselves.
        info.anisotropyEnable = filter == TextureFilter::anisotropic && context.features().anisotropy &&
                                sampler.mag == Filter::linear && sampler.min == Filter::linear &&
                                sampler.mip == MipFilter::linear;
        info.maxAnisotropy = std::min(8.0f, context.limits().maxSamplerAnisotropy);
    }
    VkSampler handle = VK_NULL_HANDLE;
    check(vkCreateSampler(context.device(), &info, nullptr, &handle), "sampler");
    return {context.device(), handle};
}

} // namespace prelight::gpu
