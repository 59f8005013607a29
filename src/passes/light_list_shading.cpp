#include "light_list_shading.hpp"
#include "light_draws.hpp"
#include "light_list_compute.hpp"
#include "light_lists.hpp"
#include "light_rounds.hpp"
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
        if (is_idle(*constants_, pass))
            return;
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

/// The lights of one round; each but the first adds to the target.
void light_list_round(graph::FrameGraph& graph, const resident::Frame& frame, const std::string& name,
                      LightingInputs inputs, ListShading shading, const LightRounds& rounds, uint32_t round) {
    if (round > 0) {
        inputs.target.added = shading == ListShading::compute && inputs.target.load != graph::Load::keep;
        inputs.target.load = graph::Load::keep;
        inputs.model.ambient_as_light = false; // the first has added it
    }
    const bool everywhere = inputs.model.ambient_as_light || (round == 0 && rounds.count > 1);
    const LightLists lists =
        light_list_passes(graph, frame, name,
                          {.surface = &inputs.surface,
                           .tile_size = inputs.tile_size,
                           .sliced = frame.culling() == resident::LightCulling::clusters,
                           // Only lists of tiles' own can be trimmed.
                           .masked = shading == ListShading::compute && inputs.list_contents == ListContents::built,
                           .ambient = everywhere,
                           .first_room = inputs.list_room,
                           .rounds = &rounds,
                           .round = round});
    if (inputs.list_contents != ListContents::built)
        trim_light_lists(graph, frame, name, inputs, lists, round_name(round));
    if (shading != ListShading::fragment)
        return light_list_compute_pass(graph, frame, name, inputs, lists, everywhere, round_name(round));
    graph::Pass& pass = graph.pass(name + round_name(round));
    declare_lighting(graph, pass, inputs);
    declare_light_lists(pass, lists);
    pass.depth_test(inputs.surface.depth);
    if (inputs.target.load == graph::Load::keep || AmbientDraw::needed(inputs))
        pass.blends();
    auto draws = std::make_shared<std::optional<ListDraws>>();
    pass.prepare(
        [=, &frame](const graph::PassInterface& interface) { draws->emplace(frame, interface, inputs, lists); });
    pass.record([draws](const graph::PassContext& context) { (*draws)->record(context); });
}

} // namespace

void light_list_pass(graph::FrameGraph& graph, const resident::Frame& frame, const std::string& name,
                     const LightingInputs& inputs) {
    const ListShading shading = list_shading_of(graph, frame, inputs);
    const LightWalk walk = shading == ListShading::compute ? LightWalk::compute : LightWalk::fragment;
    const LightRounds rounds = light_rounds(frame, walk, inputs.target.variant == "+count");
    if (walk == LightWalk::fragment && inputs.model.specular == SpecularWay::luv && inputs.target.variant == "+packed")
        expect_one_round(frame, rounds, "specular=luv in a draw (list-shading=compute has no such limit)");
    for (uint32_t round = 0; round < rounds.count; ++round)
        light_list_round(graph, frame, name, inputs, shading, rounds, round);
}

} // namespace prelight::passes
