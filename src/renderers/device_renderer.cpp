#include "device_renderer.hpp"
#include "read_back.hpp"
#include "settings/draw_settings.hpp"
#include "settings/sample_settings.hpp"
#include "settings/shadow_settings.hpp"
#include "settings/texture_settings.hpp"
#include <algorithm>
#include <cmath>
#include <exception>
#include <fmt/format.h>
#include <passes/deformation.hpp>
#include <passes/index_trimming.hpp>
#include <prelight/error.hpp>
#include <resident/texture_limit.hpp>
#include <timing/clocks.hpp>

namespace prelight {

DeviceRenderer::DeviceRenderer(Device& device, const RenderOptions& options, Settings settings)
    : context_(dynamic_cast<gpu::Context&>(device)), options_(options), settings_(std::move(settings)),
      light_sums_(settings_), blended_(settings_, context_, options), post_filter_(settings_, context_) {
    resolve_draw_settings(settings_, context_);
    resolve_texture_filter(settings_, context_);
    settings_.refuse_without_effect();
    check_size(options.width, options.height);
    check_samples(options.msaa);
    pair_counters_.emplace(context_, options.height);
    if (options.msaa > 1)
        edges_.emplace(context_);
    queue_ = std::make_unique<FrameQueue>(context_);
}

void DeviceRenderer::check_size(uint32_t width, uint32_t height) const {
    const uint32_t limit =
        std::min(context_.limits().maxImageDimension2D,
                 std::min(context_.limits().maxFramebufferWidth, context_.limits().maxFramebufferHeight));
    if (width == 0 || height == 0)
        throw Error(fmt::format("picture of {}x{}: has no pixels", width, height));
    if (width > limit || height > limit)
        throw Error(
            fmt::format("{}: picture of {}x{}: the device's limit is {}", context_.name(), width, height, limit));
}

void DeviceRenderer::check_samples(uint32_t samples) const {
    if (samples != 1 && samples != 2 && samples != 4)
        throw UsageError(fmt::format("--msaa {}: not one of 1, 2, 4", samples));
    if (!context_.has_samples(samples))
        throw Error(fmt::format("{}: --msaa {}: the device does not have so many", context_.name(), samples));
}

bool DeviceRenderer::wants(std::string_view view) const {
    return std::find(options_.views.begin(), options_.views.end(), view) != options_.views.end();
}

resident::ViewSettings DeviceRenderer::view_settings() const {
    return {.raster = {{options_.width, options_.height}, options_.msaa},
            .exposure = std::exp2(options_.exposure),
            .draws = draw_options(settings_),
            .shadows = shadow_options(settings_)};
}

resident::GpuSceneSettings DeviceRenderer::scene_settings() const {
    const resident::ViewSettings view = view_settings();
    return {.texture_filter = texture_filter(settings_),
            .exposure = view.exposure,
            .trimmed = view.draws.trims_on_device(),
            .casters = view.shadows.on,
            .blends = blended_.wanted(),
            .transmits = blended_.wanted()};
}

void DeviceRenderer::set_world(const World& world) {
    drop_graph(); // before what its passes refer to
    blended_.forget();
    view_.reset();
    light_view_.reset();
    lights_.reset();
    scene_.reset();
    changes_ms_ = 0;
    world_ = nullptr; // until all of the new one is there
    scene_ = std::make_unique<resident::GpuScene>(context_, world, scene_settings());
    lights_ = std::make_unique<resident::LightSet>(*scene_);
    make_view();
    build_graph();
    world_ = &world;
    triangles_ = world.triangles;
}

void DeviceRenderer::update_world(const WorldChanges& changes) {
    if (!world_)
        throw Error("renderer: set_world() comes before update_world()");
    try {
        take_changes(changes);
    } catch (const Error&) {
        world_ = nullptr; // some of it has been taken in
        drawn_ = false;   // stats() asks the world
        throw;
    }
}

void DeviceRenderer::take_changes(const WorldChanges& changes) {
    const double start = thread_ms();
    if (!scene_->update(changes)) {
        const std::span placed = lights_->placed();
        const std::vector<PlacedLight> lights(placed.begin(), placed.end());
        set_world(*world_);
        if (!changes.lights)
            set_lights(lights);
        return;
    }
    changes_ms_ += thread_ms() - start;
    if (changes.lights)
        return set_lights(world_->lights);
    if (graph_ && light_sums_.holds(blended_adds(light_view())))
        return;
    drop_graph();
    build_graph();
}

void DeviceRenderer::set_lights(std::span<const PlacedLight> lights) {
    if (!world_)
        throw Error("renderer: set_world() comes before set_lights()");
    const double start = thread_ms();
    check_lights(*world_->scene, lights);
    const uint32_t kinds = lights_->kinds();
    const bool none = lights_->placed().empty(), fits = lights_->holds(lights);
    if (fits) {
        lights_->replace(lights);
    } else {
        queue_->drain();
        resident::LightSet next = lights_->with(lights);
        each_view([&](resident::View& view) { view.make_light_buffers(next); });
        *lights_ = std::move(next);
    }
    changes_ms_ += thread_ms() - start;
    // Shaders leave out what none of the kinds needs that there were, and renderers passes where there was no light.
    const bool known = (lights_->kinds() & ~kinds) == 0 && (!none || lights.empty());
    if (fits && known && graph_ && light_sums_.holds(blended_adds(light_view())))
        return;
    drop_graph();
    build_graph();
}

void DeviceRenderer::resize(uint32_t width, uint32_t height) {
    check_size(width, height);
    const uint32_t old_width = options_.width, old_height = options_.height;
    try {
        remake_view(width, height);
    } catch (...) {
        const std::exception_ptr reason = std::current_exception();
        try {
            remake_view(old_width, old_height);
        } catch (const Error&) {
            world_ = nullptr; // as after a set_world() that failed
        }
        std::rethrow_exception(reason);
    }
}

void DeviceRenderer::make_view() {
    resident::ViewSettings settings = view_settings();
    blended_.adapt(settings_, settings, *scene_);
    view_ = std::make_unique<resident::View>(*scene_, *lights_, settings);
    if (const auto lit = light_view_settings())
        light_view_ = std::make_unique<resident::View>(*scene_, *lights_, *lit);
}

void DeviceRenderer::remake_view(uint32_t width, uint32_t height) {
    PairCounters counters(context_, height);
    drop_graph();
    options_.width = width;
    options_.height = height;
    pair_counters_ = std::move(counters);
    if (!world_)
        return;
    view_.reset(); // its memory may be what the next one needs
    light_view_.reset();
    make_view();
    build_graph();
}

void DeviceRenderer::finish() noexcept {
    try {
        queue_->drain();
    } catch (const Error&) {
        // a device that is lost draws no more
    }
}

void DeviceRenderer::drop_graph() {
    queue_->drain();
    if (drawn_)
        stats_ = stats();
    drawn_ = false;
    graph_.reset();
}

void DeviceRenderer::build_graph() {
    drawn_ = warm_ = outgrown_ = false;
    auto graph = std::make_unique<graph::FrameGraph>(context_);
    for (const std::string& note : settings_.notes())
        graph->note(note);
    light_sums_.choose(settings_, *graph, context_, blended_adds(light_view()));
    blended_.choose(settings_, *graph, *view_);
    shadows_.reset();
    passes::deformation_pass(*graph, *view_);
    each_view([&](const resident::View& view) { passes::index_trimming_passes(*graph, view); });
    outputs_ = build(*graph, *view_);
    for (const auto& [name, image] : outputs_)
        graph->keep(image);
    graph->compile();
    graph_ = std::move(graph); // none while one could not be made
}

passes::SampledSurfaces DeviceRenderer::sampled(graph::FrameGraph& graph, const resident::View& view,
                                                const passes::SurfaceBuffers& surface,
                                                passes::GBufferColours* colours) {
    if (!edges_)
        return {surface, surface, {}};
    return passes::sampled_surfaces(graph, view, surface, sample_light(settings_), *edges_, colours);
}

void DeviceRenderer::build_again() {
    drop_graph();
    build_graph();
}

void DeviceRenderer::clear_counters(VkCommandBuffer commands) const {
    if (options_.count_pairs)
        pair_counters_->clear(commands);
}

void DeviceRenderer::warm_up(const PlacedCamera& camera) {
    if (warm_)
        return;
    queue_->drain();
    update_views(camera);
    queue_->run([&](VkCommandBuffer commands) {
        clear_counters(commands);
        graph_->record_warm_up(commands);
    });
    warm_ = true;
}

void DeviceRenderer::count_layers(const PlacedCamera& camera) {
    if (!blended_.is_counting())
        return;
    queue_->drain();
    view_->update(camera);
    queue_->run([&](VkCommandBuffer commands) {
        clear_counters(commands);
        graph_->record(commands);
    });
    blended_.take_count();
    build_again();
    warm_up(camera);
}

void DeviceRenderer::render_frame(const PlacedCamera& camera) {
    const CreatedObjects before = created_since(context_, {});
    if (std::exchange(outgrown_, false)) {
        build_again();
        warm_up(camera);
    }
    const gpu::FrameTurn turn = queue_->begin();
    outgrown_ = outgrown(turn.slot);
    update_views(camera, turn.slot);
    const double start = thread_ms();
    UploadedBytes uploaded{scene_->updates().waiting(), 0};
    resident::UpdateTimes times;
    each_view([&](const resident::View& view) {
        uploaded.frame += view.written_bytes();
        times += view.update_times();
    });
    scene_->updates().record(queue_->commands(), turn.slot);
    clear_counters(queue_->commands());
    graph_->record(queue_->commands(), turn);
    queue_->submit(*graph_);
    costs_.add(std::exchange(changes_ms_, 0.0), times, thread_ms() - start, created_since(context_, before), uploaded);
}

void DeviceRenderer::time_passes(const PlacedCamera& camera) {
    queue_->drain();
    update_views(camera);
    queue_->run([&](VkCommandBuffer commands) { clear_counters(commands); });
    graph_->record_begin();
    for (size_t p = 0; p < graph_->passes(); ++p) {
        const double start = process_ms();
        queue_->run([&](VkCommandBuffer commands) { graph_->record_pass(commands, p); });
        costs_.add_pass(p, process_ms() - start);
    }
}

void DeviceRenderer::render(const PlacedCamera& camera, uint32_t frames) {
    if (!world_ || !graph_)
        throw Error("renderer: set_world() comes before render()");
    stats_stay_ = false;
    warm_up(camera);
    count_layers(camera);
    queue_->start();
    costs_.start(frames);
    for (uint32_t f = 0; f < frames; ++f)
        render_frame(camera);
    for (uint32_t f = 0; options_.pass_cpu && f < frames; ++f)
        time_passes(camera);
    drawn_ = true;
    camera_ = camera;
}

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
    const auto found = outputs_.find(view);
    if (found == outputs_.end())
        throw UsageError(fmt::format("--view {}: was not asked for when the renderer was made", view));
    return graph_->shown(found->second);
}

Image DeviceRenderer::read(std::string_view view) {
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
    const auto found = outputs_.find(view);
    if (found == outputs_.end())
        throw UsageError(fmt::format("--view {}: was not asked for when the renderer was made", view));
    const graph::ImageDesc& desc = graph_->desc(found->second);
    queue_->drain();
    return unpack(graph_->read_back(found->second), desc.format, desc.raster.extent);
}

} // namespace prelight
