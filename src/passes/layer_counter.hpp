#pragma once
#include <gpu/buffer.hpp>
#include <gpu/frames_in_flight.hpp>
#include <graph/frame_graph.hpp>
#include <resident/view.hpp>

namespace prelight::passes {

/// How many blended surfaces lie before what is opaque, for each sample: a pass `name` draws them into one float each.
graph::ImageId layer_count_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                                graph::ImageId depth);

/// Sums that up over a picture, and keeps what is known of the frames that are done. Outlives the graph.
class LayerCounter {
public:
    explicit LayerCounter(const gpu::Context& context);
    /// A pass `name` that counts the layers of `image`, layer_count_pass()'s. `exact`: of each sample, those that the
    /// graph draws one by one.
    void count(graph::FrameGraph& graph, const resident::View& view, const std::string& name, graph::ImageId image,
               uint32_t exact);
    /// The most layers of a sample in the slot's last frame, which is done; 0 where there was none.
    uint32_t most(uint32_t slot) const;
    /// The same of all last frames; no frame is in flight.
    uint32_t most() const;
    /// No frame has been counted; none is in flight.
    void forget();
    /// Of the last frame, which is done: its largest number of layers on a sample, their mean, and how many there were
    /// beyond the exact ones, in pixels.
    struct Sums {
        uint32_t most = 0;
        double mean = 0, more = 0;
    };
    Sums last() const;

private:
    gpu::PerFrame<gpu::Buffer> counts_;
    uint32_t slot_ = 0;  ///< of the last recording
    gpu::Raster raster_; ///< of the image
};

} // namespace prelight::passes
