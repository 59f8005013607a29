#include "device_renderer.hpp"
#include "draw_settings.hpp"
#include "shadow_settings.hpp"
#include "texture_settings.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/packing.hpp>
#include <gpu/check.hpp>
#include <passes/background.hpp>
#include <passes/index_trimming.hpp>
#include <prelight/error.hpp>
#include <resident/texture_limit.hpp>
#include <timing/clocks.hpp>

namespace prelight {
namespace {

/// Full floats end where half floats do, so that a picture does not depend on what its light was added up in.
constexpr float half_max = 65504;

Image unpack(const std::vector<std::byte>& texels, VkFormat format, VkExtent2D extent) {
    Image image(extent.width, extent.height);
    if (format == VK_FORMAT_R8G8B8A8_UNORM || format == VK_FORMAT_R8G8B8A8_SRGB) { // the bytes as stored
        for (size_t i = 0; i < image.pixels.size(); ++i)
            for (int c = 0; c < 3; ++c)
                image.pixels[i][c] = static_cast<float>(texels[4 * i + size_t(c)]) / 255.0f;
        return image;
    }
    if (format == VK_FORMAT_R32G32B32A32_SFLOAT) {
        const auto* floats = reinterpret_cast<const float*>(texels.data());
        for (size_t i = 0; i < image.pixels.size(); ++i)
            image.pixels[i] =
                glm::clamp(glm::vec3(floats[4 * i], floats[4 * i + 1], floats[4 * i + 2]), -half_max, half_max);
        return image;
    }
    const auto* halves = reinterpret_cast<const uint16_t*>(texels.data());
    for (size_t i = 0; i < image.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            image.pixels[i][c] = glm::unpackHalf1x16(halves[4 * i + size_t(c)]);
    return image;
}

/// What has been made on the device, less `before`.
CreatedObjects created_since(const gpu::Context& context, const CreatedObjects& before) {
    using Kind = gpu::Context::Kind;
    return {.allocations = context.created(Kind::allocation) - before.allocations,
            .pipelines = context.created(Kind::pipeline) - before.pipelines,
            .buffers = context.created(Kind::buffer) - before.buffers,
            .images = context.created(Kind::image) - before.images,
            .descriptor_pools = context.created(Kind::descriptor_pool) - before.descriptor_pools};
}

} // namespace

DeviceRenderer::DeviceRenderer(Device& device, const RenderOptions& options, Settings settings)
    : context_(dynamic_cast<gpu::Context&>(device)), options_(options), settings_(std::move(settings)),
      light_sums_(settings_) {
    resolve_draw_settings(settings_, context_);
    resolve_texture_filter(settings_, context_);
    settings_.refuse_without_effect();
    const uint32_t limit =
        std::min(context_.limits().maxImageDimension2D,
                 std::min(context_.limits().maxFramebufferWidth, context_.limits().maxFramebufferHeight));
    if (options.width == 0 || options.height == 0)
        throw Error(fmt::format("picture of {}x{}: has no pixels", options.width, options.height));
    if (options.width > limit || options.height > limit)
        throw Error(fmt::format("{}: picture of {}x{}: the device's limit is {}", context_.name(), options.width,
                                options.height, limit));
    if (options.msaa != 1)
        throw UsageError(fmt::format("--msaa {}: this renderer has one sample a pixel", options.msaa));
    pair_counters_ =
        gpu::Buffer(context_, "pair counters", uint64_t(options.height) * 2 * sizeof(uint32_t),
                    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::BufferPlace::readback);
    queue_ = std::make_unique<FrameQueue>(context_);
}

bool DeviceRenderer::wants(std::string_view view) const {
    return std::find(options_.views.begin(), options_.views.end(), view) != options_.views.end();
}

resident::FrameSettings DeviceRenderer::frame_settings() const {
    return {.width = options_.width,
            .height = options_.height,
            .exposure = std::exp2(options_.exposure),
            .texture_filter = texture_filter(settings_),
            .draws = draw_options(settings_),
            .shadows = shadow_options(settings_)};
}

DeviceRenderer::Views DeviceRenderer::linear_views(graph::FrameGraph& graph, const resident::Frame& frame,
                                                   graph::ImageId linear, graph::ImageId depth) const {
    passes::background_pass(graph, frame, linear, depth, {});
    Views views{{"final", passes::tonemap_pass(graph, frame, linear, options_.tonemap)}};
    if (wants("linear"))
        views["linear"] = linear;
    return views;
}

DeviceRenderer::Views DeviceRenderer::picture_views(graph::FrameGraph& graph, const resident::Frame& frame,
                                                    graph::ImageId depth,
                                                    const std::function<graph::ImageId(passes::Display)>& draw) const {
    if (wants("linear"))
        return linear_views(graph, frame, draw({}), depth);
    const graph::ImageId picture = draw(options_.tonemap);
    passes::background_pass(graph, frame, picture, depth, options_.tonemap);
    return Views{{"final", picture}};
}

void DeviceRenderer::set_world(const World& world) {
    drop_graph();     // before what its passes refer to
    world_ = nullptr; // until all of the new one is there
    frame_ = std::make_unique<resident::Frame>(context_, world, frame_settings());
    build_graph();
    world_ = &world;
    triangles_ = world.triangles;
}

void DeviceRenderer::set_lights(std::span<const PlacedLight> lights) {
    if (!world_)
        throw Error("renderer: set_world() comes before set_lights()");
    if (frame_->set_lights(lights, [&] { queue_->drain(); }) && graph_ && light_sums_.holds(blended_adds(*frame_)))
        return;
    drop_graph();
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
    drawn_ = warm_ = false;
    auto graph = std::make_unique<graph::FrameGraph>(context_);
    for (const std::string& note : settings_.notes())
        graph->note(note);
    light_sums_.choose(settings_, *graph, context_, blended_adds(*frame_));
    passes::index_trimming_passes(*graph, *frame_);
    views_ = build(*graph, *frame_);
    for (const auto& [name, image] : views_)
        graph->keep(image);
    graph->compile();
    graph_ = std::move(graph); // none while one could not be made
}

void DeviceRenderer::clear_pairs(VkCommandBuffer commands) const {
    if (!options_.count_pairs)
        return;
    const auto barrier = [&](VkPipelineStageFlags2 from, VkAccessFlags2 wrote, VkPipelineStageFlags2 to,
                             VkAccessFlags2 access) {
        VkBufferMemoryBarrier2 b{VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2};
        b.srcStageMask = from;
        b.srcAccessMask = wrote;
        b.dstStageMask = to;
        b.dstAccessMask = access;
        b.srcQueueFamilyIndex = b.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        b.buffer = pair_counters_.handle();
        b.size = VK_WHOLE_SIZE;
        VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
        info.bufferMemoryBarrierCount = 1;
        info.pBufferMemoryBarriers = &b;
        vkCmdPipelineBarrier2(commands, &info);
    };
    // The frame before may still count.
    barrier(VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
            VK_ACCESS_2_TRANSFER_WRITE_BIT);
    vkCmdFillBuffer(commands, pair_counters_.handle(), 0, VK_WHOLE_SIZE, 0);
    barrier(VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
            VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
}

void DeviceRenderer::warm_up(const PlacedCamera& camera) {
    if (warm_)
        return;
    queue_->drain();
    frame_->update(camera);
    queue_->run([&](VkCommandBuffer commands) {
        clear_pairs(commands);
        graph_->record_warm_up(commands);
    });
    warm_ = true;
}

void DeviceRenderer::render_frame(const PlacedCamera& camera) {
    const CreatedObjects before = created_since(context_, {});
    const gpu::FrameTurn turn = queue_->begin();
    frame_->update(camera, turn.slot);
    const double start = thread_ms();
    clear_pairs(queue_->commands());
    graph_->record(queue_->commands(), turn);
    queue_->submit(*graph_);
    const resident::UpdateTimes& times = frame_->update_times();
    host_.lights.push_back(times.lights);
    host_.culling.push_back(times.culling);
    host_.objects.push_back(times.objects);
    host_.record.push_back(thread_ms() - start);
    created_ = created_since(context_, before);
}

void DeviceRenderer::time_passes(const PlacedCamera& camera) {
    queue_->drain();
    frame_->update(camera);
    queue_->run([&](VkCommandBuffer commands) { clear_pairs(commands); });
    graph_->record_begin();
    pass_cpu_.resize(graph_->passes());
    for (size_t p = 0; p < pass_cpu_.size(); ++p) {
        const double start = process_ms();
        queue_->run([&](VkCommandBuffer commands) { graph_->record_pass(commands, p); });
        pass_cpu_[p].push_back(process_ms() - start);
    }
}

void DeviceRenderer::render(const PlacedCamera& camera, uint32_t frames) {
    if (!world_ || !graph_)
        throw Error("renderer: set_world() comes before render()");
    stats_stay_ = false;
    warm_up(camera);
    queue_->start();
    frames_ = frames;
    pass_cpu_.clear();
    host_ = {};
    for (uint32_t f = 0; f < frames; ++f)
        render_frame(camera);
    for (uint32_t f = 0; options_.pass_cpu && f < frames; ++f)
        time_passes(camera);
    drawn_ = true;
    camera_ = camera;
}

Stats DeviceRenderer::stats() const {
    if (!drawn_ || stats_stay_)
        return stats_;
    queue_->drain();
    const FrameSamples& samples = queue_->samples();
    Stats stats;
    stats.device = context_.name();
    stats.driver = context_.driver();
    stats.settings = settings_.all();
    stats.shading = settings_.shading();
    stats.notes = graph_->notes();
    for (std::string& note :
         resident::notes_on_large_textures(*frame_->world().scene, context_.limits().maxImageDimension2D))
        stats.notes.push_back(std::move(note));
    stats.lights = frame_->placed_lights().size();
    stats.triangles = triangles_;
    stats.draws = draws(*frame_);
    stats.triangles_drawn = frame_->triangles_drawn();
    stats.draws_skipped = frame_->draws_skipped();
    stats.triangles_skipped = frame_->triangles_skipped();
    stats.frames = frames_;
    stats.wall_ms = spread(samples.wall);
    stats.cpu_ms = spread(samples.cpu);
    stats.gpu_ms = spread(samples.gpu);
    const std::vector<graph::PassTraffic> traffic = graph_->traffic();
    for (size_t p = 0; p < samples.passes.size(); ++p) {
        PassStats& pass = stats.passes.emplace_back();
        pass.name = samples.passes[p].first;
        pass.gpu_ms = spread(samples.passes[p].second);
        pass.bytes_read = traffic[p].bytes_read;
        pass.bytes_written = traffic[p].bytes_written;
        if (p < pass_cpu_.size())
            pass.cpu_ms = spread(pass_cpu_[p]);
    }
    stats.attachment_bytes = graph_->memory_bytes();
    stats.attachment_bytes_unshared = graph_->unshared_bytes();
    stats.device_bytes = context_.device_bytes();
    stats.device_bytes_peak = context_.device_bytes_peak();
    stats.created = created_;
    stats.host_ms = HostTimes{spread(host_.lights), spread(host_.culling), spread(host_.objects), spread(host_.record)};
    count_pairs(stats);
    tell_shadows(stats);
    add_figures(stats);
    return stats;
}

void DeviceRenderer::tell_shadows(Stats& stats) const {
    if (!frame_->shadows())
        return;
    ShadowStats shadows = frame_->shadows()->stats();
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

void DeviceRenderer::count_pairs(Stats& stats) const {
    stats.pairs_counted = options_.count_pairs;
    if (!options_.count_pairs)
        return;
    const uint32_t* rows = pair_counters_.mapped<uint32_t>();
    for (size_t y = 0; y < options_.height; ++y) {
        stats.pairs_evaluated += rows[2 * y];
        stats.pairs_contributing += rows[2 * y + 1];
    }
}

Image DeviceRenderer::read(std::string_view view) {
    if (!drawn_)
        throw Error("renderer: render() comes before read()");
    if (view == "linear" && !views_.contains(view)) { // the graph has no such image: once more, with it
        options_.views.emplace_back(view);
        const Stats stats = this->stats();
        drop_graph();
        build_graph();
        render(camera_, 1);
        stats_ = stats;
        stats_stay_ = true;
    }
    const auto found = views_.find(view);
    if (found == views_.end())
        throw UsageError(fmt::format("--view {}: was not asked for when the renderer was made", view));
    const graph::ImageDesc& desc = graph_->desc(found->second);
    queue_->drain();
    return unpack(graph_->read_back(found->second), desc.format, desc.extent);
}

} // namespace prelight
