#include "light_buffer_renderer.hpp"
#include "settings/light_culling_settings.hpp"
#include "settings/occlusion_settings.hpp"
#include <passes/light_pass.hpp>
#include <passes/view.hpp>

namespace prelight {

using passes::ViewKind;

uint32_t LightBufferRenderer::blended_adds(const resident::View& view) const {
    return model_.fixed_point() ? 0 : passes::light_adds(view, settings().is("light-writes", "blended"));
}

void LightBufferRenderer::add_light_settings(resident::ViewSettings& view) const {
    if (model_.fixed_point()) {
        view.measures_light = settings().is("light-scale", "auto");
        view.light_scale = view.measures_light ? 1 : settings().number("light-scale");
    }
    view.culling = light_culling(settings());
    view.volumes = volume_options(settings());
}

LightBufferRenderer::LightStage LightBufferRenderer::light_stage(graph::FrameGraph& graph, const resident::View& view,
                                                                 const passes::SampledSurfaces& surfaces) {
    passes::ScreenListOptions lists = screen_list_options(settings());
    if (surfaces.edges)
        lists.samples = &surfaces.samples;
    const bool wide = light_sums().wide();
    const bool pair = passes::is_pair_of_halves(model_) && !wide && passes::compute_walks(view, lists.shading);
    LightStage out;
    passes::SampledSurfaces lit = surfaces;
    // A program's own passes expect the light buffer to be as large as the picture.
    if (lit.edges && pair && !own_passes().any(vulkan::Stage::after_light))
        lit.edges->lay_beneath(view);
    out.edges = lit.edges;
    const bool both = lit.edges && lit.edges->lies_beneath();
    out.light = passes::make_light_buffer(graph, view, model_, pair, wide, both ? &*lit.edges : nullptr);
    out.lighting = {.surface = surfaces.pixels,
                    .model = model_,
                    .target = out.light.target,
                    .shadows = shadows(graph, view),
                    .pair_counters = &pair_counters(),
                    .count_pairs = options().count_pairs,
                    .write_once = settings().is("light-writes", "once")};
    scale_.reset();
    if (model_.fixed_point())
        scale_.emplace(view, passes::fixed_point(model_), settings().is("light-scale", "auto"))
            .measure(graph, view, out.lighting);
    out.lighting.lists = passes::screen_light_lists(graph, view, "light", out.lighting, lists);
    passes::light_pass(graph, view, "light", out.lighting);
    if (scale_)
        scale_->count_clipped(graph, view, out.light.diffuse, out.light.specular);
    if (lit.edges) {
        out.sample_light = both ? out.light : passes::make_light_buffer(graph, view, model_, pair, wide, &*lit.edges);
        passes::sample_light_pass(graph, view, "light samples", out.lighting, lit, out.sample_light.target);
    }
    return out;
}

passes::LightBuffer LightBufferRenderer::black_light(graph::FrameGraph& graph, const resident::View& view) const {
    const bool pair =
        passes::is_pair_of_halves(model_) && passes::compute_walks(view, screen_list_options(settings()).shading);
    passes::LightBuffer light = passes::make_light_buffer(graph, view, model_, pair, false);
    for (const graph::ImageId image : light.target.images)
        graph.persist(image);
    return light;
}

bool LightBufferRenderer::occludes() const { return occlusion_options(settings()).on; }

std::optional<graph::ImageId> LightBufferRenderer::visibility(graph::FrameGraph& graph, const resident::View& view,
                                                              const passes::SurfaceBuffers& surface) const {
    const passes::OcclusionOptions occlusion = occlusion_options(settings());
    if (!occlusion.on && !wants("ambient-occlusion"))
        return {};
    return passes::ambient_occlusion_passes(graph, view, surface, occlusion);
}

void LightBufferRenderer::add_light_views(Outputs& outputs, graph::FrameGraph& graph, const resident::View& view,
                                          const LightStage& stage, std::optional<graph::ImageId> visibility) const {
    const passes::SurfaceBuffers& surface = stage.lighting.surface;
    const passes::LightBuffer& light = stage.light;
    const auto show = [&](const char* name, ViewKind kind, graph::ImageId buffer) {
        if (wants(name))
            outputs[name] = passes::view_pass(graph, view, name, kind, surface, buffer);
    };
    show("depth", ViewKind::depth, surface.depth_source);
    show("normal", ViewKind::normal, surface.normal);
    show("roughness", ViewKind::roughness, surface.normal);
    const bool luv = model_.specular == passes::SpecularWay::luv;
    show("diffuse-light", luv ? ViewKind::light_luv : ViewKind::light, light.diffuse);
    if (model_.packed())
        show("specular-light", ViewKind::light_alpha, light.diffuse);
    else
        show("specular-light",
             passes::is_light_pair(graph, light.specular) ? ViewKind::second_light : ViewKind::specular_light,
             light.specular);
    if (visibility)
        show("ambient-occlusion", ViewKind::occlusion, *visibility);
    if (wants("light-count"))
        show("light-count", ViewKind::count, passes::light_count_pass(graph, view, stage.lighting));
}

void LightBufferRenderer::add_material_views(Outputs& outputs, graph::FrameGraph& graph, const resident::View& view,
                                             const passes::SurfaceBuffers& surface,
                                             const passes::MaterialInputs& materials) const {
    for (const bool specular : {false, true})
        if (const char* name = specular ? "specular-sum" : "diffuse-sum"; wants(name))
            outputs[name] = passes::light_sum_pass(graph, view, materials, specular);
    if (wants("albedo"))
        outputs["albedo"] = passes::view_pass(graph, view, "albedo", ViewKind::colour, surface,
                                              passes::albedo_pass(graph, view, materials));
}

void LightBufferRenderer::add_figures(Stats& stats) const {
    if (scale_)
        scale_->tell(stats);
}

} // namespace prelight
