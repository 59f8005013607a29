#include "background.hpp"
#include <shared/bindings.h>

namespace prelight::passes {

void background_pass(graph::FrameGraph& graph, const resident::View& view, graph::ImageId target, graph::ImageId depth,
                     Display display) {
    if (!view.scene().environment() || !view.scene().environment()->background)
        return;
    graph::Pass& pass = graph.pass("background");
    pass.colour(target, graph::Load::keep).depth_test(depth);
    const gpu::Constants constants = display_constants(display, graph.desc(target).format);
    auto pipeline = std::make_shared<gpu::GraphicsPipeline>();
    pass.prepare([=, &view](const graph::PassInterface& interface) {
        gpu::GraphicsPipelineDesc desc;
        desc.name = "background";
        desc.vertex = "fullscreen.vert"; // at depth 0, which is what depth is cleared to
        desc.fragment = "background.frag";
        desc.constants = constants;
        desc.attachments = interface.attachments;
        desc.depth = gpu::DepthTest::equal;
        desc.sets = {view.layout(), interface.inputs, view.scene().materials().layout};
        *pipeline = gpu::GraphicsPipeline(view.context(), desc);
    });
    pass.record([=, &view](const graph::PassContext& context) {
        pipeline->bind(context.commands);
        pipeline->bind_set(context.commands, SET_FRAME, view.set());
        pipeline->bind_set(context.commands, SET_INPUTS, context.inputs);
        pipeline->bind_set(context.commands, SET_MATERIAL,
                           view.scene().materials().sets[0]); // each holds the environment
        vkCmdDraw(context.commands, 3, 1, 0, 0);
    });
}

} // namespace prelight::passes
