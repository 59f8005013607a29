// What a renderer tells of its frames: figures and buffers.
#include "device_renderer.hpp"
#include "read_back.hpp"
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <resident/texture_limit.hpp>

namespace prelight {

Stats DeviceRenderer::stats() const {
    if (drawn_ ? stats_stay_ : stats_.frames > 0)
        return stats_;
    Stats stats;
    stats.device = context_.name();
    stats.driver = context_.driver();
    stats.settings = settings_.all();
    stats.choices = settings_.choices();
    stats.shading = settings_.shading();
    if (!drawn_)
        return stats;
    queue_->drain();
    stats.notes = graph_->notes();
    for (std::string& note : resident::notes_on_large_textures(*world_->scene, context_.limits().maxImageDimension2D))
        stats.notes.push_back(std::move(note));
    stats.lights = lights_->placed().size();
    stats.triangles = triangles_;
    stats.draws = draws(*view_);
    blended_.tell(stats);
    stats.triangles_drawn = view_->triangles_drawn();
    stats.draws_skipped = view_->draws_skipped();
    stats.triangles_skipped = view_->triangles_skipped();
    costs_.tell(stats, queue_->samples(), graph_->traffic());
    stats.attachment_bytes = graph_->memory_bytes();
    stats.attachment_bytes_unshared = graph_->unshared_bytes();
    stats.device_bytes = context_.device_bytes();
    stats.device_bytes_peak = context_.device_bytes_peak();
    stats.pairs_counted = options_.count_pairs;
    if (options_.count_pairs)
        pair_counters_->tell(stats);
    tell_shadows(stats);
    add_figures(stats);
    return stats;
}

void DeviceRenderer::tell_shadows(Stats& stats) const {
    if (!light_view().shadows())
        return;
    ShadowStats shadows = light_view().shadows()->stats();
    shadows.tiles_drawn = shadow_counts_.tiles_drawn;
    shadows.tiles_reused = shadow_counts_.tiles_reused;
    shadows.casters_drawn = shadow_counts_.casters_drawn;
    stats.shadows = shadows;
    if (shadows.lights_reduced > 0)
        stats.notes.push_back(fmt::format(
            "shadow-budget: {} of {} lights have shadow maps with less than a texel for eight pixels across",
            shadows.lights_reduced, shadows.lights));
    if (shadows.lights_without > 0)
        stats.notes.push_back(fmt::format("shadow-budget: {} lights have no shadow, not a texel was left for them",
                                          shadows.lights_without));
}

gpu::ShownImage DeviceRenderer::shown(std::string_view view) const {
    if (!drawn_)
        throw Error("renderer: render() comes before shown()");
    return graph_->shown(output(view));
}

graph::ImageId DeviceRenderer::output(std::string_view view) const {
    const auto found = outputs_.find(view);
    if (found == outputs_.end())
        throw UsageError(fmt::format("--view {}: was not asked for when the renderer was made", view));
    return found->second;
}

graph::ImageId DeviceRenderer::finished(std::string_view view) {
    if (!drawn_)
        throw Error("renderer: render() comes before read()");
    queue_->drain();
    for (uint32_t slot = 0; slot < gpu::frames_in_flight; ++slot)
        outgrown_ = outgrown(slot) || outgrown_;
    const bool absent = view == "linear" && !outputs_.contains(view); // the graph has no such image
    if (absent)
        options_.views.emplace_back(view);
    if (absent || outgrown_) { // once more
        Stats stats = this->stats();
        const bool outgrown = std::exchange(outgrown_, false);
        build_again();
        render(camera_, 1);
        if (outgrown) { // the picture is not the one that render() drew
            stats.layers = this->stats().layers;
            stats.notes = this->stats().notes;
        }
        stats_ = stats;
        stats_stay_ = true;
    }
    queue_->drain();
    return output(view);
}

Image DeviceRenderer::read(std::string_view view) {
    const graph::ImageId image = finished(view);
    const graph::ImageDesc& desc = graph_->desc(image);
    return unpack(graph_->read_back_buffer(image).mapped<std::byte>(), desc.format, desc.raster.extent);
}

Texels DeviceRenderer::texels(std::string_view view) {
    const graph::ImageId image = finished(view);
    const graph::ImageDesc& desc = graph_->desc(image);
    return hand_out(graph_->read_back_buffer(image), desc.format, desc.raster.extent);
}

} // namespace prelight
