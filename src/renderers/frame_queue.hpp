#pragma once
#include <deque>
#include <functional>
#include <gpu/command_slot.hpp>
#include <gpu/frames_in_flight.hpp>
#include <graph/frame_graph.hpp>
#include <string>
#include <utility>
#include <vector>

namespace prelight {

/// Each frame's figures of one run, milliseconds.
struct FrameSamples {
    std::vector<double> wall, cpu, gpu;
    std::vector<std::pair<std::string, std::vector<double>>> passes; ///< device time
};

/// Of one frame, milliseconds: as FrameSamples.
struct FrameFigures {
    uint64_t number = 0; ///< counts the device's frames; 0: there was none yet
    double wall = 0, cpu = 0, gpu = 0;
    std::vector<std::pair<std::string, double>> passes;
};

/// Frames in flight: the host records one while the device works on the one before, and waits only
/// for the frame whose buffers it needs again.
///
/// The device finishes frames one after the other, so a frame's wall and CPU time are what passed
/// from the end of the frame before (or from start()) to its own end, as the host sees them: the
/// distance between pictures. Between two ends lie one frame's work on the device and one frame's on
/// the host, mostly that of the next one; a run's samples sum up to the run.
class FrameQueue {
public:
    explicit FrameQueue(const gpu::Context& context);
    ~FrameQueue();
    FrameQueue(const FrameQueue&) = delete;
    FrameQueue& operator=(const FrameQueue&) = delete;

    /// Begins a run. Frames of the last one that are still in flight are in no run's samples.
    void start();
    /// Waits for the next slot's last frame and begins its commands. Throws Error.
    gpu::FrameTurn begin();
    VkCommandBuffer commands() const { return slots_[slot_].commands; }
    /// Submits what was recorded since begin(), a frame of `graph`.
    void submit(const graph::FrameGraph& graph, const gpu::Context::Semaphores& semaphores = {});
    /// Waits for all frames. Throws Error.
    void drain();
    /// Records commands, submits them and waits; no frame may be in flight, and none is counted.
    void run(const std::function<void(VkCommandBuffer)>& record);
    const FrameSamples& samples() const { return samples_; }
    /// Of the last frame that is done, whichever run it was in. Waits for none. From the first call on times are asked
    /// for after each frame.
    const FrameFigures& last_frame();

private:
    struct Pending {
        uint32_t slot = 0;
        uint64_t value = 0; ///< of the context's timeline
        uint64_t run = 0;
        const graph::FrameGraph* graph = nullptr;
    };
    uint64_t end_commands(const gpu::Context::Semaphores& semaphores = {});
    void collect();

    const gpu::Context& context_;
    gpu::PerFrame<gpu::CommandSlot> slots_;
    uint32_t slot_ = 0;
    bool drained_ = true; ///< since then no frame was submitted
    std::deque<Pending> pending_;
    uint64_t run_ = 0;
    double last_wall_ = 0, last_cpu_ = 0; ///< at the end of the last frame
    FrameSamples samples_;
    FrameFigures last_;
    bool watched_ = false; ///< last_frame() was called
};

} // namespace prelight
