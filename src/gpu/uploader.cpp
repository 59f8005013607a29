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
    if (!block.recorded.commands)
        block.recorded = make_command_slot(context_, "upload commands");
    begin_commands(context_, block.recorded);
    context_.begin_label(commands(), "upload");
    recording_ = true;
}

void Uploader::submit() {
    Block& block = blocks_[current_];
    context_.end_label(commands());
    check(vkEndCommandBuffer(commands()), "upload");
    block.submitted = context_.submit(commands());
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
