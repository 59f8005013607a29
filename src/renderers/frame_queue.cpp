#include "frame_queue.hpp"
#include <fmt/format.h>
#include <gpu/check.hpp>
#include <prelight/error.hpp>
#include <timing/clocks.hpp>

namespace prelight {

FrameQueue::FrameQueue(const gpu::Context& context) : context_(context) {
    for (uint32_t s = 0; s < gpu::frames_in_flight; ++s) {
        VkCommandPoolCreateInfo info{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
        info.queueFamilyIndex = context_.queue_family();
        VkCommandPool pool = VK_NULL_HANDLE;
        gpu::check(vkCreateCommandPool(context_.device(), &info, nullptr, &pool), "command pool");
        slots_[s].pool = {context_.device(), pool};
        const std::string name = fmt::format("frame commands {}", s);
        context_.set_name(VK_OBJECT_TYPE_COMMAND_POOL, reinterpret_cast<uint64_t>(pool), name);
        VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
        allocate.commandPool = pool;
        allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
        allocate.commandBufferCount = 1;
        gpu::check(vkAllocateCommandBuffers(context_.device(), &allocate, &slots_[s].commands), "command buffer");
        context_.set_name(VK_OBJECT_TYPE_COMMAND_BUFFER, reinterpret_cast<uint64_t>(slots_[s].commands), name);
    }
}

FrameQueue::~FrameQueue() {
    try {
        drain();
    } catch (const Error&) { // the device is lost: nothing is in flight any more
    }
}

void FrameQueue::start() {
    while (!pending_.empty() && context_.is_done(pending_.front().value))
        collect();
    ++run_;
    samples_ = {};
    if (pending_.empty()) {
        last_wall_ = wall_ms();
        last_cpu_ = process_ms();
    }
}

gpu::FrameTurn FrameQueue::begin() {
    slot_ = (slot_ + 1) % gpu::frames_in_flight;
    while (!pending_.empty() && pending_.front().slot == slot_)
        collect();
    begin_commands();
    return {slot_, drained_};
}

void FrameQueue::begin_commands() {
    const Slot& slot = slots_[slot_];
    gpu::check(vkResetCommandPool(context_.device(), slot.pool, 0), "command pool");
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    gpu::check(vkBeginCommandBuffer(slot.commands, &begin), "frame");
}

uint64_t FrameQueue::end_commands() {
    gpu::check(vkEndCommandBuffer(commands()), "frame");
    return context_.submit(commands());
}

void FrameQueue::submit(const graph::FrameGraph& graph) {
    drained_ = false;
    pending_.push_back({slot_, end_commands(), run_, &graph});
}

void FrameQueue::collect() {
    const Pending frame = pending_.front();
    context_.wait(frame.value);
    pending_.pop_front();
    const double wall = wall_ms(), cpu = process_ms();
    // lavapipe waits for the whole device before it tells times: only where somebody looks at them.
    if (frame.run == run_ || watched_) {
        last_ = {last_.number + 1, wall - last_wall_, cpu - last_cpu_, 0, frame.graph->pass_times(frame.slot)};
        for (const auto& [name, time] : last_.passes)
            last_.gpu += time;
    }
    if (frame.run == run_) {
        samples_.wall.push_back(last_.wall);
        samples_.cpu.push_back(last_.cpu);
        samples_.passes.resize(last_.passes.size());
        for (size_t p = 0; p < last_.passes.size(); ++p) {
            samples_.passes[p].first = last_.passes[p].first;
            samples_.passes[p].second.push_back(last_.passes[p].second);
        }
        samples_.gpu.push_back(last_.gpu);
    }
    last_wall_ = wall;
    last_cpu_ = cpu;
}

const FrameFigures& FrameQueue::last_frame() {
    watched_ = true;
    while (!pending_.empty() && context_.is_done(pending_.front().value))
        collect();
    return last_;
}

void FrameQueue::drain() {
    while (!pending_.empty())
        collect();
    drained_ = true;
}

void FrameQueue::run(const std::function<void(VkCommandBuffer)>& record) {
    begin_commands();
    record(commands());
    context_.wait(end_commands());
}

} // namespace prelight
