#include "uploader.hpp"
#include "check.hpp"
#include <algorithm>
#include <prelight/error.hpp>
#include <utility>

namespace prelight::gpu {
namespace {

constexpr uint64_t block_bytes = 8u << 20; ///< a larger thing gets a block of its own size

} // namespace

Uploader::~Uploader() {
    for (const Block& block : blocks_)
        if (block.submitted)
            try {
                context_.wait(block.submitted);
            } catch (const Error&) { // the device is lost: it reads no memory any more
            }
}

Uploader::Staging Uploader::stage(uint64_t size) {
    size = (size + 15) / 16 * 16;
    if (recording_ && blocks_[current_].used + size > blocks_[current_].buffer.size())
        submit();
    if (!recording_)
        begin(size);
    Block& block = blocks_[current_];
    const uint64_t offset = std::exchange(block.used, block.used + size);
    return {block.buffer.mapped<std::byte>() + offset, block.buffer.handle(), offset};
}

void Uploader::begin(uint64_t size) {
    Block& block = blocks_[current_];
    if (const uint64_t value = std::exchange(block.submitted, 0))
        context_.wait(value);
    if (block.buffer.size() < size)
        block.buffer = Buffer(context_, "staging", std::max(size, block_bytes), VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                              BufferPlace::upload);
    block.used = 0;
    if (!block.pool) {
        VkCommandPoolCreateInfo info{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
        info.queueFamilyIndex = context_.queue_family();
        VkCommandPool pool = VK_NULL_HANDLE;
        check(vkCreateCommandPool(context_.device(), &info, nullptr, &pool), "upload commands");
        block.pool = {context_.device(), pool};
        VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
        allocate.commandPool = pool;
        allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
        allocate.commandBufferCount = 1;
        check(vkAllocateCommandBuffers(context_.device(), &allocate, &block.commands), "upload commands");
    }
    check(vkResetCommandPool(context_.device(), block.pool, 0), "upload commands");
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(block.commands, &begin), "upload");
    context_.begin_label(block.commands, "upload");
    recording_ = true;
}

void Uploader::submit() {
    Block& block = blocks_[current_];
    context_.end_label(block.commands);
    check(vkEndCommandBuffer(block.commands), "upload");
    block.submitted = context_.submit(block.commands);
    recording_ = false;
    current_ = (current_ + 1) % frames_in_flight;
}

void Uploader::finish() {
    if (recording_)
        submit();
    for (Block& block : blocks_)
        if (const uint64_t value = std::exchange(block.submitted, 0))
            context_.wait(value);
}

} // namespace prelight::gpu
