#pragma once
#include "settings/antialiasing_settings.hpp"
#include <optional>
#include <passes/smaa.hpp>

namespace prelight {

/// What comes after tone mapping: the setting `antialiasing`.
class PostFilter {
public:
    PostFilter(const Settings& settings, const gpu::Context& context);
    /// The finished `picture` filtered, or itself. This must outlive the graph.
    graph::ImageId add(graph::FrameGraph& graph, const resident::View& view, const passes::SurfaceBuffers& surface,
                       graph::ImageId picture) const;

private:
    Antialiasing kind_;
    std::optional<passes::Smaa> smaa_;
};

} // namespace prelight
