#include "visible_pixels.hpp"
#include <algorithm>
#include <gpu/check.hpp>

namespace prelight::resident {

VisiblePixels::VisiblePixels(const gpu::Context& context, uint32_t most_draws)
    : context_(context), most_(std::max(most_draws, 1u)) {
    VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
    info.queryType = VK_QUERY_TYPE_OCCLUSION;
    info.queryCount = most_;
    VkQueryPool pool = VK_NULL_HANDLE;
    gpu::check(vkCreateQueryPool(context.device(), &info, nullptr, &pool), "occlusion queries");
    queries_ = {context.device(), pool};
    context.set_name(VK_OBJECT_TYPE_QUERY_POOL, reinterpret_cast<uint64_t>(pool), "visible pixels");
    const uint64_t bytes = most_ * sizeof(uint32_t);
    conditions_ = gpu::Buffer(context, "draw conditions", bytes,
                              VK_BUFFER_USAGE_CONDITIONAL_RENDERING_BIT_EXT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                              gpu::BufferPlace::device);
    for (gpu::Buffer& one : host_counts_)
        one =
            gpu::Buffer(context, "visible pixels", bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::BufferPlace::readback);
}

void VisiblePixels::reset(VkCommandBuffer commands) const { vkCmdResetQueryPool(commands, queries_, 0, most_); }

void VisiblePixels::begin(VkCommandBuffer commands, uint32_t draw) const {
    vkCmdBeginQuery(commands, queries_, draw, 0);
}

void VisiblePixels::end(VkCommandBuffer commands, uint32_t draw) const { vkCmdEndQuery(commands, queries_, draw); }

void VisiblePixels::copy(VkCommandBuffer commands, uint32_t slot, uint32_t draws) const {
    if (draws == 0)
        return;
    for (const gpu::Buffer* to : {&conditions_, &host_counts_[slot]})
        vkCmdCopyQueryPoolResults(commands, queries_, 0, draws, to->handle(), 0, sizeof(uint32_t),
                                  VK_QUERY_RESULT_WAIT_BIT); // on the device
}

void VisiblePixels::begin_if_visible(VkCommandBuffer commands, uint32_t draw) const {
    context_.begin_conditional(commands, conditions_.handle(), draw * sizeof(uint32_t));
}

void VisiblePixels::end_if_visible(VkCommandBuffer commands) const { context_.end_conditional(commands); }

uint64_t VisiblePixels::hidden(uint32_t slot, uint32_t draws) const {
    const uint32_t* counts = host_counts_[slot].mapped<uint32_t>();
    return static_cast<uint64_t>(std::count(counts, counts + draws, 0u));
}

} // namespace prelight::resident
