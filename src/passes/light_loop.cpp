#include "light_loop.hpp"
#include "light_draws.hpp"
#include <shared/bindings.h>
#include <shared/light_loop.h>

namespace prelight::passes {

void light_loop_pass(graph::FrameGraph& graph, const resident::Frame& frame, const std::string& name,
                     const LightingInputs& inputs) {
    graph::Pass& pass = graph.pass(name);
    declare_lighting(graph, pass, inputs);
    pass.depth_test(inputs.surface.depth);
    auto pipeline = std::make_shared<gpu::GraphicsPipeline>();
    pass.prepare([=, &frame](const graph::PassInterface& interface) {
        gpu::GraphicsPipelineDesc desc = lighting_pipeline(frame, interface, inputs, "light_loop");
        desc.name = "all lights";
        desc.vertex = "light_fullscreen.vert";
        desc.depth = gpu::DepthTest::surface_only;
        desc.push_bytes = sizeof(shared::LightLoop);
        *pipeline = gpu::GraphicsPipeline(frame.context(), desc);
    });
    pass.record([=, &frame](const graph::PassContext& context) {
        bind_lighting(context, frame, *pipeline);
        const shared::LightLoop loop{static_cast<uint32_t>(frame.lights().order.size()), inputs.model.ambient_blended()};
        pipeline->push(context.commands, std::as_bytes(std::span(&loop, 1)));
        vkCmdDraw(context.commands, 3, 1, 0, 0);
    });
}

} // namespace prelight::passes
