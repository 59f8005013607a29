#include "tonemap.hpp"
#include "fullscreen.hpp"
#include <shared/bindings.h>

namespace prelight::passes {

graph::ImageId picture_image(graph::FrameGraph& graph, const resident::View& view, const gpu::Raster& raster,
                             Display display, bool wide) {
    // lavapipe encodes with an error of up to 0.66 codes, where the shader is right to 0.003.
    const bool target_encodes =
        !view.context().is_software() &&
        view.context().supports(VK_FORMAT_R8G8B8A8_SRGB, VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT);
    return display
               ? graph.image("final", {target_encodes ? VK_FORMAT_R8G8B8A8_SRGB : VK_FORMAT_R8G8B8A8_UNORM, raster})
               : graph.image("linear", {wide ? VK_FORMAT_R32G32B32A32_SFLOAT : VK_FORMAT_R16G16B16A16_SFLOAT, raster});
}

gpu::Constants display_constants(Display display, VkFormat target) {
    return {{CONSTANT_TONEMAP, display ? static_cast<uint32_t>(*display) : TONEMAP_LINEAR},
            {CONSTANT_TARGET_ENCODES, target == VK_FORMAT_R8G8B8A8_SRGB}};
}

graph::ImageId tonemap_pass(graph::FrameGraph& graph, const resident::View& view, graph::ImageId colour,
                            Tonemap curve) {
    const graph::ImageId target = picture_image(graph, view, view.raster(), curve);
    graph::Pass& pass = graph.pass("tonemap");
    pass.colour(target, graph::Load::discard).sample(INPUT_COLOUR, colour);
    draw_fullscreen(pass, view, "tonemap.frag", display_constants(curve, graph.desc(target).format));
    return target;
}

} // namespace prelight::passes
