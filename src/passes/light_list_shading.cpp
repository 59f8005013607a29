#include "light_list_shading.hpp"
#include "light_lists.hpp"
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

/// One full-screen triangle over all surfaces; ambient light, if it is one, is added by a second.
class ListDraws {
public:
    ListDraws(const resident::Frame& frame, const graph::PassInterface& interface, const LightingInputs& inputs,
              const LightLists& lists)
        : frame_(frame), constants_(lists.constants) {
        gpu::GraphicsPipelineDesc desc = lighting_pipeline(frame, interface, inputs, "light_list");
        desc.name = "light lists";
        desc.vertex = "light_fullscreen.vert";
        const gpu::Constants own = light_list_constants(lists);
        desc.constants.insert(desc.constants.end(), own.begin(), own.end());
        desc.depth = gpu::DepthTest::surface_only;
        desc.blend = inputs.target.load == graph::Load::keep ? gpu::Blend::add : gpu::Blend::none;
        desc.push_bytes = sizeof(shared::LightListConstants);
        lights_ = gpu::GraphicsPipeline(frame.context(), desc);
        if (inputs.model.ambient_blended() && inputs.target.variant != "+count") {
            desc = lighting_pipeline(frame, interface, inputs, "light_ambient");
            desc.name = "ambient light";
            desc.vertex = "light_fullscreen.vert";
            desc.depth = gpu::DepthTest::surface_only;
            desc.blend = gpu::Blend::add;
            ambient_ = gpu::GraphicsPipeline(frame.context(), desc);
            has_ambient_ = true;
        }
    }

    void record(const graph::PassContext& pass) const {
        bind(pass, lights_);
        lights_.push(pass.commands, std::as_bytes(std::span(constants_.get(), 1)));
        vkCmdDraw(pass.commands, 3, 1, 0, 0);
        if (has_ambient_) {
            bind(pass, ambient_);
            vkCmdDraw(pass.commands, 3, 1, 0, 0);
        }
    }

private:
    void bind(const graph::PassContext& pass, const gpu::GraphicsPipeline& pipeline) const {
        pipeline.bind(pass.commands);
        pipeline.bind_set(pass.commands, SET_FRAME, frame_.set());
        pipeline.bind_set(pass.commands, SET_INPUTS, pass.inputs);
    }
    const resident::Frame& frame_;
    std::shared_ptr<const shared::LightListConstants> constants_;
    gpu::GraphicsPipeline lights_, ambient_;
    bool has_ambient_ = false;
};

} // namespace

void light_list_pass(graph::FrameGraph& graph, const resident::Frame& frame, const std::string& name,
                     const LightingInputs& inputs) {
    const LightLists lists =
        light_list_passes(graph, frame, name,
                          {.surface = &inputs.surface,
                           .tile_size = inputs.tile_size,
                           .sliced = frame.culling() == resident::LightCulling::clusters,
                           .first_room = inputs.list_room});
    graph::Pass& pass = graph.pass(name);
    declare_lighting(graph, pass, inputs);
    declare_light_lists(pass, lists);
    pass.depth_test(inputs.surface.depth);
    if (inputs.target.load == graph::Load::keep || inputs.model.ambient_blended())
        pass.blends();
    auto draws = std::make_shared<std::optional<ListDraws>>();
    pass.prepare([=, &frame](const graph::PassInterface& interface) { draws->emplace(frame, interface, inputs, lists); });
    pass.record([draws](const graph::PassContext& context) { (*draws)->record(context); });
}

} // namespace prelight::passes
