#include "forward.hpp"
#include "lighting.hpp"
#include "resolve.hpp"
#include <algorithm>
#include <array>
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

SurfaceDraws::Desc base_desc(uint32_t output, gpu::DepthTest depth, const DecalBuffer& decals,
                             gpu::SampleShading sample_shading = {}) {
    return {.name = "forward base",
            .fragment = "forward_base.frag",
            .constants = {{CONSTANT_MATERIAL_OUTPUT, output}},
            .depth = depth,
            .keeps_alpha_mask = depth == gpu::DepthTest::write_nearer,
            .sample_shading = sample_shading,
            .decals = decal_use(decals)};
}

SurfaceDraws::Desc lights_desc(const resident::View& view, const ForwardInputs& inputs, StepKind kind) {
    SurfaceDraws::Desc desc = forward_desc("forward.frag", view, inputs, kind == StepKind::base_and_lights);
    desc.depth = inputs.lights_test;
    desc.keeps_alpha_mask = inputs.lights_test != gpu::DepthTest::equal; // holes let others through
    desc.blend = kind == StepKind::lights ? gpu::Blend::add : gpu::Blend::none;
    desc.push_bytes = sizeof(shared::ForwardBatch);
    return desc;
}

/// The pipelines of each kind of step, and the draws of one frame.
class ForwardDraws {
public:
    ForwardDraws(const resident::View& view, const graph::PassInterface& interface, const ForwardInputs& inputs)
        : view_(view), inputs_(inputs) {
        for (const StepKind kind : inputs.kinds)
            of(kind).emplace(view, interface,
                             kind == StepKind::base ? base_desc(MATERIAL_OUTPUT_SHADED, gpu::DepthTest::write_nearer,
                                                                inputs.decals, inputs.sample_shading)
                                                    : lights_desc(view, inputs, kind));
    }

    void record(const graph::PassContext& pass) {
        const ForwardPlan plan = inputs_.plan(view_.reach());
        SurfaceDraws::Bound bound;
        uint64_t drawn = 0;
        if (!plan.empty())
            of(plan[0].kind)->bind_geometry(pass);
        for (const ForwardStep& step : plan) {
            const auto batch = std::as_bytes(std::span(&step.batch, 1));
            drawn += of(step.kind)->draw(pass, bound, step.draw,
                                         step.kind == StepKind::base ? std::span<const std::byte>() : batch);
        }
        if (inputs_.draws)
            *inputs_.draws = drawn;
    }

private:
    std::optional<SurfaceDraws>& of(StepKind kind) { return draws_[static_cast<size_t>(kind)]; }
    const resident::View& view_;
    ForwardInputs inputs_;
    std::array<std::optional<SurfaceDraws>, 3> draws_;
};

} // namespace

SurfaceDraws::Desc forward_desc(const char* fragment, const resident::View& view, const ForwardInputs& inputs,
                                bool with_base) {
    SurfaceDraws::Desc desc{.name = "forward " + inputs.name,
                            .fragment = {fragment, shadow_variant(inputs.shadows)},
                            .constants = inputs.model.constants(),
                            .sample_shading = inputs.sample_shading,
                            .decals = decal_use(inputs.decals)};
    desc.constants.insert(desc.constants.end(),
                          {{CONSTANT_COUNT_PAIRS, inputs.count_pairs},
                           {CONSTANT_LIGHT_OUTPUT, inputs.counts_lights ? LIGHT_OUTPUT_COUNT : LIGHT_OUTPUT_LIGHT},
                           {CONSTANT_FORWARD_BASE, with_base},
                           {CONSTANT_SPECULAR_ANTIALIASING, inputs.model.specular_antialiasing}});
    add_light_constants(desc.constants, view);
    return desc;
}

SurfaceDraws::Desc summed_desc(const char* fragment, const resident::View& view, ForwardInputs inputs, bool with_base) {
    const bool sums = inputs.model.fresnel == FresnelModel::weighted && inputs.model.shading == Shading::ggx;
    if (sums)
        inputs.model.fresnel = FresnelModel::full;
    SurfaceDraws::Desc desc = forward_desc(fragment, view, inputs, with_base);
    desc.own_fragment = desc.fragment;
    if (sums)
        desc.fragment = {fragment, desc.fragment.variants | gpu::Variant::own_material, "metallic_roughness"};
    return desc;
}

std::shared_ptr<std::optional<SurfaceDraws>> declare_whole(graph::FrameGraph& graph, graph::Pass& pass,
                                                           const resident::View& view, const ForwardInputs& inputs,
                                                           SurfaceDraws::Desc desc) {
    desc.depth = gpu::DepthTest::equal; // exact: vertex_position() is invariant
    desc.keeps_alpha_mask = false;
    for (const auto& constant : display_constants(inputs.display, graph.desc(inputs.colour).format))
        desc.constants.push_back(constant);
    pass.depth_test(inputs.depth)
        .storage(INPUT_PAIR_COUNTERS, graph.buffer("pair counters", *inputs.pair_counters), inputs.count_pairs);
    declare_surfaces(graph, pass, view, desc.depth);
    declare_shadows(pass, inputs.shadows);
    declare_decals(pass, inputs.decals);
    auto draws = std::make_shared<std::optional<SurfaceDraws>>();
    pass.prepare([=, &view](const graph::PassInterface& interface) { draws->emplace(view, interface, desc); });
    return draws;
}

void forward_pass(graph::FrameGraph& graph, const resident::View& view, const ForwardInputs& inputs) {
    graph::Pass& pass = graph.pass(inputs.name);
    pass.colour(inputs.colour, inputs.load);
    const bool base = std::count(inputs.kinds.begin(), inputs.kinds.end(), StepKind::base) > 0;
    if (base)
        pass.depth_write(inputs.depth);
    else
        pass.depth_test(inputs.depth);
    if (std::count(inputs.kinds.begin(), inputs.kinds.end(), StepKind::lights) > 0)
        pass.blends();
    if (!base || inputs.kinds.size() > 1)
        pass.storage(INPUT_PAIR_COUNTERS, graph.buffer("pair counters", *inputs.pair_counters), inputs.count_pairs);
    declare_surfaces(graph, pass, view, base ? gpu::DepthTest::write_nearer : gpu::DepthTest::equal);
    declare_shadows(pass, inputs.shadows);
    declare_decals(pass, inputs.decals);
    auto draws = std::make_shared<std::optional<ForwardDraws>>();
    pass.prepare([=, &view](const graph::PassInterface& interface) { draws->emplace(view, interface, inputs); });
    pass.record([draws](const graph::PassContext& context) { (*draws)->record(context); });
}

graph::ImageId forward_albedo_pass(graph::FrameGraph& graph, const resident::View& view, graph::ImageId depth,
                                   const DecalBuffer& decals) {
    const graph::ImageId target = graph.image("albedo", {VK_FORMAT_R16G16B16A16_SFLOAT, graph.raster(depth)});
    graph::Pass& pass = graph.pass("albedo");
    pass.colour(target, graph::Load::clear).depth_test(depth);
    declare_decals(pass, decals);
    draw_surfaces(graph, pass, view, base_desc(MATERIAL_OUTPUT_ALBEDO, gpu::DepthTest::equal, decals));
    return resolve_pass(graph, view, target);
}

} // namespace prelight::passes
