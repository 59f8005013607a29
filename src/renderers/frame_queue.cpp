#include "frame_queue.hpp"
#include <fmt/format.h>
#include <gpu/check.hpp>
#include <platform/clocks.hpp>
#include <prelight/error.hpp>

namespace prelight {

FrameQueue::FrameQueue(const gpu::Context& context) : context_(context) {
    for (uint32_t s = 0; s < gpu::frames_in_flight; ++s)
        slots_[s] = gpu::make_command_slot(context_, fmt::format("frame commands {}", s));
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
    gpu::begin_commands(context_, slots_[slot_]);
    return {slot_, drained_};
}

uint64_t FrameQueue::end_commands(const gpu::Context::Semaphores& semaphores) {
    gpu::check(vkEndCommandBuffer(commands()), "frame");
    return context_.submit(commands(), semaphores);
}

void FrameQueue::submit(const graph::FrameGraph& graph, const gpu::Context::Semaphores& semaphores) {
    drained_ = false;
    pending_.push_back({slot_, end_commands(semaphores), run_, &graph});
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
    gpu::begin_commands(context_, slots_[slot_]);
    record(commands());
    context_.wait(end_commands());
}

} // namespace prelight
