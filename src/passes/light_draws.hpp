#pragma once
#include "lighting.hpp"
#include "shadow_draws.hpp"
#include <array>
#include <gpu/pipeline.hpp>
#include <optional>

namespace prelight::passes {

/// A group of lights that have a volume.
struct VolumeGroup {
    resident::LightGroup group;
    const char* name;
    bool spot;
    bool inside; ///< the camera is inside, or the near plane cuts the volume
    size_t index() const { return static_cast<size_t>(group); }
};
inline constexpr std::array<VolumeGroup, 4> volume_groups{{
    {resident::LightGroup::sphere_outside, "spheres from outside", false, false},
    {resident::LightGroup::sphere_inside, "spheres from inside", false, true},
    {resident::LightGroup::cone_outside, "spots from outside", true, false},
    {resident::LightGroup::cone_inside, "spots from inside", true, true},
}};

/// Binds a pipeline of a light pass, with the frame's set and the pass's inputs.
void bind_lighting(const graph::PassContext& pass, const resident::View& view, const gpu::GraphicsPipeline& pipeline);

/// What a pass draws that sums all lights of a pixel at once: every pixel, or the samples of edge pixels.
gpu::ShaderKey lit_vertices(const LightingInputs& inputs);
void draw_lit(const graph::PassContext& pass, const std::optional<SampleEdges>& edges);

/// Ambient light as a light of its own, added to the target by a full-screen triangle; draws nothing where
/// ambient light is a term of the material, or is summed with the others.
class AmbientDraw {
public:
    AmbientDraw(const resident::View& view, const graph::PassInterface& interface, const LightingInputs& inputs);
    static bool needed(const LightingInputs& inputs);
    void record(const graph::PassContext& pass) const;

private:
    const resident::View& view_;
    std::optional<SampleEdges> edges_;
    std::optional<gpu::GraphicsPipeline> pipeline_;
};

/// What all passes share that draw light by light: pipelines that add to the target, ambient light and
/// the lights that are drawn full screen.
class LightDraws {
public:
    LightDraws(const resident::View& view, const graph::PassInterface& interface, const LightingInputs& inputs);
    void record_fullscreen(const graph::PassContext& pass) const;
    /// A pipeline of light.frag that blends ONE/ONE.
    gpu::GraphicsPipelineDesc pipeline(const char* name, const char* vertex) const;
    void bind(const graph::PassContext& pass, const gpu::GraphicsPipeline& pipeline) const {
        bind_lighting(pass, view_, pipeline);
    }
    /// Calls draw(first, count) for lights of the frame's order: all at once, or one by one, each after its shadow
    /// maps. `draw` binds all that it needs.
    template <class Draw>
    void each(const graph::PassContext& pass, uint32_t first, uint32_t count, Draw&& draw) const {
        if (count == 0)
            return;
        if (!maps_ || pass.one_pixel)
            return draw(first, count);
        for (uint32_t i = first; i < first + count; ++i) {
            if (!in_gbuffer(lights().order[i]))
                maps_->record_light(pass, lights().order[i]);
            draw(i, 1u);
        }
    }
    const resident::View& view() const { return view_; }
    const resident::LightGroups& lights() const { return view_.light_groups(); }

private:
    /// The light's shadow waits there: nobody looks at its maps.
    bool in_gbuffer(uint32_t light) const {
        const auto sun = view_.shadows()->sun();
        return sun_stored_ && sun && sun->light == light;
    }
    const resident::View& view_;
    gpu::GraphicsPipelineDesc light_;
    AmbientDraw ambient_;
    bool sun_stored_ = false;
    gpu::GraphicsPipeline fullscreen_;
    std::unique_ptr<ShadowDraws> maps_; ///< Shadows::reused
};

/// Makes `pass` draw with a Draws(view, interface, inputs) that has a record().
template <class Draws>
void draw_lights(graph::Pass& pass, const resident::View& view, const LightingInputs& inputs) {
    auto draws = std::make_shared<std::optional<Draws>>();
    pass.prepare([=, &view](const graph::PassInterface& interface) { draws->emplace(view, interface, inputs); });
    pass.record([draws](const graph::PassContext& context) { (*draws)->record(context); });
}

} // namespace prelight::passes
