#include "background.hpp"
#include <shared/bindings.h>

namespace prelight::passes {

void background_pass(graph::FrameGraph& graph, const resident::Frame& frame, graph::ImageId target,
                     graph::ImageId depth, Display display) {
    if (!frame.environment() || !frame.environment()->background)
        return;
    graph::Pass& pass = graph.pass("background");
    pass.colour(target, graph::Load::keep).depth_test(depth);
    const gpu::Constants constants = display_constants(display, graph.desc(target).format);
    auto pipeline = std::make_shared<gpu::GraphicsPipeline>();
    pass.prepare([=, &frame](const graph::PassInterface& interface) {
        gpu::GraphicsPipelineDesc desc;
        desc.name = "background";
        desc.vertex = "fullscreen.vert"; // at depth 0, which is what depth is cleared to
        desc.fragment = "background.frag";
        desc.constants = constants;
        desc.colour_formats = interface.colour_formats;
        desc.depth_format = interface.depth_format;
        desc.depth = gpu::DepthTest::equal;
        desc.sets = {frame.layout(), interface.inputs, frame.materials().layout};
        *pipeline = gpu::GraphicsPipeline(frame.context(), desc);
    });
    pass.record([=, &frame](const graph::PassContext& context) {
        pipeline->bind(context.commands);
        pipeline->bind_set(context.commands, SET_FRAME, frame.set());
        pipeline->bind_set(context.commands, SET_MATERIAL, frame.materials().sets[0]); // each holds the environment
        vkCmdDraw(context.commands, 3, 1, 0, 0);
    });
}

} // namespace prelight::passes
