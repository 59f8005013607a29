// Transmission as glTF's viewers show it: a surface reads what is behind it from the opaque picture, blurred by
// roughness.
#include "transmission.hpp"
#include "behind.hpp"
#include "depth_normal.hpp"
#include "fullscreen.hpp"
#include "resolve.hpp"
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

/// Depth of opaque and transmissive surfaces, in an image of its own: others look at that of opaque ones after this.
graph::ImageId depth_passes(graph::FrameGraph& graph, const resident::View& view, graph::ImageId opaque) {
    const gpu::Raster raster = graph.raster(opaque);
    const graph::ImageId depth = make_depth(graph, raster, false);
    graph::Pass& copy = graph.pass("transmission depth");
    copy.depth_write(depth).sample(INPUT_DEPTH, opaque);
    draw_fullscreen(copy, view, {"depth_copy.frag", gpu::when(raster.samples > 1, gpu::Variant::samples)}, {},
                    gpu::Blend::none, gpu::DepthTest::overwrite);

    graph::Pass& pass = graph.pass("transmission surfaces");
    pass.depth_write(depth, graph::Load::keep);
    auto draws = std::make_shared<std::optional<SurfaceDraws>>();
    pass.prepare([=, &view](const graph::PassInterface& interface) {
        draws->emplace(view, interface,
                       SurfaceDraws::Desc{.name = "transmission depth",
                                          .fragment = "depth_mask.frag",
                                          .constants = {},
                                          .depth_only = true,
                                          .draws = resident::DrawClass::transmissive});
    });
    pass.record([=, &view](const graph::PassContext& context) {
        SurfaceDraws::Bound bound;
        (*draws)->bind_geometry(context);
        for (const resident::VisibleDraw& one : view.visible().transmissive())
            (*draws)->draw(context, bound, one.draw);
    });
    return depth;
}

SurfaceDraws::Desc shading_desc(const resident::View& view, const ForwardInputs& inputs, const Behind& behind,
                                bool lists, bool more) {
    SurfaceDraws::Desc desc = blended_desc(view, inputs, lists, more);
    desc.depth = gpu::DepthTest::equal; // exact: vertex_position() is invariant
    desc.blend = more ? gpu::Blend::add : gpu::Blend::none;
    desc.layer_decals = false;
    desc.draws = resident::DrawClass::transmissive;
    desc.vertex |= gpu::Variant::transmission;
    for (gpu::ShaderKey* shader : {&desc.fragment, &desc.own_fragment})
        shader->variants |= gpu::Variant::transmission;
    desc.constants.emplace_back(CONSTANT_BEHIND_LAST_LEVEL, behind.last_level);
    return desc;
}

} // namespace

graph::ImageId transmission_passes(graph::FrameGraph& graph, const resident::View& view, ForwardInputs inputs,
                                   const BlendedLights& lights) {
    const Behind behind = behind_passes(graph, view, resolve_pass(graph, view, inputs.colour));
    inputs.depth = depth_passes(graph, view, inputs.depth);
    graph::Pass& pass = graph.pass(inputs.name);
    pass.colour(inputs.colour, graph::Load::keep).sample(INPUT_BEHIND, behind.image);
    const auto lists = declare_blended(graph, pass, inputs, lights.lists);
    struct Draws {
        std::optional<SurfaceDraws> first, more; ///< `more`: without lists
    };
    auto draws = std::make_shared<Draws>();
    pass.prepare([=, &view](const graph::PassInterface& interface) {
        draws->first.emplace(view, interface, shading_desc(view, inputs, behind, lists != nullptr, false));
        if (!lists)
            draws->more.emplace(view, interface, shading_desc(view, inputs, behind, false, true));
    });
    pass.record([=, &view, per_draw = lights.per_draw](const graph::PassContext& context) {
        SurfaceDraws::Bound bound;
        uint64_t drawn = 0;
        draws->first->bind_geometry(context);
        for (const resident::VisibleDraw& one : view.visible().transmissive())
            drawn += draw_lit(context, bound, *draws->first, draws->more ? &*draws->more : nullptr, one.draw,
                              lists.get(), view.reach(), per_draw);
        if (inputs.draws)
            *inputs.draws = drawn;
    });
    return inputs.depth;
}

} // namespace prelight::passes
