#include "light_list_shading.hpp"
#include "light_draws.hpp"
#include "light_list_compute.hpp"
#include "light_lists.hpp"
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

/// One full-screen triangle over all surfaces; ambient light, if it is one, is added by a second.
class ListDraws {
public:
    ListDraws(const resident::Frame& frame, const graph::PassInterface& interface, const LightingInputs& inputs,
              const LightLists& lists)
        : frame_(frame), constants_(lists.constants), ambient_(frame, interface, inputs) {
        gpu::GraphicsPipelineDesc desc = lighting_pipeline(frame, interface, inputs, "light_list");
        desc.name = "light lists";
        desc.vertex = "light_fullscreen.vert";
        desc.constants = list_lighting_constants(frame, inputs, lists);
        desc.depth = gpu::DepthTest::surface_only;
        desc.blend = inputs.target.load == graph::Load::keep ? gpu::Blend::add : gpu::Blend::none;
        desc.push_bytes = sizeof(shared::LightListConstants);
        lights_ = gpu::GraphicsPipeline(frame.context(), desc);
    }

    void record(const graph::PassContext& pass) const {
        bind_lighting(pass, frame_, lights_);
        lights_.push(pass.commands, std::as_bytes(std::span(constants_.get(), 1)));
        vkCmdDraw(pass.commands, 3, 1, 0, 0);
        ambient_.record(pass);
    }

private:
    const resident::Frame& frame_;
    std::shared_ptr<const shared::LightListConstants> constants_;
    AmbientDraw ambient_;
    gpu::GraphicsPipeline lights_;
};

} // namespace

void light_list_pass(graph::FrameGraph& graph, const resident::Frame& frame, const std::string& name,
                     const LightingInputs& inputs) {
    const ListShading shading = list_shading_of(graph, frame, inputs);
    const LightLists lists =
        light_list_passes(graph, frame, name,
                          {.surface = &inputs.surface,
                           .tile_size = inputs.tile_size,
                           .sliced = frame.culling() == resident::LightCulling::clusters,
                           // Only lists of tiles' own can be trimmed.
                           .masked = shading == ListShading::compute && inputs.list_contents == ListContents::built,
                           .ambient = inputs.model.ambient_as_light,
                           .first_room = inputs.list_room});
    if (inputs.list_contents != ListContents::built)
        trim_light_lists(graph, frame, name, inputs, lists);
    if (shading != ListShading::fragment)
        return light_list_compute_pass(graph, frame, name, inputs, lists);
    graph::Pass& pass = graph.pass(name);
    declare_lighting(graph, pass, inputs);
    declare_light_lists(pass, lists);
    pass.depth_test(inputs.surface.depth);
    if (inputs.target.load == graph::Load::keep || AmbientDraw::needed(inputs))
        pass.blends();
    auto draws = std::make_shared<std::optional<ListDraws>>();
    pass.prepare([=, &frame](const graph::PassInterface& interface) { draws->emplace(frame, interface, inputs, lists); });
    pass.record([draws](const graph::PassContext& context) { (*draws)->record(context); });
}

} // namespace prelight::passes
