#pragma once
#include "device_renderer.hpp"
#include <passes/forward.hpp>

namespace prelight {

/// What the forward architectures have in common: the lighting model, lights found for each object,
/// and the way from the linear picture to the views.
class ForwardRenderer : public DeviceRenderer {
protected:
    ForwardRenderer(Device& device, const RenderOptions& options, Settings settings, resident::ObjectLights order);
    resident::ViewSettings view_settings() const override;
    uint64_t draws(const resident::View&) const override { return draws_; }

    /// What counts lights for --view light-count: each pixel's, as the renderer finds them.
    virtual void light_count_pass(graph::FrameGraph& graph, const resident::View& view,
                                  const passes::ForwardInputs& counts) const {
        passes::forward_pass(graph, view, counts);
    }
    /// How many draws of `per_pass` lights may add to a pixel: those whose lights reach the surface there.
    static uint32_t most_batches(const resident::View& view, uint32_t per_pass);
    /// The plan with the largest values that its steps may add to the target.
    using Plan = std::function<passes::ForwardPlan(const resident::LightReach&)>;
    Plan limited(Plan plan) const;
    /// A pass that draws into `colour`; the caller adds kinds and plan. Its draws are counted.
    passes::ForwardInputs shading(const char* name, graph::ImageId depth, graph::ImageId colour);
    /// Depth alone, without normals.
    static passes::SurfaceBuffers surface_of(graph::ImageId depth) {
        return {.format = {}, .depth = depth, .depth_source = depth, .normal = depth, .roughness = depth};
    }
    /// Adds the other views that were asked for.
    void add_views(Outputs& outputs, graph::FrameGraph& graph, const resident::View& view, graph::ImageId depth) const;

    passes::DecalBuffer decals_; ///< of the graph that is built: what shading() and add_views() draw with

private:
    passes::LightModel model_;
    resident::ObjectLights order_;
    uint64_t draws_ = 0; ///< of the last recording of the pass with lights
};

/// The settings that both have, after `own`; and their views. `twice`: as draw_settings() has it.
std::vector<SettingInfo> forward_settings(std::vector<SettingInfo> own, bool twice);
std::vector<std::string> forward_views();

} // namespace prelight
