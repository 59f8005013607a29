#pragma once
#include "depth_normal.hpp"
#include <gpu/buffer.hpp>

namespace prelight::passes {

/// SMAA 1x (Jimenez, Echevarria, Sousa and Gutierrez, "SMAA: Enhanced Subpixel Morphological Antialiasing",
/// Eurographics 2012) of finished pictures. Quality "high": threshold 0.1, 16 search steps, 8 along diagonals, corner
/// rounding 25.
class Smaa {
public:
    /// Puts the table of areas on the device. Throws Error.
    explicit Smaa(const gpu::Context& context);
    /// `picture` with smooth edges; `surface` as edge_blur_pass() takes it. This must outlive the graph.
    graph::ImageId add(graph::FrameGraph& graph, const resident::View& view, const SurfaceBuffers& surface,
                       graph::ImageId picture) const;

private:
    gpu::Buffer areas_;
};

} // namespace prelight::passes
