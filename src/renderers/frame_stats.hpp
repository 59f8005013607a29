#pragma once
#include "frame_queue.hpp"
#include <gpu/context.hpp>
#include <prelight/renderer.hpp>
#include <resident/view.hpp>

namespace prelight {

/// What has been made on the device, less `before`.
CreatedObjects created_since(const gpu::Context& context, const CreatedObjects& before);

/// What the host gave the device for one frame.
struct UploadedBytes {
    uint64_t updates = 0; ///< of the world
    uint64_t frame = 0;   ///< for this frame alone
};

/// What the frames of one render() cost the host, sample by sample.
class FrameStats {
public:
    void start(uint32_t frames);
    /// One frame: changes taken in before it, its update, its recording (milliseconds), what it made and uploaded.
    void add(double changes_ms, const resident::UpdateTimes& times, double record_ms, const CreatedObjects& created,
             const UploadedBytes& uploaded);
    /// CPU time of pass number `pass`, submitted alone.
    void add_pass(size_t pass, double cpu_ms);
    /// With the device's samples, and what each pass moves.
    void tell(Stats& stats, const FrameSamples& samples, const std::vector<graph::PassTraffic>& traffic) const;

private:
    uint32_t frames_ = 0;
    CreatedObjects created_; ///< by the last frame
    UploadedBytes uploaded_; ///< for it
    std::vector<double> lights_, culling_, objects_, record_;
    std::vector<std::vector<double>> pass_cpu_;
};

} // namespace prelight
