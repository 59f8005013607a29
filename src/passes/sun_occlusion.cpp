#include "sun_occlusion.hpp"
#include "light_draws.hpp"
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

class SunOcclusion {
public:
    SunOcclusion(const resident::Frame& frame, const graph::PassInterface& interface, const SurfaceFormat& surface,
                 const Shadows& shadows)
        : frame_(frame) {
        gpu::GraphicsPipelineDesc desc;
        desc.name = "sun occlusion";
        desc.vertex = "fullscreen.vert";
        desc.fragment = "sun_occlusion.frag";
        desc.constants = surface.constants();
        add_shadow_constants(desc.constants, frame);
        desc.constants.emplace_back(CONSTANT_LIGHT_KINDS, frame.light_kinds());
        desc.blend = gpu::Blend::alpha_only;
        desc.colour_formats = interface.colour_formats;
        desc.sets = {frame.layout(), interface.inputs};
        pipeline_ = gpu::GraphicsPipeline(frame.context(), desc);
        if (shadows.reused)
            maps_.emplace(frame, interface.inputs, shadows);
    }

    void record(const graph::PassContext& pass) {
        if (maps_)
            maps_->begin(pass);
        const auto sun = frame_.shadows()->sun();
        if (!sun && !pass.one_pixel)
            return;
        if (maps_ && sun)
            maps_->record_light(pass, sun->first);
        bind_lighting(pass, frame_, pipeline_);
        vkCmdDraw(pass.commands, 3, 1, 0, 0);
    }

private:
    const resident::Frame& frame_;
    gpu::GraphicsPipeline pipeline_;
    std::optional<ShadowDraws> maps_; ///< Shadows::reused
};

} // namespace

Shadows sun_occlusion_pass(graph::FrameGraph& graph, const resident::Frame& frame, const GBuffer& gbuffer,
                           Shadows shadows) {
    if (!shadows)
        return shadows;
    graph::Pass& pass = graph.pass("sun occlusion");
    pass.colour(gbuffer.albedo, graph::Load::keep)
        .sample(INPUT_DEPTH, gbuffer.surface.depth_source)
        .sample(INPUT_NORMAL, gbuffer.surface.normal);
    declare_shadows(pass, shadows);
    auto draws = std::make_shared<std::optional<SunOcclusion>>();
    pass.prepare([=, &frame, surface = gbuffer.surface.format](const graph::PassInterface& interface) {
        draws->emplace(frame, interface, surface, shadows);
    });
    pass.record([draws](const graph::PassContext& context) { (*draws)->record(context); });
    shadows.sun_stored = true;
    return shadows;
}

} // namespace prelight::passes
