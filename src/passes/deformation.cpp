#include "deformation.hpp"
#include <algorithm>
#include <gpu/barrier.hpp>
#include <gpu/compute_pipeline.hpp>
#include <shared/bindings.h>

namespace prelight::passes {

void deformation_pass(graph::FrameGraph& graph, const resident::View& view) {
    const resident::DeviceDeformation* deformation = view.scene().deformation();
    if (!deformation)
        return;
    const resident::Geometry& geometry = view.scene().geometry();
    const gpu::Buffer& previous =
        geometry.previous_positions.handle() ? geometry.previous_positions : geometry.positions; // which is not written
    graph::Pass& pass = graph.pass("deformation");
    pass.storage(INPUT_DEFORM_JOBS, graph.buffer("primitives to deform", deformation->jobs()), false)
        .storage(INPUT_DEFORM_GROUPS, graph.buffer("groups to deform", deformation->group_list()), false)
        .storage(INPUT_DEFORM_BASE, graph.buffer("vertices at rest", deformation->base()), false)
        .storage(INPUT_DEFORM_INFLUENCES, graph.buffer("vertex influences", deformation->influences()), false)
        .storage(INPUT_DEFORM_TARGETS, graph.buffer("morph targets", deformation->targets()), false)
        .storage(INPUT_DEFORM_STATE, graph.buffer("joints and weights", deformation->state()), false)
        .storage(INPUT_DEFORM_POSITIONS, graph.buffer("positions", geometry.positions), true)
        .storage(INPUT_DEFORM_PREVIOUS, graph.buffer("previous positions", previous), true)
        .storage(INPUT_DEFORM_ATTRIBUTES, graph.buffer("vertex attributes", geometry.attributes), true);
    auto pipeline = std::make_shared<gpu::ComputePipeline>();
    pass.prepare([=, &view](const graph::PassInterface& interface) {
        *pipeline = gpu::ComputePipeline(view.context(), {.name = "deformation",
                                                          .shader = "deform.comp",
                                                          .constants = {},
                                                          .sets = {view.layout(), interface.inputs},
                                                          .push_bytes = sizeof(uint32_t)});
    });
    pass.record([pipeline, deformation, &view, made = uint64_t(0)](const graph::PassContext& context) mutable {
        if (made == deformation->version())
            return;
        constexpr VkPipelineStageFlags2 all = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                        compute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
        // Vertices are read by all that draws, and nobody declares it.
        gpu::memory_barrier(context.commands, all, VK_ACCESS_2_NONE, compute, VK_ACCESS_2_SHADER_WRITE_BIT);
        pipeline->bind(context.commands);
        pipeline->bind_set(context.commands, SET_FRAME, view.set());
        pipeline->bind_set(context.commands, SET_INPUTS, context.inputs);
        const uint32_t groups = deformation->groups();
        pipeline->push(context.commands, std::as_bytes(std::span(&groups, 1)));
        vkCmdDispatch(context.commands, std::min<uint32_t>(groups, DEFORM_ROW), (groups + DEFORM_ROW - 1) / DEFORM_ROW,
                      1);
        gpu::memory_barrier(context.commands, compute, VK_ACCESS_2_SHADER_WRITE_BIT, all, VK_ACCESS_2_MEMORY_READ_BIT);
        if (!context.one_pixel)
            made = deformation->version();
    });
}

} // namespace prelight::passes
