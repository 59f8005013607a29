#include "light_loop.hpp"
#include "light_draws.hpp"
#include "light_rounds.hpp"
#include <array>
#include <shared/bindings.h>
#include <shared/light_loop.h>

namespace prelight::passes {

void light_loop_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                     const LightingInputs& inputs) {
    graph::Pass& pass = graph.pass(name);
    declare_lighting(graph, pass, inputs);
    if (!inputs.edges)
        pass.depth_test(inputs.surface.depth);
    const LightRounds rounds = light_rounds(view, LightWalk::fragment);
    const bool adds = rounds.count > 1;
    if (inputs.model.specular == SpecularWay::luv && inputs.target.packed())
        expect_one_round(view, rounds,
                         "specular=luv in a draw (light-culling=tiles with list-shading=compute has no such limit)");
    if (adds)
        pass.blends();
    auto pipelines =
        std::make_shared<std::array<gpu::GraphicsPipeline, 2>>(); // the first round replaces, the others add
    pass.prepare([=, &view](const graph::PassInterface& interface) {
        gpu::GraphicsPipelineDesc desc = lighting_pipeline(view, interface, inputs, "light_loop.frag");
        desc.name = "all lights";
        desc.vertex = lit_vertices(inputs);
        desc.depth = inputs.edges ? gpu::DepthTest::none : gpu::DepthTest::surface_only;
        desc.push_bytes = sizeof(shared::LightLoop);
        (*pipelines)[0] = gpu::GraphicsPipeline(view.context(), desc);
        desc.blend = gpu::Blend::add;
        if (adds)
            (*pipelines)[1] = gpu::GraphicsPipeline(view.context(), desc);
    });
    pass.record([=, &view](const graph::PassContext& context) {
        for (uint32_t round = 0; round < rounds.count; ++round) {
            const RoundLights lights = lights_of_round(view, rounds, round);
            const uint32_t end = lights.first + lights.everywhere + lights.listed;
            if (round > 0 && lights.first == end && !context.one_pixel)
                break;
            const gpu::GraphicsPipeline& pipeline = (*pipelines)[round > 0];
            bind_lighting(context, view, pipeline);
            const shared::LightLoop loop{lights.first, end, round == 0 && inputs.model.ambient_blended()};
            pipeline.push(context.commands, std::as_bytes(std::span(&loop, 1)));
            draw_lit(context, inputs.edges);
        }
    });
}

} // namespace prelight::passes
