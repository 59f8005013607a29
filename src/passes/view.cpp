#include "view.hpp"
#include "fullscreen.hpp"
#include "lighting.hpp"
#include "resolve.hpp"
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

graph::ImageId view_image(graph::FrameGraph& graph, const resident::View& view, const std::string& name) {
    return graph.image("view " + name, {VK_FORMAT_R8G8B8A8_UNORM, view.raster()});
}

} // namespace

graph::ImageId black_view_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name) {
    const graph::ImageId target = view_image(graph, view, name);
    graph.pass("view-" + name).colour(target, graph::Load::clear, {0, 0, 0, 1}).record([](const graph::PassContext&) {
    });
    return target;
}

graph::ImageId edges_view_pass(graph::FrameGraph& graph, const resident::View& view, const SampledSurfaces& surfaces) {
    if (surfaces.edges)
        return view_pass(graph, view, "edges", ViewKind::edges, surfaces.pixels, surfaces.edges->flags);
    return black_view_pass(graph, view, "edges");
}

graph::ImageId layers_view_pass(graph::FrameGraph& graph, const resident::View& view, const SurfaceBuffers& surface,
                                const std::optional<graph::ImageId>& layers) {
    if (!layers)
        return black_view_pass(graph, view, "layers");
    const graph::ImageId pixels = resolve_pass(graph, view, *layers);
    // Nothing of the surface is looked at, which may have several samples.
    return view_pass(graph, view, "layers", ViewKind::layers, {surface.format, pixels, pixels, pixels, pixels}, pixels);
}

graph::ImageId view_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name, ViewKind kind,
                         const SurfaceBuffers& surface, graph::ImageId buffer, uint32_t sample) {
    const graph::ImageId target = view_image(graph, view, name);
    graph::Pass& pass = graph.pass("view-" + name);
    const bool pair = is_light_pair(graph, buffer) || kind == ViewKind::edges; // unsigned integers
    pass.colour(target, graph::Load::discard)
        .sample(INPUT_DEPTH, surface.depth_source)
        .sample(INPUT_NORMAL, pair ? surface.normal : buffer);
    const bool stencil = kind == ViewKind::roughness && surface.format.roughness_in_stencil;
    if (stencil)
        pass.sample_stencil(INPUT_ROUGHNESS, surface.depth);
    else
        pass.sample(INPUT_ROUGHNESS, surface.roughness);
    if (pair)
        pass.sample(INPUT_MATERIAL, buffer);
    gpu::Constants constants = surface.format.constants();
    constants.emplace_back(CONSTANT_VIEW, static_cast<uint32_t>(kind));
    const uint32_t samples = graph.raster(buffer).samples;
    if (samples > 1)
        constants.insert(constants.end(), {{CONSTANT_SAMPLES, samples}, {CONSTANT_VIEW_SAMPLE, sample}});
    draw_fullscreen(pass, view,
                    {"view.frag", gpu::when(pair, gpu::Variant::light_pair) |
                                      gpu::when(stencil, gpu::Variant::stencil_roughness) |
                                      gpu::when(samples > 1, gpu::Variant::samples)},
                    constants);
    return target;
}

} // namespace prelight::passes
