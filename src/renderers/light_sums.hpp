#pragma once
#include "settings/settings.hpp"
#include <gpu/context.hpp>
#include <graph/frame_graph.hpp>

namespace prelight {

/// The setting `light-sums`, of every architecture that adds up light by blending.
SettingInfo light_sums_setting();

/// Which floats blended light is added up in. Each add into a half float may lose a step of the sum, 2⁻¹⁰ of it, where
/// blending cuts off; after n adds of equal lights at most (n + 1) / 2048 of the sum is gone, and half of that on
/// average. So up to `most_in_half` adds stay below 0.9 %, and more are added up in full floats.
class LightSums {
public:
    static constexpr uint32_t most_in_half = 16;
    explicit LightSums(const Settings& settings);
    /// For a graph that is built now, in which blending adds up to `adds` times to a pixel. Puts what is in force into
    /// the settings; where the device does not blend full floats, the graph's notes say so.
    void choose(Settings& settings, graph::FrameGraph& graph, const gpu::Context& context, uint32_t adds);
    bool wide() const { return wide_; }
    /// Where half floats are taken: how often one is added to at most.
    uint32_t most_adds() const { return asked_ == "auto" && blends_ ? most_in_half : ~0u; }
    /// Whether as many adds would be added up in the same. What came before has no say: a renderer that is kept gives
    /// the picture of a new one.
    bool holds(uint32_t adds) const;

private:
    std::string asked_; ///< empty: the renderer has no such setting
    bool wide_ = false, blends_ = true;
};

} // namespace prelight
