#include "light_list_shading.hpp"
#include "light_draws.hpp"
#include "light_list_compute.hpp"
#include "light_rounds.hpp"
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

/// One full-screen triangle over all surfaces; ambient light, if it is one, is added by a second.
class ListDraws {
public:
    ListDraws(const resident::View& view, const graph::PassInterface& interface, const LightingInputs& inputs,
              const LightListRound& round)
        : view_(view), constants_(round.constants), edges_(inputs.edges), ambient_(view, interface, inputs) {
        gpu::GraphicsPipelineDesc desc = lighting_pipeline(view, interface, inputs, "light_list.frag");
        desc.name = "light lists";
        desc.vertex = lit_vertices(inputs);
        desc.depth = inputs.edges ? gpu::DepthTest::none : gpu::DepthTest::surface_only;
        desc.blend = inputs.target.load == graph::Load::keep ? gpu::Blend::add : gpu::Blend::none;
        desc.push_bytes = sizeof(shared::LightListConstants);
        lights_ = gpu::GraphicsPipeline(view.context(), desc);
    }

    void record(const graph::PassContext& pass) const {
        if (is_idle(*constants_, pass))
            return;
        bind_lighting(pass, view_, lights_);
        lights_.push(pass.commands, std::as_bytes(std::span(constants_.get(), 1)));
        draw_lit(pass, edges_);
        ambient_.record(pass);
    }

private:
    const resident::View& view_;
    std::shared_ptr<const shared::LightListConstants> constants_;
    std::optional<SampleEdges> edges_;
    AmbientDraw ambient_;
    gpu::GraphicsPipeline lights_;
};

/// The lights of one round; each but the first adds to the target.
void light_list_round(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                      LightingInputs inputs, const LightListRound& round, bool adds) {
    const LightLists& lists = *inputs.lists;
    if (adds) {
        inputs.target.added = lists.walk == LightWalk::compute && inputs.target.load != graph::Load::keep;
        inputs.target.load = graph::Load::keep;
        inputs.model.ambient_as_light = false; // the first has added it
    }
    if (lists.walk == LightWalk::compute)
        return light_list_compute_pass(graph, view, name, inputs, round);
    graph::Pass& pass = graph.pass(name + round.ending);
    declare_lighting(graph, pass, inputs);
    declare_light_lists(pass, round);
    if (!inputs.edges)
        pass.depth_test(inputs.surface.depth);
    if (inputs.target.load == graph::Load::keep || AmbientDraw::needed(inputs))
        pass.blends();
    auto draws = std::make_shared<std::optional<ListDraws>>();
    pass.prepare([=, &view](const graph::PassInterface& interface) { draws->emplace(view, interface, inputs, round); });
    pass.record([draws](const graph::PassContext& context) { (*draws)->record(context); });
}

} // namespace

void light_list_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                     const LightingInputs& inputs) {
    const LightLists& lists = *inputs.lists;
    if (lists.walk == LightWalk::fragment && inputs.model.specular == SpecularWay::luv && inputs.target.packed())
        expect_one_round(view, light_rounds(view, lists.walk),
                         "specular=luv in a draw (list-shading=compute has no such limit)");
    for (size_t round = 0; round < lists.rounds.size(); ++round)
        light_list_round(graph, view, name, inputs, lists.rounds[round], round > 0);
}

} // namespace prelight::passes
