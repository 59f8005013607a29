// Barriers from declared accesses. Neighbouring reads of a resource form one group; a barrier stands
// before each group, from all that the group before did to all that this group will do.
#include "frame_graph.hpp"

namespace prelight::graph {
namespace {

constexpr VkAccessFlags2 write_bits = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT |
                                      VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT |
                                      VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT;

struct Group {
    uint32_t pass = 0;
    Access access;
};

/// `uses`: {pass index, access} in order of passes.
std::vector<Group> group_uses(const std::vector<Group>& uses) {
    std::vector<Group> groups;
    for (const Group& use : uses) {
        const bool joins = !groups.empty() && !use.access.writes && !groups.back().access.writes &&
                           groups.back().access.layout == use.access.layout;
        if (joins)
            groups.back().access |= use.access;
        else
            groups.push_back(use);
    }
    return groups;
}

} // namespace

void FrameGraph::derive_barriers() {
    for (uint32_t i = 0; i < images_.size(); ++i)
        if (images_[i].usage)
            derive_image_barriers(images_[i], i);
    for (uint32_t i = 0; i < buffers_.size(); ++i)
        derive_buffer_barriers(i);
}

Access FrameGraph::everything_that_shares_memory(const GraphImage& image) const {
    Access all;
    for (const auto& pass : passes_)
        for (const Pass::ImageUse& use : pass->images_) {
            const GraphImage& other = images_[use.image.index];
            if (other.offset < image.offset + image.requirements.size &&
                image.offset < other.offset + other.requirements.size)
                all |= use.access;
        }
    return all;
}

void FrameGraph::derive_image_barriers(GraphImage& image, uint32_t index) {
    std::vector<Group> uses;
    for (uint32_t p = 0; p < passes_.size(); ++p)
        for (const Pass::ImageUse& use : passes_[p]->images_)
            if (use.image.index == index)
                uses.push_back({p, use.access});

    // The first use waits for whatever used this memory before: an image that was here earlier in
    // the frame, or anything of the frame before.
    const std::vector<Group> groups = group_uses(uses);
    Access before = everything_that_shares_memory(image);
    before.layout = image.persistent ? groups.back().access.layout : VK_IMAGE_LAYOUT_UNDEFINED;
    for (const Group& group : groups) {
        VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
        barrier.srcStageMask = before.stages;
        barrier.srcAccessMask = before.access & write_bits;
        barrier.dstStageMask = group.access.stages;
        barrier.dstAccessMask = group.access.access;
        barrier.oldLayout = before.layout;
        barrier.newLayout = group.access.layout;
        barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        barrier.image = image.image;
        barrier.subresourceRange = {aspects(image.desc.format), 0, 1, 0, 1};
        passes_[group.pass]->image_barriers_.push_back(barrier);
        before = group.access;
    }
    image.final_access = before;
}

void FrameGraph::derive_buffer_barriers(uint32_t index) {
    std::vector<Group> uses;
    for (uint32_t p = 0; p < passes_.size(); ++p)
        for (const Pass::BufferUse& use : passes_[p]->buffers_)
            if (use.buffer.index == index)
                uses.push_back({p, use.access});
    Access everything;
    for (const Group& use : uses)
        everything |= use.access;
    if (!everything.writes)
        return; // reads need no order, and a submission makes the host's writes visible
    const auto barrier = [&](const Access& before, VkPipelineStageFlags2 stages, VkAccessFlags2 access) {
        VkBufferMemoryBarrier2 b{VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2};
        b.srcStageMask = before.stages;
        b.srcAccessMask = before.access & write_bits;
        b.dstStageMask = stages;
        b.dstAccessMask = access;
        b.srcQueueFamilyIndex = b.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        b.size = VK_WHOLE_SIZE;
        return Pass::BufferBarrier{{index}, b};
    };
    // The first use waits for the frame before, the host for all of this one.
    Access before = everything;
    for (const Group& group : group_uses(uses)) {
        passes_[group.pass]->buffer_barriers_.push_back(barrier(before, group.access.stages, group.access.access));
        before = group.access;
    }
    host_barriers_.push_back(barrier(everything, VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT));
}

} // namespace prelight::graph
