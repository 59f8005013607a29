#pragma once
#include "device_renderer.hpp"
#include <passes/light_scale.hpp>
#include <passes/materials.hpp>

namespace prelight {

/// What the architectures with a light buffer have in common: the stage between surfaces and materials, and its views.
class LightBufferRenderer : public DeviceRenderer {
public:
    LightBufferRenderer(Device& device, const RenderOptions& options, Settings settings,
                        const passes::LightModel& model)
        : DeviceRenderer(device, options, std::move(settings)), model_(model) {}

protected:
    uint32_t blended_adds(const resident::View& view) const override;
    /// What a view has for its lights to be evaluated: culling, and the scale of fixed-point light buffers.
    void add_light_settings(resident::ViewSettings& view) const;

    /// Stage 2, done.
    struct LightStage {
        passes::LightBuffer light;
        passes::LightBuffer sample_light;         ///< of edge pixels' samples, where there are several
        std::optional<passes::SampleEdges> edges; ///< where they lie in it
        passes::LightingInputs lighting;
    };
    /// All lights of `view`, culled as it says, on `surfaces`.
    LightStage light_stage(graph::FrameGraph& graph, const resident::View& view,
                           const passes::SampledSurfaces& surfaces);
    void own_passes_after_light(graph::FrameGraph& graph, const resident::View& view,
                                const passes::SurfaceBuffers& surface, const passes::LightBuffer& light) {
        own_passes(vulkan::Stage::after_light, graph, view, surface,
                   {{"diffuse-light", light.diffuse}, {"specular-light", light.specular}});
    }
    /// Whether there is anything for stage 2: not in a scene that its environment alone lights, for one.
    bool has_light(const resident::View& view) const {
        return !view.lights().placed().empty() || model_.ambient_as_light;
    }
    /// The light buffer of a picture without light: black from the beginning, and no pass writes it.
    passes::LightBuffer black_light(graph::FrameGraph& graph, const resident::View& view) const;
    /// What of ambient light reaches `surface`, where the setting `ssao` or a view asks for it.
    std::optional<graph::ImageId> visibility(graph::FrameGraph& graph, const resident::View& view,
                                             const passes::SurfaceBuffers& surface) const;
    /// Whether materials see it.
    bool occludes() const;
    /// The views of surfaces and light that were asked for, at the resolution of `view`.
    void add_light_views(Outputs& outputs, graph::FrameGraph& graph, const resident::View& view,
                         const LightStage& stage, std::optional<graph::ImageId> visibility) const;
    /// The views of what materials make of it, at the picture's.
    void add_material_views(Outputs& outputs, graph::FrameGraph& graph, const resident::View& view,
                            const passes::SurfaceBuffers& surface, const passes::MaterialInputs& materials) const;
    void add_figures(Stats& stats) const override;

    const passes::LightModel& model() const { return model_; }

private:
    passes::LightModel model_;
    std::optional<passes::LightScale> scale_; ///< of a light buffer in fixed point
};

} // namespace prelight
