#include "buffer_updates.hpp"
#include "barrier.hpp"
#include <cstring>

namespace prelight::gpu {

void BufferUpdates::write(const Buffer& target, uint64_t offset, std::span<const std::byte> bytes) {
    if (bytes.empty())
        return;
    const auto [known, is_new] = known_.try_emplace({target.handle(), offset}, regions_.size());
    if (is_new) {
        regions_.push_back({target.handle(), {bytes_.size(), offset, bytes.size()}});
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    } else {
        std::memcpy(bytes_.data() + regions_[known->second].copy.srcOffset, bytes.data(), bytes.size());
    }
}

void BufferUpdates::record(VkCommandBuffer commands, Buffer& staging) {
    if (bytes_.empty())
        return;
    if (staging.size() < bytes_.size())
        staging = Buffer(context_, "update staging", bytes_.size() + bytes_.size() / 2,
                         VK_BUFFER_USAGE_TRANSFER_SRC_BIT, BufferPlace::upload);
    std::memcpy(staging.mapped<std::byte>(), bytes_.data(), bytes_.size());
    context_.begin_label(commands, "world updates");
    constexpr VkPipelineStageFlags2 all = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, copy = VK_PIPELINE_STAGE_2_COPY_BIT;
    memory_barrier(commands, all, VK_ACCESS_2_NONE, copy, VK_ACCESS_2_TRANSFER_WRITE_BIT); // earlier frames have read
    for (const Region& region : regions_)
        vkCmdCopyBuffer(commands, staging.handle(), region.target, 1, &region.copy);
    memory_barrier(commands, copy, VK_ACCESS_2_TRANSFER_WRITE_BIT, all, VK_ACCESS_2_MEMORY_READ_BIT);
    context_.end_label(commands);
    bytes_.clear();
    regions_.clear();
    known_.clear();
}

} // namespace prelight::gpu
