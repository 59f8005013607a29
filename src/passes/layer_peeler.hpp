#pragma once
#include <array>
#include <graph/frame_graph.hpp>
#include <resident/view.hpp>
#include <string>

namespace prelight::passes {

/// Depths of the layers of blended surfaces one after another. The farthest first: depth peeling in reverse order
/// (Thibieroz, Robust Order-Independent Transparency via Reverse Depth Peeling, ShaderX6, 2008), so that each layer can
/// be blended as soon as it is found. Or the nearest first (Everitt, Interactive Order-Independent Transparency, 2001),
/// to show one by its number. Two depth images, however many layers there are.
class LayerPeeler {
public:
    enum class First { farthest, nearest };
    /// `opaque`: depth of what lies behind all layers, of one or of several samples a pixel.
    LayerPeeler(graph::FrameGraph& graph, const resident::View& view, graph::ImageId opaque,
                First order = First::farthest);
    /// A pass `name`: for each sample the depth of the farthest blended surface before that of the call before, the
    /// first time of the farthest one at or before what is opaque; 1 where there is none. Of First::nearest the nearest
    /// one behind that of the call before; 0 where there is none. The image is drawn over by the next call but one.
    graph::ImageId next(graph::FrameGraph& graph, const resident::View& view, const std::string& name);
    /// What the last call returned; before the first `opaque`.
    graph::ImageId last() const { return last_; }

private:
    graph::ImageId opaque_, last_;
    std::array<graph::ImageId, 2> depths_; ///< in turn
    First order_;
    bool first_ = true;
};

} // namespace prelight::passes
