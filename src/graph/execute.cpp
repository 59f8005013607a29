// Recording a frame, its timestamps, and reading a kept image.
#include "frame_graph.hpp"
#include <cstring>
#include <gpu/check.hpp>
#include <utility>

namespace prelight::graph {
namespace {

void pipeline_barrier(VkCommandBuffer commands, const std::vector<VkImageMemoryBarrier2>& images,
                      const std::vector<VkBufferMemoryBarrier2>& buffers) {
    if (images.empty() && buffers.empty())
        return;
    VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    info.imageMemoryBarrierCount = static_cast<uint32_t>(images.size());
    info.pImageMemoryBarriers = images.data();
    info.bufferMemoryBarrierCount = static_cast<uint32_t>(buffers.size());
    info.pBufferMemoryBarriers = buffers.data();
    vkCmdPipelineBarrier2(commands, &info);
}

VkAttachmentLoadOp load_op(Load load) {
    return load == Load::clear  ? VK_ATTACHMENT_LOAD_OP_CLEAR
           : load == Load::keep ? VK_ATTACHMENT_LOAD_OP_LOAD
                                : VK_ATTACHMENT_LOAD_OP_DONT_CARE;
}

void cover(VkCommandBuffer commands, VkExtent2D extent, VkExtent2D drawn) {
    const VkViewport viewport{0, 0, static_cast<float>(extent.width), static_cast<float>(extent.height), 0, 1};
    const VkRect2D scissor{{0, 0}, drawn};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &scissor);
}

} // namespace

bool FrameGraph::needed_after(ImageId image, uint32_t pass_index) const {
    return images_[image.index].last > pass_index;
}

void FrameGraph::begin_rendering(VkCommandBuffer commands, uint32_t index, VkExtent2D extent, bool again) const {
    const Pass& pass = *passes_[index];
    std::vector<VkRenderingAttachmentInfo> colours;
    for (const Pass::Attachment& attachment : pass.colours_) {
        VkRenderingAttachmentInfo& info =
            colours.emplace_back(VkRenderingAttachmentInfo{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO});
        info.imageView = attachment.image == external_ ? bound_->view : images_[attachment.image.index].view;
        info.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
        info.loadOp = load_op(again ? Load::keep : attachment.load);
        const bool stays = pass.between_ || attachment.image == external_ || needed_after(attachment.image, index);
        info.storeOp = stays ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_DONT_CARE;
        std::memcpy(info.clearValue.color.float32, attachment.clear.data(), sizeof attachment.clear);
    }
    VkRenderingAttachmentInfo depth{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    if (pass.depth_) {
        depth.imageView = images_[pass.depth_->image.index].view;
        depth.imageLayout = (pass.depth_writes_ ? Access::depth_write()
                             : pass.stencil_    ? Access::stencil_write()
                                                : Access::depth_test())
                                .layout;
        depth.loadOp = load_op(pass.depth_->load);
        depth.clearValue.depthStencil.depth = pass.depth_->clear[0];
        depth.storeOp = !pass.depth_writes_                       ? VK_ATTACHMENT_STORE_OP_NONE
                        : needed_after(pass.depth_->image, index) ? VK_ATTACHMENT_STORE_OP_STORE
                                                                  : VK_ATTACHMENT_STORE_OP_DONT_CARE;
    }
    VkRenderingAttachmentInfo stencil = depth;
    stencil.loadOp = load_op(pass.stencil_load_.value_or(Load::clear));
    stencil.storeOp = pass.stencil_load_ ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_DONT_CARE;
    VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
    info.renderArea = {{0, 0}, extent};
    info.layerCount = 1;
    info.colorAttachmentCount = static_cast<uint32_t>(colours.size());
    info.pColorAttachments = colours.data();
    info.pDepthAttachment = pass.depth_ ? &depth : nullptr;
    info.pStencilAttachment = pass.stencil_ ? &stencil : nullptr;
    vkCmdBeginRendering(commands, &info);
}

void FrameGraph::draw_between(VkCommandBuffer commands, uint32_t index, VkExtent2D drawn,
                              const std::function<void()>& draw) const {
    const Pass& pass = *passes_[index];
    const GraphImage& image = images_[pass.between_->index];
    VkImageMemoryBarrier2 turn{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    turn.srcQueueFamilyIndex = turn.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    turn.image = image.image;
    turn.subresourceRange = {aspects(image.desc.format), 0, 1, 0, 1};
    const auto between = [&](const Access& before, const Access& after) {
        turn.srcStageMask = before.stages;
        turn.srcAccessMask = before.writes ? VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT : VK_ACCESS_2_NONE;
        turn.dstStageMask = after.stages;
        turn.dstAccessMask = after.access;
        turn.oldLayout = before.layout;
        turn.newLayout = after.layout;
        // The pass's own attachments come back as they were.
        VkMemoryBarrier2 own{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
        own.srcStageMask = own.dstStageMask =
            VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT | Access::depth_write().stages;
        own.srcAccessMask = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
        own.dstAccessMask =
            own.srcAccessMask | VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
        VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
        info.memoryBarrierCount = info.imageMemoryBarrierCount = 1;
        info.pMemoryBarriers = &own;
        info.pImageMemoryBarriers = &turn;
        vkCmdPipelineBarrier2(commands, &info);
    };
    vkCmdEndRendering(commands);
    between(Access::sampled(true), Access::depth_write());
    VkRenderingAttachmentInfo depth{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    depth.imageView = image.view;
    depth.imageLayout = Access::depth_write().layout;
    depth.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
    depth.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
    info.renderArea = {{0, 0}, image.desc.raster.extent};
    info.layerCount = 1;
    info.pDepthAttachment = &depth;
    vkCmdBeginRendering(commands, &info);
    cover(commands, image.desc.raster.extent, image.desc.raster.extent);
    draw();
    vkCmdEndRendering(commands);
    between(Access::depth_write(), Access::sampled(true));
    const VkExtent2D extent = raster(*pass.target()).extent;
    begin_rendering(commands, index, extent, true);
    cover(commands, extent, drawn);
}

void FrameGraph::turn_external(VkCommandBuffer commands, bool begins) const {
    const Access drawn = Access::colour();
    VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    // Whatever the caller does with it: with all stages the layout's change waits for semaphores too, of any stage.
    barrier.srcStageMask = begins ? VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT : drawn.stages;
    barrier.srcAccessMask = begins ? VK_ACCESS_2_MEMORY_WRITE_BIT : VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
    barrier.dstStageMask = begins ? drawn.stages : VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.dstAccessMask = begins ? drawn.access : VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.oldLayout = begins ? bound_->before : drawn.layout;
    barrier.newLayout = begins ? drawn.layout : bound_->after;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = bound_->image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    pipeline_barrier(commands, {barrier}, {});
}

void FrameGraph::record_begin(const gpu::FrameTurn& turn) {
    turn_ = turn;
    ++frame_;
    for (const auto& callback : before_frame_)
        callback(turn);
    for (const BufferId id : std::exchange(stale_[turn.slot], {}))
        bind_anew(id, turn.slot);
    // A slot's frame is done before the slot's next one begins: two frames on, nobody has it.
    std::erase_if(retired_,
                  [&](const Retired& old) { return turn.alone || old.frame + gpu::frames_in_flight - 1 <= frame_; });
}

void FrameGraph::barrier(VkCommandBuffer commands, const std::vector<VkImageMemoryBarrier2>& images,
                         const std::vector<Pass::BufferBarrier>& buffers) const {
    std::vector<VkBufferMemoryBarrier2> filled;
    for (const Pass::BufferBarrier& one : buffers)
        filled.emplace_back(one.barrier).buffer = buffers_[one.buffer.index].handles[turn_.slot];
    pipeline_barrier(commands, images, filled);
}

void FrameGraph::record_pass(VkCommandBuffer commands, uint32_t index, bool one_pixel) const {
    const Pass& pass = *passes_[index];
    const uint32_t query = first_query(turn_.slot) + 2 * index;
    context_.begin_label(commands, pass.name_);
    // Before the barrier: lavapipe notes the time when it next waits, and a dispatch waits for nothing.
    vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, queries_, query);
    barrier(commands, pass.image_barriers_, pass.buffer_barriers_);
    const bool external = draws_external(pass);
    const std::optional<ImageId> target = external && !bound_ ? std::nullopt : pass.target();
    PassContext pass_context{commands, pass.sets_[turn_.slot], {}, turn_.slot, one_pixel};
    if (target) {
        pass_context.extent = raster(*target).extent;
        if (pass.before_rendering_)
            pass.before_rendering_(pass_context);
        if (external)
            turn_external(commands, true);
        begin_rendering(commands, index, pass_context.extent);
        const VkExtent2D drawn = one_pixel ? VkExtent2D{1, 1} : pass_context.extent;
        cover(commands, pass_context.extent, drawn);
        if (pass.between_)
            pass_context.between = [this, commands, index, drawn](const std::function<void()>& draw) {
                draw_between(commands, index, drawn, draw);
            };
    }
    if (target || !external)
        pass.record_(pass_context);
    if (target)
        vkCmdEndRendering(commands);
    if (target && external)
        turn_external(commands, false);
    vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, queries_, query + 1);
    context_.end_label(commands);
}

void FrameGraph::record_end(VkCommandBuffer commands) const { barrier(commands, {}, host_barriers_); }

void FrameGraph::record_pass(VkCommandBuffer commands, size_t index) {
    vkCmdResetQueryPool(commands, queries_, first_query(turn_.slot) + static_cast<uint32_t>(2 * index), 2);
    record_pass(commands, static_cast<uint32_t>(index), false);
    if (index + 1 == passes_.size())
        record_end(commands);
}

void FrameGraph::record(VkCommandBuffer commands, const gpu::FrameTurn& turn, bool one_pixel) {
    if (passes_.empty())
        return;
    record_begin(turn);
    vkCmdResetQueryPool(commands, queries_, first_query(turn.slot), static_cast<uint32_t>(2 * passes_.size()));
    for (uint32_t p = 0; p < passes_.size(); ++p)
        record_pass(commands, p, one_pixel);
    record_end(commands);
}

std::vector<std::pair<std::string, double>> FrameGraph::pass_times(uint32_t slot) const {
    if (passes_.empty())
        return {};
    std::vector<uint64_t> ticks(2 * passes_.size());
    gpu::check(vkGetQueryPoolResults(context_.device(), queries_, first_query(slot),
                                     static_cast<uint32_t>(ticks.size()), ticks.size() * 8, ticks.data(), 8,
                                     VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
               "timestamps");
    std::vector<std::pair<std::string, double>> times;
    for (size_t p = 0; p < passes_.size(); ++p)
        times.emplace_back(passes_[p]->name_,
                           static_cast<double>((ticks[2 * p + 1] - ticks[2 * p]) & context_.timestamp_mask()) *
                               static_cast<double>(context_.limits().timestampPeriod) * 1e-6);
    return times;
}

/// Into the layout that each frame finds and leaves them in.
void FrameGraph::begin_persistent_images() const {
    for (const GraphImage& image : images_) {
        if (!image.persistent || !image.usage)
            continue;
        context_.run("begin " + image.name, [&](VkCommandBuffer commands) {
            VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
            barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
            barrier.image = image.image;
            barrier.subresourceRange = {aspects(image.desc.format), 0, 1, 0, 1};
            if (!is_depth(image.desc.format)) {
                barrier.dstStageMask = VK_PIPELINE_STAGE_2_CLEAR_BIT;
                barrier.dstAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
                barrier.newLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
                pipeline_barrier(commands, {barrier}, {});
                const VkClearColorValue zero{};
                vkCmdClearColorImage(commands, image.image, barrier.newLayout, &zero, 1, &barrier.subresourceRange);
            }
            barrier.srcStageMask = std::exchange(barrier.dstStageMask, image.final_access.stages);
            barrier.srcAccessMask = std::exchange(barrier.dstAccessMask, image.final_access.access);
            barrier.oldLayout = std::exchange(barrier.newLayout, image.final_access.layout);
            pipeline_barrier(commands, {barrier}, {});
        });
    }
}

gpu::ShownImage FrameGraph::shown(ImageId id) const {
    const GraphImage& image = images_[id.index];
    if (!image.kept || !image.usage)
        throw Error("frame graph: image " + image.name + " was not kept");
    return {image.image, image.desc.raster.extent, image.final_access.stages, image.final_access.access,
            image.final_access.layout};
}

std::vector<std::byte> FrameGraph::read_back(ImageId id) const {
    const gpu::Buffer texels = read_back_buffer(id);
    return {texels.mapped<std::byte>(), texels.mapped<std::byte>() + texels.size()};
}

gpu::Buffer FrameGraph::read_back_buffer(ImageId id) const {
    const GraphImage& image = images_[id.index];
    if (!image.kept || !image.usage)
        throw Error("frame graph: image " + image.name + " was not kept");
    const VkExtent2D extent = image.desc.raster.extent;
    const bool depth = is_depth(image.desc.format); // copied alone, in 4 bytes
    const uint64_t size = uint64_t(extent.width) * extent.height * (depth ? 4 : texel_bytes(image.desc.format));
    gpu::Buffer target(context_, "readback", size, VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::BufferPlace::readback);
    const VkImageAspectFlags aspect = depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
    context_.run("read back " + image.name, [&](VkCommandBuffer commands) {
        VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
        barrier.srcStageMask = image.final_access.stages;
        barrier.srcAccessMask = image.final_access.access;
        barrier.dstStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
        barrier.dstAccessMask = VK_ACCESS_2_TRANSFER_READ_BIT;
        barrier.oldLayout = image.final_access.layout;
        barrier.newLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
        barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        barrier.image = image.image;
        barrier.subresourceRange = {aspects(image.desc.format), 0, 1, 0, 1};
        pipeline_barrier(commands, {barrier}, {});
        VkBufferImageCopy region{};
        region.imageSubresource = {aspect, 0, 0, 1};
        region.imageExtent = {extent.width, extent.height, 1};
        vkCmdCopyImageToBuffer(commands, image.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target.handle(), 1,
                               &region);
        // The image goes back to the layout that the next read_back() or frame expects.
        std::swap(barrier.oldLayout, barrier.newLayout);
        barrier.srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
        barrier.srcAccessMask = 0;
        barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
        barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT;
        pipeline_barrier(commands, {barrier}, {});
    });
    return target;
}

} // namespace prelight::graph
