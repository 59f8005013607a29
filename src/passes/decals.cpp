// Decals: boxes in the scene that change normal, roughness and colour of what lies in them, between the first and the
// second stage, so that light meets them like everything else. They are gathered in a buffer of their own, for
// neither can a pass read the normals that it writes, nor can fixed-function blending mix encoded ones; then each
// object that a decal reaches is drawn once more with what the buffer holds for its pixels.
#include "decals.hpp"
#include "surface_draws.hpp"
#include <map>
#include <shared/bindings.h>
#include <shared/normal_encoding.h>

namespace prelight::passes {
namespace {

using resident::DecalBox;
using resident::DecalView;

class DecalDraws {
public:
    DecalDraws(const resident::View& view, const graph::PassInterface& interface, const SurfaceBuffers& surface)
        : view_(view) {
        gpu::GraphicsPipelineDesc desc;
        desc.vertex = "decals.vert";
        desc.fragment = {"decals.frag", gpu::when(interface.attachments.samples > 1, gpu::Variant::samples)};
        desc.attachments = interface.attachments;
        desc.blend = gpu::Blend::over;
        desc.sets = {view.layout(), interface.inputs, view.scene().materials().layout};
        desc.push_bytes = sizeof(shared::DecalConstants);
        desc.push_stage = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
        for (const DecalBox& box : view.scene().decals())
            for (const bool inside : {false, true}) {
                if (pipelines_.contains(key(box, inside)))
                    continue;
                desc.name = std::string(inside ? "decals from inside" : "decals from outside") + ", features " +
                            std::to_string(box.features);
                desc.depth = inside ? gpu::DepthTest::none : gpu::DepthTest::behind_or_at;
                desc.constants = surface.format.constants();
                desc.constants.emplace_back(CONSTANT_MATERIAL_FEATURES, box.features);
                pipelines_.emplace(key(box, inside), gpu::GraphicsPipeline(view.context(), desc));
            }
    }

    void record(const graph::PassContext& pass) const {
        for (const DecalBox& box : view_.scene().decals()) {
            const DecalView seen = view_of(box, view_.eye(), view_.clip_from_world());
            if (pass.one_pixel || seen == DecalView::from_outside)
                draw(pass, box, false);
            if (pass.one_pixel || seen == DecalView::from_inside)
                draw(pass, box, true);
        }
    }

private:
    using Key = std::pair<uint32_t, bool>;
    static Key key(const DecalBox& box, bool inside) { return {box.features, inside}; }

    /// From outside front faces find surfaces behind them; from inside back faces cover what the camera may see of
    /// the box.
    void draw(const graph::PassContext& pass, const DecalBox& box, bool inside) const {
        const gpu::GraphicsPipeline& pipeline = pipelines_.at(key(box, inside));
        pipeline.bind(pass.commands);
        pipeline.bind_set(pass.commands, SET_FRAME, view_.set());
        pipeline.bind_set(pass.commands, SET_INPUTS, pass.inputs);
        pipeline.bind_set(pass.commands, SET_MATERIAL,
                          view_.scene().materials().sets_for_gradients()[box.decal.material]);
        vkCmdSetCullMode(pass.commands, inside ? VK_CULL_MODE_FRONT_BIT : VK_CULL_MODE_BACK_BIT);
        vkCmdSetFrontFace(pass.commands, box.mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
        const shared::DecalConstants constants = decal_constants(box, view_.eye(), inside);
        pipeline.push(pass.commands, std::as_bytes(std::span(&constants, 1)));
        vkCmdDraw(pass.commands, 36, 1, 0, 0);
    }

    const resident::View& view_;
    std::map<Key, gpu::GraphicsPipeline> pipelines_;
};

} // namespace

DecalBuffer decal_pass(graph::FrameGraph& graph, const resident::View& view, const SurfaceBuffers& surface) {
    if (view.scene().decals().empty())
        return {};
    const auto target = [&](const char* name, VkFormat format) {
        return graph.image(name, {format, graph.raster(surface.depth)});
    };
    const DecalBuffer out{
        target("decal colour", VK_FORMAT_R16G16B16A16_SFLOAT), target("decal normal", VK_FORMAT_R16G16B16A16_SFLOAT),
        target("decal roughness", VK_FORMAT_R16G16_SFLOAT), target("decal metallic", VK_FORMAT_R16_SFLOAT)};
    graph::Pass& pass = graph.pass("decals");
    pass.colour(out.colour, graph::Load::clear, {0, 0, 0, 1})
        .colour(out.normal, graph::Load::clear, {0, 0, 0, 1})
        .colour(out.roughness, graph::Load::clear, {0, 1, 0, 1})
        .colour(out.metallic, graph::Load::clear)
        .blends()
        .depth_test(surface.depth)
        .sample(INPUT_DEPTH, surface.depth_source)
        .sample(INPUT_NORMAL, surface.normal)
        .sample(INPUT_ROUGHNESS, surface.roughness);
    auto draws = std::make_shared<std::optional<DecalDraws>>();
    pass.prepare([=, &view](const graph::PassInterface& interface) { draws->emplace(view, interface, surface); });
    pass.record([draws](const graph::PassContext& context) { (*draws)->record(context); });
    return out;
}

void declare_decals(graph::Pass& pass, const DecalBuffer& decals) {
    if (!decals)
        return;
    pass.sample(INPUT_DECAL_COLOUR, decals.colour)
        .sample(INPUT_DECAL_NORMAL, decals.normal)
        .sample(INPUT_DECAL_ROUGHNESS, decals.roughness)
        .sample(INPUT_DECAL_METALLIC, decals.metallic);
}

void decal_normal_pass(graph::FrameGraph& graph, const resident::View& view, const SurfaceBuffers& surface,
                       const DecalBuffer& decals) {
    if (!decals)
        return;
    graph::Pass& pass = graph.pass("decal-normal");
    const bool stencil = surface.format.roughness_in_stencil;
    if (stencil)
        pass.stencil(surface.depth).keeps_stencil(graph::Load::keep);
    else
        pass.depth_test(surface.depth);
    pass.colour(surface.normal, graph::Load::keep);
    const bool apart = surface.roughness != surface.normal;
    if (apart)
        pass.colour(surface.roughness, graph::Load::keep);
    declare_decals(pass, decals);
    draw_surfaces(graph, pass, view,
                  {.name = pass.name(),
                   .fragment = {"depth_normal.frag", gpu::when(stencil, gpu::Variant::stencil_roughness) |
                                                         gpu::when(apart, gpu::Variant::roughness_target)},
                   .constants = surface.format.constants(),
                   .depth = gpu::DepthTest::equal,
                   .keeps_alpha_mask = false,
                   .vertex = gpu::Variant::no_world,
                   .decals = SurfaceDraws::Decals::only});
}

void decal_geometry_pass(graph::FrameGraph& graph, const resident::View& view, const GBuffer& gbuffer,
                         const DecalBuffer& decals) {
    if (!decals)
        return;
    graph::Pass& pass = graph.pass("decal-geometry");
    pass.depth_test(gbuffer.surface.depth);
    for (const graph::ImageId target : gbuffer.targets())
        pass.colour(target, graph::Load::keep);
    declare_decals(pass, decals);
    draw_surfaces(graph, pass, view,
                  {.name = pass.name(),
                   .fragment = gbuffer.fragment(),
                   .constants = gbuffer.surface.format.constants(),
                   .depth = gpu::DepthTest::equal,
                   .keeps_alpha_mask = false,
                   .vertex = gpu::Variant::motion,
                   .decals = SurfaceDraws::Decals::only});
}

DecalBuffer decals_of_own(graph::FrameGraph& graph, const resident::View& view) {
    return view.scene().decals().empty() ? DecalBuffer{} : decal_pass(graph, view, depth_normal_pass(graph, view, {}));
}

} // namespace prelight::passes
