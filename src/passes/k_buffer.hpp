#pragma once
#include <gpu/buffer.hpp>
#include <gpu/pipeline.hpp>
#include <graph/frame_graph.hpp>
#include <memory>
#include <resident/view.hpp>
#include <string>

namespace prelight::passes {

/// A k-buffer (Bavoil and others, Multi-Fragment Effects on the GPU using the k-Buffer, I3D 2007): depths of the
/// nearest layers of blended surfaces of each sample, sorted whatever order they are drawn in, by atomic operations on
/// 32 bits.
class KBuffer {
public:
    /// Passes "NAME none", which empties the slots, and NAME, which fills them with what lies at or before `opaque`.
    /// `count` ≥ 1: of each sample; fewer where a buffer of the device holds no more, with a note. Throws Error where
    /// it does not hold one.
    KBuffer(graph::FrameGraph& graph, const resident::View& view, const std::string& name, graph::ImageId opaque,
            uint32_t count);
    uint32_t count() const { return count_; }
    /// A pass `name`: depths of the layers that have `slot` nearer ones, 0 where there is none. The image is drawn over
    /// by the next call.
    graph::ImageId depth(graph::FrameGraph& graph, const resident::View& view, const std::string& name, uint32_t slot);
    /// For a pass whose shader reads slots (shaders/shared/k_buffer.glsl) and runs once a sample.
    void declare(graph::Pass& pass) const;
    gpu::Constants constants() const;

private:
    uint32_t count_, samples_;
    std::shared_ptr<const gpu::Buffer> buffer_;
    graph::BufferId slots_;
    graph::ImageId depth_;
};

} // namespace prelight::passes
