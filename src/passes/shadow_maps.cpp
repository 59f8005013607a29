#include "shadow_draws.hpp"
#include "shadow_extremes.hpp"
#include <optional>
#include <shared/bindings.h>
#include <shared/shadow.h>

namespace prelight::passes {
namespace {

void draw_pass(graph::Pass& pass, const resident::View& view, const Shadows& shadows, ShadowTarget target) {
    auto draws = std::make_shared<std::optional<ShadowDraws>>();
    pass.prepare(
        [=, &view](const graph::PassInterface& interface) { draws->emplace(view, interface.inputs, shadows, target); });
    pass.record([draws](const graph::PassContext& context) { (*draws)->record(context); });
}

bool transmits(const resident::View& view) {
    const resident::ShadowOptions& options = view.shadows()->options();
    return options.blended == resident::TransparentShadows::filtered && !options.reuse && view.scene().blends();
}

} // namespace

Shadows shadow_pass(graph::FrameGraph& graph, const resident::View& view, ShadowCounts& counts) {
    if (!view.shadows())
        return {};
    const glm::uvec2 size = view.shadows()->atlas_size();
    const graph::ImageId atlas = graph.image("shadow atlas", {shadow_format, {size.x, size.y}});
    graph.persist(atlas);
    graph.before_frame([&counts] { counts = {}; });
    // One texel of what no one reads, for bindings have to hold something.
    const auto beside = [&](const char* name, VkFormat format, bool read, uint32_t cell) {
        const VkExtent2D extent{std::max(size.x / cell, 1u), std::max(size.y / cell, 1u)};
        const graph::ImageId image = graph.image(name, {format, read ? extent : VkExtent2D{1, 1}});
        graph.persist(image);
        return image;
    };
    const bool transmittance = transmits(view), extremes = has_shadow_extremes(view.shadows()->options());
    Shadows shadows{.atlas = atlas,
                    .transmittance = beside("shadow transmittance", transmittance_format, transmittance, 1),
                    .extremes = beside("shadow extremes", extremes_format, extremes, SHADOW_CELL),
                    .counts = &counts,
                    .held = std::make_shared<HeldMaps>(),
                    .reused = view.shadows()->options().reuse};
    if (shadows.reused)
        return shadows;
    graph::Pass& pass = graph.pass("shadows");
    pass.depth_write(atlas, graph::Load::keep);
    draw_pass(pass, view, shadows, ShadowTarget::depth);
    if (transmittance) {
        graph::Pass& blended = graph.pass("transparent shadows");
        blended.colour(shadows.transmittance, graph::Load::keep).blends();
        blended.depth_test(atlas);
        draw_pass(blended, view, shadows, ShadowTarget::transmittance);
    }
    if (extremes)
        shadow_extremes_pass(graph, view, shadows);
    return shadows;
}

void declare_shadows(graph::Pass& pass, const Shadows& shadows) {
    if (shadows.reused)
        pass.draws_between(INPUT_SHADOW_ATLAS, shadows.atlas);
    else if (shadows)
        pass.sample(INPUT_SHADOW_ATLAS, shadows.atlas);
    if (shadows)
        pass.sample(INPUT_SHADOW_TRANSMITTANCE, shadows.transmittance).sample(INPUT_SHADOW_EXTREMES, shadows.extremes);
}

void add_shadow_constants(gpu::Constants& constants, const resident::View& view) {
    if (!view.shadows())
        return;
    constants.emplace_back(CONSTANT_SHADOW_FILTER, static_cast<uint32_t>(view.shadows()->options().filter));
    constants.emplace_back(CONSTANT_SHADOWS_TRANSMIT, transmits(view));
    constants.emplace_back(CONSTANT_SHADOW_EXTREMES, has_shadow_extremes(view.shadows()->options()));
}

gpu::Variants shadow_variant(const Shadows& shadows) { return gpu::when(bool(shadows), gpu::Variant::shadows); }

} // namespace prelight::passes
