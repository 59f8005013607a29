#include "shadow_extremes.hpp"
#include "shadow_draws.hpp"
#include <gpu/pipeline.hpp>
#include <shared/bindings.h>

namespace prelight::passes {

bool has_shadow_extremes(const resident::ShadowOptions& options) {
    return options.filter == resident::ShadowFilter::pcf && !options.reuse;
}

void shadow_extremes_pass(graph::FrameGraph& graph, const resident::View& view, const Shadows& shadows) {
    graph::Pass& pass = graph.pass("shadow extremes");
    pass.colour(shadows.extremes, graph::Load::keep);
    pass.sample(INPUT_SHADOW_ATLAS, shadows.atlas).sample(INPUT_SHADOW_TRANSMITTANCE, shadows.transmittance);
    auto pipeline = std::make_shared<gpu::GraphicsPipeline>();
    pass.prepare([=, &view](const graph::PassInterface& interface) {
        gpu::GraphicsPipelineDesc desc;
        desc.name = "shadow extremes";
        desc.vertex = "fullscreen.vert";
        desc.fragment = "shadow_extremes.frag";
        add_shadow_constants(desc.constants, view);
        desc.attachments = interface.attachments;
        desc.sets = {view.layout(), interface.inputs};
        desc.push_bytes = sizeof(glm::uvec4);
        desc.push_stage = VK_SHADER_STAGE_FRAGMENT_BIT;
        *pipeline = gpu::GraphicsPipeline(view.context(), desc);
    });
    pass.record([=](const graph::PassContext& context) {
        pipeline->bind(context.commands);
        pipeline->bind_set(context.commands, SET_INPUTS, context.inputs);
        const auto draw = [&](const resident::ShadowTilePlace& place) {
            const glm::uvec4 tile(place.corner, place.side, 0);
            pipeline->push(context.commands, std::as_bytes(std::span(&tile, 1)));
            vkCmdDraw(context.commands, 3, 1, 0, 0);
        };
        if (context.one_pixel)
            return draw({.corner = {0, 0}, .side = 1});
        for (const resident::ShadowMap& map : shadows.held->drawn) {
            const glm::uvec2 cell = map.place.corner / uint32_t(SHADOW_CELL);
            const uint32_t cells = map.place.side / SHADOW_CELL;
            if (cells == 0)
                continue; // lookups do not ask
            const VkViewport viewport{float(cell.x), float(cell.y), float(cells), float(cells), 0, 1};
            const VkRect2D area{{int32_t(cell.x), int32_t(cell.y)}, {cells, cells}};
            vkCmdSetViewport(context.commands, 0, 1, &viewport);
            vkCmdSetScissor(context.commands, 0, 1, &area);
            draw(map.place);
        }
    });
}

} // namespace prelight::passes
