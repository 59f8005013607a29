#include "shadow_draws.hpp"
#include <optional>
#include <shared/bindings.h>

namespace prelight::passes {

Shadows shadow_pass(graph::FrameGraph& graph, const resident::View& view, ShadowCounts& counts) {
    if (!view.shadows())
        return {};
    const glm::uvec2 size = view.shadows()->atlas_size();
    const graph::ImageId atlas = graph.image("shadow atlas", {shadow_format, {size.x, size.y}});
    graph.persist(atlas);
    graph.before_frame([&counts] { counts = {}; });
    const Shadows shadows{.atlas = atlas,
                          .counts = &counts,
                          .held = std::make_shared<HeldMaps>(),
                          .reused = view.shadows()->options().reuse};
    if (shadows.reused)
        return shadows;
    graph::Pass& pass = graph.pass("shadows");
    pass.depth_write(atlas, graph::Load::keep);
    auto draws = std::make_shared<std::optional<ShadowDraws>>();
    pass.prepare(
        [=, &view](const graph::PassInterface& interface) { draws->emplace(view, interface.inputs, shadows); });
    pass.record([draws](const graph::PassContext& context) { (*draws)->record(context); });
    return shadows;
}

void declare_shadows(graph::Pass& pass, const Shadows& shadows) {
    if (shadows.reused)
        pass.draws_between(INPUT_SHADOW_ATLAS, shadows.atlas);
    else if (shadows)
        pass.sample(INPUT_SHADOW_ATLAS, shadows.atlas);
}

void add_shadow_constants(gpu::Constants& constants, const resident::View& view) {
    if (view.shadows())
        constants.emplace_back(CONSTANT_SHADOW_FILTER, static_cast<uint32_t>(view.shadows()->options().filter));
}

gpu::Variants shadow_variant(const Shadows& shadows) { return gpu::when(bool(shadows), gpu::Variant::shadows); }

} // namespace prelight::passes
