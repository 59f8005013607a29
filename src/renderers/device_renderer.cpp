#include "device_renderer.hpp"
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
#include <passes/target.hpp>
#include <platform/clocks.hpp>
#include <prelight/error.hpp>
#include <scene/world_to_share.hpp>
#include <setting_values/sample_counts.hpp>

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
    check_sample_count(samples);
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

void DeviceRenderer::set_world(const World& world) { take_world(world, nullptr); }

void DeviceRenderer::share_world(const Renderer& other) {
    const auto* const owner = dynamic_cast<const DeviceRenderer*>(&other);
    const World& world = world_to_share(other);
    if (owner == this)
        return;
    const bool same = owner && &owner->context_ == &context_ && owner->scene_->settings() == scene_settings();
    take_world(world, same ? owner->scene_ : nullptr);
}

void DeviceRenderer::take_world(const World& world, std::shared_ptr<resident::GpuScene> scene) {
    drop_graph(); // before what its passes refer to
    blended_.forget();
    view_.reset();
    light_view_.reset();
    lights_.reset();
    scene_.reset();
    changes_ms_ = 0;
    world_ = nullptr; // until all of the new one is there
    scene_ = scene ? std::move(scene) : std::make_shared<resident::GpuScene>(context_, world, scene_settings());
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
    const bool as_many = draws_as_many(lights_->placed().size(), lights.size());
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
    const bool known = (lights_->kinds() & ~kinds) == 0 && (!none || lights.empty()) && as_many;
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
    own_passes_.begin();
    outputs_ = build(*graph, *view_);
    own_passes_.end();
    if (target_form_)
        passes::target_pass(*graph, *view_, output(target_form_->buffer), target_form_->format);
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
    passes::SampledSurfaces surfaces =
        passes::sampled_surfaces(graph, view, surface, sample_light(settings_), *edges_, colours);
    surfaces.shadows_per_pixel = shadows_per_pixel(settings_);
    return surfaces;
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

void DeviceRenderer::render_frame(const PlacedCamera& camera, const vulkan::Target* target) {
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
    scene_->updates().record(queue_->commands(), update_staging_[turn.slot]);
    clear_counters(queue_->commands());
    graph_->bind(target ? std::optional(external_image(*target)) : std::nullopt);
    graph_->record(queue_->commands(), turn);
    graph_->bind({}); // whatever is recorded beside frames
    queue_->submit(*graph_, target ? semaphores_of(*target) : gpu::Context::Semaphores{});
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

void DeviceRenderer::render(const PlacedCamera& camera, uint32_t frames) { render(camera, frames, nullptr); }

void DeviceRenderer::render(const PlacedCamera& camera, uint32_t frames, const vulkan::Target* target) {
    if (!world_ || !graph_)
        throw Error("renderer: set_world() comes before render()");
    stats_stay_ = false;
    warm_up(camera);
    count_layers(camera);
    queue_->start();
    costs_.start(frames);
    for (uint32_t f = 0; f < frames; ++f)
        render_frame(camera, target);
    for (uint32_t f = 0; options_.pass_cpu && f < frames; ++f)
        time_passes(camera);
    drawn_ = true;
    camera_ = camera;
}

} // namespace prelight
