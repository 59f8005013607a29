#include "half_samples.hpp"
#include "blended.hpp"
#include <shared/half_samples.h>

namespace prelight::passes {
namespace {

/// Whether they cover enough is asked at each sample, as alpha masks are. Where surfaces coincide the world's first one
/// is drawn last, and stays.
void draw_in_half(graph::Pass& pass, const resident::View& view, SurfaceDraws::Desc desc, uint64_t* drawn = nullptr) {
    desc.name = pass.name();
    desc.constants.emplace_back(CONSTANT_HALF_SAMPLES, true);
    desc.keeps_alpha_mask = false; // they have none
    desc.sample_shading = gpu::SampleShading::sample;
    desc.sample_mask = HALF_SAMPLES_BLENDED;
    desc.draws = resident::DrawClass::blended;
    draw_blended(pass, view, desc, BlendedOrder::layer, drawn);
}

} // namespace

void half_surfaces_pass(graph::FrameGraph& graph, const resident::View& view, const SurfaceBuffers& surface) {
    graph::Pass& pass = graph.pass("blended surfaces");
    pass.depth_write(surface.depth, graph::Load::keep).colour(surface.normal, graph::Load::keep);
    const bool apart = surface.roughness != surface.normal;
    if (apart)
        pass.colour(surface.roughness, graph::Load::keep);
    draw_in_half(pass, view,
                 {.name = {},
                  .fragment = {"depth_normal.frag", gpu::when(apart, gpu::Variant::roughness_target)},
                  .constants = surface.format.constants(),
                  .vertex = gpu::Variant::no_world | gpu::Variant::no_textures});
}

void half_geometry_pass(graph::FrameGraph& graph, const resident::View& view, const GBuffer& gbuffer) {
    graph::Pass& pass = graph.pass("blended surfaces");
    pass.depth_write(gbuffer.surface.depth, graph::Load::keep);
    for (const graph::ImageId target : gbuffer.targets())
        pass.colour(target, graph::Load::keep);
    draw_in_half(pass, view,
                 {.name = {},
                  .fragment = gbuffer.fragment(),
                  .constants = gbuffer.surface.format.constants(),
                  .vertex = gpu::Variant::motion});
}

void half_coverage_pass(graph::FrameGraph& graph, const resident::View& view, const GBuffer& gbuffer,
                        graph::ImageId picture, uint64_t* drawn) {
    graph::Pass& pass = graph.pass("blended coverage");
    pass.colour(picture, graph::Load::keep).depth_test(gbuffer.surface.depth);
    draw_in_half(pass, view,
                 {.name = {},
                  .fragment = "blended_coverage.frag",
                  .constants = {},
                  .depth = gpu::DepthTest::equal,
                  .blend = gpu::Blend::alpha_only},
                 drawn);
}

} // namespace prelight::passes
