// Lifetimes of the graph's images, and where each lies in the memory they share.
#include "frame_graph.hpp"
#include <algorithm>
#include <gpu/check.hpp>
#include <numeric>

namespace prelight::graph {
namespace {

constexpr VkFormat bits_format = VK_FORMAT_R32G32_UINT; ///< an RGBA16F texel, for sample_bits()

} // namespace

void FrameGraph::find_lifetimes() {
    for (uint32_t p = 0; p < passes_.size(); ++p) {
        const Pass& pass = *passes_[p];
        for (const Pass::ImageUse& use : pass.images_) {
            GraphImage& image = images_[use.image.index];
            image.first = std::min(image.first, p);
            image.last = std::max(image.last, p);
        }
        for (const Pass::Attachment& colour : pass.colours_)
            images_[colour.image.index].usage |= VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
        if (pass.between_)
            images_[pass.between_->index].usage |= VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
        if (pass.depth_)
            images_[pass.depth_->image.index].usage |= VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
        for (const auto& [binding, image] : pass.sampled_) {
            images_[image.index].usage |= VK_IMAGE_USAGE_SAMPLED_BIT;
            images_[image.index].as_bits |=
                std::find(pass.bits_.begin(), pass.bits_.end(), binding) != pass.bits_.end();
        }
        for (const auto& [binding, image] : pass.stored_)
            images_[image.index].usage |= VK_IMAGE_USAGE_STORAGE_BIT;
    }
    if (external_)
        images_[external_.index].usage = 0; // nothing to make, to place or to derive
    for (GraphImage& image : images_) {
        if (!image.usage)
            continue;
        if (image.kept || image.persistent)
            image.last = 0xfffffffeu;
        if (image.kept)
            image.usage |= VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
        if (image.persistent) {
            image.first = 0;
            image.usage |= is_depth(image.desc.format) ? 0 : VK_IMAGE_USAGE_TRANSFER_DST_BIT;
        }
    }
}

void FrameGraph::create_images() {
    for (GraphImage& image : images_) {
        if (!image.usage)
            continue;
        VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
        info.imageType = VK_IMAGE_TYPE_2D;
        info.format = image.desc.format;
        info.extent = {image.desc.raster.extent.width, image.desc.raster.extent.height, 1};
        info.mipLevels = info.arrayLayers = 1;
        info.samples = static_cast<VkSampleCountFlagBits>(image.desc.raster.samples);
        info.usage = image.usage;
        const VkFormat formats[] = {image.desc.format, bits_format};
        const VkImageFormatListCreateInfo list{VK_STRUCTURE_TYPE_IMAGE_FORMAT_LIST_CREATE_INFO, nullptr, 2, formats};
        if (image.as_bits) {
            info.flags = VK_IMAGE_CREATE_MUTABLE_FORMAT_BIT;
            info.pNext = &list;
        }
        VkImage handle = VK_NULL_HANDLE;
        gpu::check(vkCreateImage(context_.device(), &info, nullptr, &handle), image.name);
        image.image = {context_.device(), handle};
        context_.count_created(gpu::Context::Kind::image);
        context_.set_name(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<uint64_t>(handle), image.name);
        vkGetImageMemoryRequirements(context_.device(), handle, &image.requirements);
    }
}

void FrameGraph::place_images() {
    // Largest first, each at the lowest offset where no image that is alive at the same time lies.
    std::vector<uint32_t> order;
    for (uint32_t i = 0; i < images_.size(); ++i)
        if (images_[i].usage)
            order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
        return images_[a].requirements.size > images_[b].requirements.size;
    });
    if (order.empty())
        return; // only buffers, or nothing at all
    uint64_t total = 0;
    uint32_t types = 0xffffffffu;
    std::vector<uint32_t> placed;
    for (const uint32_t i : order) {
        GraphImage& image = images_[i];
        types &= image.requirements.memoryTypeBits;
        std::vector<const GraphImage*> rivals;
        for (const uint32_t p : placed)
            if (images_[p].first <= image.last && image.first <= images_[p].last)
                rivals.push_back(&images_[p]);
        std::sort(rivals.begin(), rivals.end(),
                  [](const GraphImage* a, const GraphImage* b) { return a->offset < b->offset; });
        const uint64_t alignment = image.requirements.alignment;
        uint64_t offset = 0;
        for (const GraphImage* rival : rivals) {
            if (offset + image.requirements.size <= rival->offset)
                break;
            const uint64_t end = rival->offset + rival->requirements.size;
            offset = std::max(offset, (end + alignment - 1) / alignment * alignment);
        }
        image.offset = offset;
        total = std::max(total, offset + image.requirements.size);
        placed.push_back(i);
    }
    memory_ = gpu::Allocation(context_, total, context_.memory_type(types, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT), false);
    for (const uint32_t i : order)
        gpu::check(vkBindImageMemory(context_.device(), images_[i].image, memory_.memory(), images_[i].offset),
                   images_[i].name);
}

void FrameGraph::create_views() {
    for (GraphImage& image : images_) {
        if (!image.usage)
            continue;
        image.view = create_view(image, aspects(image.desc.format), image.desc.format);
        if (has_stencil(image.desc.format)) { // a shader sees one aspect
            image.depth_only_view = create_view(image, VK_IMAGE_ASPECT_DEPTH_BIT, image.desc.format);
            image.stencil_only_view = create_view(image, VK_IMAGE_ASPECT_STENCIL_BIT, image.desc.format);
        }
        if (image.as_bits)
            image.bits_view = create_view(image, VK_IMAGE_ASPECT_COLOR_BIT, bits_format);
    }
}

gpu::UniqueImageView FrameGraph::create_view(const GraphImage& image, VkImageAspectFlags aspects,
                                             VkFormat format) const {
    VkImageViewCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    const VkImageViewUsageCreateInfo usage{VK_STRUCTURE_TYPE_IMAGE_VIEW_USAGE_CREATE_INFO, nullptr,
                                           VK_IMAGE_USAGE_SAMPLED_BIT};
    if (format != image.desc.format)
        info.pNext = &usage;
    info.image = image.image;
    info.viewType = VK_IMAGE_VIEW_TYPE_2D;
    info.format = format;
    info.subresourceRange = {aspects, 0, 1, 0, 1};
    VkImageView handle = VK_NULL_HANDLE;
    gpu::check(vkCreateImageView(context_.device(), &info, nullptr, &handle), image.name);
    context_.set_name(VK_OBJECT_TYPE_IMAGE_VIEW, reinterpret_cast<uint64_t>(handle), image.name);
    return {context_.device(), handle};
}

} // namespace prelight::graph
