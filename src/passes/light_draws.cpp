#include "light_draws.hpp"
#include <shared/bindings.h>

namespace prelight::passes {

LightDraws::LightDraws(const resident::Frame& frame, const graph::PassInterface& interface,
                       const LightingInputs& inputs)
    : frame_(frame), light_(lighting_pipeline(frame, interface, inputs, "light")) {
    light_.blend = gpu::Blend::add;
    if (inputs.model.ambient_as_light && inputs.target.variant != "+count") {
        gpu::GraphicsPipelineDesc desc = lighting_pipeline(frame, interface, inputs, "light_ambient");
        desc.name = "ambient light";
        desc.vertex = "light_fullscreen.vert";
        desc.depth = gpu::DepthTest::surface_only;
        desc.blend = gpu::Blend::add;
        ambient_ = gpu::GraphicsPipeline(frame.context(), desc);
        has_ambient_ = true;
    }
    gpu::GraphicsPipelineDesc desc = pipeline("full-screen lights", "light_fullscreen.vert");
    desc.depth = gpu::DepthTest::surface_only;
    desc.depth_clamp = true;
    fullscreen_ = gpu::GraphicsPipeline(frame.context(), desc);
}

gpu::GraphicsPipelineDesc LightDraws::pipeline(const char* name, const char* vertex) const {
    gpu::GraphicsPipelineDesc desc = light_;
    desc.name = name;
    desc.vertex = vertex;
    return desc;
}

void LightDraws::bind(const graph::PassContext& pass, const gpu::GraphicsPipeline& pipeline) const {
    pipeline.bind(pass.commands);
    pipeline.bind_set(pass.commands, SET_FRAME, frame_.set());
    pipeline.bind_set(pass.commands, SET_INPUTS, pass.inputs);
}

void LightDraws::record_fullscreen(const graph::PassContext& pass) const {
    if (has_ambient_) {
        bind(pass, ambient_);
        vkCmdDraw(pass.commands, 3, 1, 0, 0);
    }
    const size_t g = static_cast<size_t>(resident::LightGroup::fullscreen);
    if (lights().count[g] == 0)
        return;
    bind(pass, fullscreen_);
    vkCmdDraw(pass.commands, 3, lights().count[g], 0, lights().first[g]);
}

} // namespace prelight::passes
