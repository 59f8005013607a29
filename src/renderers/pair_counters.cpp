#include "pair_counters.hpp"
#include <gpu/barrier.hpp>

namespace prelight {

PairCounters::PairCounters(const gpu::Context& context, uint32_t height)
    : height_(height),
      buffer_(context, "pair counters", uint64_t(height) * 2 * sizeof(uint32_t),
              VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::BufferPlace::readback) {}

void PairCounters::clear(VkCommandBuffer commands) const {
    gpu::memory_barrier(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT,
                        VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT);
    vkCmdFillBuffer(commands, buffer_.handle(), 0, VK_WHOLE_SIZE, 0);
    gpu::memory_barrier(commands, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                        VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                        VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
}

void PairCounters::tell(Stats& stats) const {
    const uint32_t* rows = buffer_.mapped<uint32_t>();
    for (size_t y = 0; y < height_; ++y) {
        stats.pairs_evaluated += rows[2 * y];
        stats.pairs_contributing += rows[2 * y + 1];
    }
}

} // namespace prelight
