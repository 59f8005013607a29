#include "blended_surfaces.hpp"
#include "settings/light_model_settings.hpp"
#include "settings/sample_settings.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <passes/weighted_blended.hpp>

namespace prelight {

BlendedSurfaces::BlendedSurfaces(Settings& settings, const gpu::Context& context) {
    resolve_transparency(settings, context);
    transparency_ = transparency(settings);
    reused_shadows_ = settings.has("shadow-memory") && settings.is("shadow-memory", "reuse");
    if (!wanted())
        return;
    per_draw_ = blended_lights(settings);
    if (settings.has("msaa-material"))
        sample_shading_ = material_shading(settings);
    model_ = blended_light_model(settings);
}

void BlendedSurfaces::adapt(Settings& settings, resident::ViewSettings& view, const resident::GpuScene& scene) const {
    if (!wanted() || !reused_shadows_ || !view.shadows.on)
        return;
    view.shadows.reuse = !scene.blends();
    settings.resolve("shadow-memory", view.shadows.reuse ? "reuse" : "atlas",
                     "blended surfaces are lit by all lights at once");
}

void BlendedSurfaces::choose(Settings& settings, graph::FrameGraph& graph, resident::View& view) {
    draws_ = 0;
    by_lists_ = false;
    const resident::GpuScene& scene = view.scene();
    if (settings.has("transparency") && !wanted()) {
        const std::vector<Material>& materials = scene.world().scene->materials;
        const auto blends = [&](const resident::Draw& draw) {
            return materials[draw.material].alpha_mode == AlphaMode::blend;
        };
        if (const auto& draws = scene.geometry().draws; std::any_of(draws.begin(), draws.end(), blends))
            graph.note("transparency=opaque: surfaces with alphaMode BLEND are drawn opaque");
    }
    if (!scene.blends() || !wanted())
        return;
    const uint32_t rounds = passes::light_rounds(view, passes::LightWalk::fragment).count;
    by_lists_ = takes_lists(transparency_) && rounds == 1;
    if (reused_shadows_ && view.shadows())
        graph.note("shadow-memory=reuse: blended surfaces are lit by all lights at once, atlas is taken");
    if (takes_lists(transparency_)) {
        const std::string word = transparency_word(transparency_);
        const std::string why =
            fmt::format("{} lights take {} rounds of lists, which cannot be blended", view.lights().capacity(), rounds);
        if (!by_lists_)
            graph.note(fmt::format("transparency={}: {}, sorted is taken", word, why));
        settings.resolve("transparency", by_lists_ ? word : "sorted", why);
    }
    view.find_blended_lights(!by_lists_);
}

void BlendedSurfaces::add(graph::FrameGraph& graph, const resident::View& view, passes::ForwardInputs inputs,
                          const passes::LightLists* lists) {
    if (!view.scene().blends() || !wanted())
        return;
    inputs.name = "blended";
    inputs.model = model_;
    inputs.sample_shading = sample_shading_;
    inputs.draws = &draws_;
    std::optional<passes::LightLists> own;
    if (by_lists_ && !lists)
        lists = &own.emplace(passes::grid_light_lists(graph, view, "blended"));
    if (by_lists_ && transparency_ == Transparency::weighted)
        passes::weighted_blended_pass(graph, view, inputs, *lists);
    else
        passes::blended_pass(graph, view, inputs, {.lists = by_lists_ ? lists : nullptr, .per_draw = per_draw_});
}

void BlendedSurfaces::tell(Stats& stats) const {
    stats.draws += draws_;
    if (transparency_ == Transparency::weighted && by_lists_ && draws_ > 0)
        stats.notes.push_back(fmt::format(
            "transparency=weighted: {} draws of blended surfaces are composed without order, approximately", draws_));
}

} // namespace prelight
