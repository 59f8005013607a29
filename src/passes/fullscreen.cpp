#include "fullscreen.hpp"
#include <shared/bindings.h>

namespace prelight::passes {

void draw_fullscreen(graph::Pass& pass, const resident::View& view, const gpu::ShaderKey& fragment,
                     const gpu::Constants& constants, gpu::Blend blend, gpu::DepthTest depth) {
    auto pipeline = std::make_shared<gpu::GraphicsPipeline>();
    pass.prepare([=, &view](const graph::PassInterface& interface) {
        gpu::GraphicsPipelineDesc desc;
        desc.name = fragment.text();
        desc.vertex = "fullscreen.vert";
        desc.fragment = fragment;
        desc.constants = constants;
        desc.blend = blend;
        desc.depth = depth;
        desc.attachments = interface.attachments;
        desc.sets = {view.layout(), interface.inputs};
        *pipeline = gpu::GraphicsPipeline(view.context(), desc);
    });
    pass.record([=, &view](const graph::PassContext& context) {
        pipeline->bind(context.commands);
        pipeline->bind_set(context.commands, SET_FRAME, view.set());
        pipeline->bind_set(context.commands, SET_INPUTS, context.inputs);
        vkCmdDraw(context.commands, 3, 1, 0, 0);
    });
}

} // namespace prelight::passes
