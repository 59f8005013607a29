#include "weighted_blended.hpp"
#include "blended.hpp"
#include "fullscreen.hpp"
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

/// Σ weight · colour with Π (1 − α) as its alpha, and Σ weight. This way of putting three sums into two images has both
/// blend alike, which every device can; the paper's has them blend each in its own way.
struct Sums {
    graph::ImageId colour, weight;
};

Sums sums_pass(graph::FrameGraph& graph, const resident::View& view, const ForwardInputs& inputs,
               const LightLists& lists, const KBuffer* nearest) {
    const gpu::Raster raster = graph.raster(inputs.colour);
    const Sums sums{graph.image("blended sum", {VK_FORMAT_R16G16B16A16_SFLOAT, raster}),
                    graph.image("blended weight", {VK_FORMAT_R16_SFLOAT, raster})};
    graph::Pass& pass = graph.pass(inputs.name);
    pass.colour(sums.colour, graph::Load::clear, {0, 0, 0, 1}).colour(sums.weight, graph::Load::clear);
    const auto constants = declare_blended(graph, pass, inputs, &lists);
    SurfaceDraws::Desc desc = blended_desc(view, inputs, true, false);
    desc.blend = gpu::Blend::add_and_cover;
    for (gpu::ShaderKey* shader : {&desc.fragment, &desc.own_fragment})
        shader->variants |= gpu::Variant::weighted;
    if (nearest) {
        nearest->declare(pass);
        for (gpu::ShaderKey* shader : {&desc.fragment, &desc.own_fragment})
            shader->variants |= gpu::Variant::beyond_k_buffer;
        for (const auto& constant : nearest->constants())
            desc.constants.push_back(constant);
        desc.sample_shading = gpu::SampleShading::sample;
    }
    // Not back to front, but what shares a pipeline and a material one after another.
    draw_blended(pass, view, desc, BlendedOrder::cheapest, inputs.draws, constants);
    return sums;
}

} // namespace

void weighted_blended_pass(graph::FrameGraph& graph, const resident::View& view, const ForwardInputs& inputs,
                           const LightLists& lists, const KBuffer* nearest) {
    const Sums sums = sums_pass(graph, view, inputs, lists, nearest);
    graph::Pass& pass = graph.pass(inputs.name + " compose");
    pass.colour(inputs.colour, graph::Load::keep)
        .blends()
        .sample(INPUT_BLENDED_SUM, sums.colour)
        .sample(INPUT_BLENDED_WEIGHT, sums.weight);
    const bool samples = graph.raster(inputs.colour).samples > 1;
    draw_fullscreen(pass, view, {"blended_compose.frag", gpu::when(samples, gpu::Variant::samples)}, {},
                    gpu::Blend::by_alpha);
}

} // namespace prelight::passes
