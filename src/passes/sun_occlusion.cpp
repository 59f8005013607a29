#include "sun_occlusion.hpp"
#include "light_draws.hpp"
#include "lighting.hpp"
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

class SunOcclusion {
public:
    SunOcclusion(const resident::View& view, const graph::PassInterface& interface, const SurfaceFormat& surface,
                 const Shadows& shadows)
        : view_(view) {
        gpu::GraphicsPipelineDesc desc;
        desc.name = "sun occlusion";
        desc.vertex = "fullscreen.vert";
        desc.fragment = "sun_occlusion.frag";
        desc.constants = surface.constants();
        add_light_constants(desc.constants, view);
        desc.blend = gpu::Blend::alpha_only;
        desc.attachments = interface.attachments;
        desc.sets = {view.layout(), interface.inputs};
        pipeline_ = gpu::GraphicsPipeline(view.context(), desc);
        if (shadows.reused)
            maps_.emplace(view, interface.inputs, shadows);
    }

    void record(const graph::PassContext& pass) {
        if (maps_)
            maps_->begin(pass);
        const auto sun = view_.shadows()->sun();
        if (!sun && !pass.one_pixel)
            return;
        if (maps_ && sun)
            maps_->record_light(pass, sun->light);
        bind_lighting(pass, view_, pipeline_);
        vkCmdDraw(pass.commands, 3, 1, 0, 0);
    }

private:
    const resident::View& view_;
    gpu::GraphicsPipeline pipeline_;
    std::optional<ShadowDraws> maps_; ///< Shadows::reused
};

} // namespace

Shadows sun_occlusion_pass(graph::FrameGraph& graph, const resident::View& view, const GBuffer& gbuffer,
                           Shadows shadows) {
    if (!shadows)
        return shadows;
    graph::Pass& pass = graph.pass("sun occlusion");
    pass.colour(gbuffer.albedo, graph::Load::keep)
        .sample(INPUT_DEPTH, gbuffer.surface.depth_source)
        .sample(INPUT_NORMAL, gbuffer.surface.normal);
    declare_shadows(pass, shadows);
    auto draws = std::make_shared<std::optional<SunOcclusion>>();
    pass.prepare([=, &view, surface = gbuffer.surface.format](const graph::PassInterface& interface) {
        draws->emplace(view, interface, surface, shadows);
    });
    pass.record([draws](const graph::PassContext& context) { (*draws)->record(context); });
    shadows.sun_stored = true;
    return shadows;
}

} // namespace prelight::passes
