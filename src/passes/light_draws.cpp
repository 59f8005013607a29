#include "light_draws.hpp"
#include <shared/bindings.h>

namespace prelight::passes {

void bind_lighting(const graph::PassContext& pass, const resident::View& view, const gpu::GraphicsPipeline& pipeline) {
    pipeline.bind(pass.commands);
    pipeline.bind_set(pass.commands, SET_FRAME, view.set());
    pipeline.bind_set(pass.commands, SET_INPUTS, pass.inputs);
}

bool AmbientDraw::needed(const LightingInputs& inputs) {
    return inputs.model.ambient_blended() && !inputs.target.counts();
}

gpu::ShaderKey lit_vertices(const LightingInputs& inputs) {
    return inputs.edges ? "light_samples.vert" : "light_fullscreen.vert";
}

void draw_lit(const graph::PassContext& pass, const std::optional<SampleEdges>& edges) {
    vkCmdDraw(pass.commands, edges ? 6 : 3, edges && !pass.one_pixel ? edges->tile_count : 1, 0, 0);
}

AmbientDraw::AmbientDraw(const resident::View& view, const graph::PassInterface& interface,
                         const LightingInputs& inputs)
    : view_(view), edges_(inputs.edges) {
    if (!needed(inputs))
        return;
    gpu::GraphicsPipelineDesc desc = lighting_pipeline(view, interface, inputs, "light_ambient.frag");
    desc.fragment = {"light_ambient.frag", inputs.target.variant}; // looks at no surface
    desc.name = "ambient light";
    desc.vertex = lit_vertices(inputs);
    desc.depth = edges_ ? gpu::DepthTest::none : gpu::DepthTest::surface_only;
    desc.blend = gpu::Blend::add;
    pipeline_.emplace(view.context(), desc);
}

void AmbientDraw::record(const graph::PassContext& pass) const {
    if (!pipeline_)
        return;
    bind_lighting(pass, view_, *pipeline_);
    draw_lit(pass, edges_);
}

LightDraws::LightDraws(const resident::View& view, const graph::PassInterface& interface, const LightingInputs& inputs)
    : view_(view), light_(lighting_pipeline(view, interface, inputs, "light.frag")), ambient_(view, interface, inputs) {
    light_.blend = gpu::Blend::add;
    gpu::GraphicsPipelineDesc desc = pipeline("full-screen lights", "light_fullscreen.vert");
    desc.depth = gpu::DepthTest::surface_only;
    desc.depth_clamp = true;
    fullscreen_ = gpu::GraphicsPipeline(view.context(), desc);
    if (inputs.shadows.reused && !inputs.target.counts())
        maps_ = std::make_unique<ShadowDraws>(view, interface.inputs, inputs.shadows);
    sun_stored_ = inputs.shadows.sun_stored;
}

gpu::GraphicsPipelineDesc LightDraws::pipeline(const char* name, const char* vertex) const {
    gpu::GraphicsPipelineDesc desc = light_;
    desc.name = name;
    desc.vertex = vertex;
    return desc;
}

void LightDraws::record_fullscreen(const graph::PassContext& pass) const {
    if (maps_)
        maps_->begin(pass);
    ambient_.record(pass);
    const size_t g = static_cast<size_t>(resident::LightGroup::fullscreen);
    each(pass, lights().first[g], lights().count[g], [&](uint32_t first, uint32_t count) {
        bind(pass, fullscreen_);
        vkCmdDraw(pass.commands, 3, count, 0, first);
    });
}

} // namespace prelight::passes
