#include "device_renderer.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <glm/gtc/packing.hpp>
#include <gpu/check.hpp>
#include <timing/clocks.hpp>

namespace prelight {
namespace {

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
            image.pixels[i] = {floats[4 * i], floats[4 * i + 1], floats[4 * i + 2]};
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
    : context_(dynamic_cast<gpu::Context&>(device)), options_(options), settings_(std::move(settings)) {
    const uint32_t limit = std::min(context_.limits().maxImageDimension2D,
                                    std::min(context_.limits().maxFramebufferWidth,
                                             context_.limits().maxFramebufferHeight));
    if (options.width == 0 || options.height == 0)
        throw Error(fmt::format("picture of {}x{}: has no pixels", options.width, options.height));
    if (options.width > limit || options.height > limit)
        throw Error(fmt::format("{}: picture of {}x{}: the device's limit is {}", context_.name(),
                                options.width, options.height, limit));
    if (options.msaa != 1)
        throw UsageError(fmt::format("--msaa {}: this renderer has one sample a pixel", options.msaa));
    pair_counters_ = gpu::Buffer(context_, "pair counters", uint64_t(options.height) * 2 * sizeof(uint32_t),
                                 VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::BufferPlace::readback);
    VkCommandPoolCreateInfo info{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    info.queueFamilyIndex = context_.queue_family();
    VkCommandPool pool = VK_NULL_HANDLE;
    gpu::check(vkCreateCommandPool(context_.device(), &info, nullptr, &pool), "command pool");
    pool_ = {context_.device(), pool};
    context_.set_name(VK_OBJECT_TYPE_COMMAND_POOL, reinterpret_cast<uint64_t>(pool), "frame commands");
}

bool DeviceRenderer::wants(std::string_view view) const {
    return std::find(options_.views.begin(), options_.views.end(), view) != options_.views.end();
}

resident::FrameSettings DeviceRenderer::frame_settings() const {
    return {options_.width, options_.height, std::exp2(options_.exposure)};
}

void DeviceRenderer::set_world(const World& world) {
    world_ = nullptr; // until all of the new one is there
    graph_.reset();   // before what its passes refer to
    frame_ = std::make_unique<resident::Frame>(context_, world, frame_settings());
    build_graph();
    world_ = &world;
}

void DeviceRenderer::set_lights(std::span<const PlacedLight> lights) {
    if (!world_)
        throw Error("renderer: set_world() comes before set_lights()");
    if (frame_->set_lights(lights) && graph_)
        return;
    graph_.reset();
    build_graph();
}

void DeviceRenderer::build_graph() {
    drawn_ = warm_ = false;
    auto graph = std::make_unique<graph::FrameGraph>(context_);
    views_ = build(*graph, *frame_);
    for (const auto& [name, image] : views_)
        graph->keep(image);
    graph->compile();
    graph_ = std::move(graph); // none while one could not be made
}

void DeviceRenderer::submit(VkCommandBuffer commands, const std::function<void()>& record) {
    gpu::check(vkResetCommandPool(context_.device(), pool_, 0), "command pool");
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    gpu::check(vkBeginCommandBuffer(commands, &begin), "frame");
    record();
    gpu::check(vkEndCommandBuffer(commands), "frame");
    context_.submit_and_wait(commands);
}

void DeviceRenderer::clear_pairs() {
    std::fill_n(pair_counters_.mapped<uint32_t>(), size_t(options_.height) * 2, 0u);
}

void DeviceRenderer::render_frame(VkCommandBuffer commands, bool warm_up) {
    clear_pairs();
    submit(commands, [&] {
        if (warm_up)
            graph_->record_warm_up(commands);
        else
            graph_->record(commands);
    });
}

void DeviceRenderer::time_passes(VkCommandBuffer commands, std::vector<std::vector<double>>& times) {
    clear_pairs();
    graph_->record_begin();
    times.resize(graph_->passes());
    for (size_t p = 0; p < times.size(); ++p) {
        const double start = process_ms();
        submit(commands, [&] { graph_->record_pass(commands, p); });
        times[p].push_back(process_ms() - start);
    }
}

void DeviceRenderer::render(const PlacedCamera& camera, uint32_t frames) {
    if (!world_ || !graph_)
        throw Error("renderer: set_world() comes before render()");
    VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocate.commandPool = pool_;
    allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocate.commandBufferCount = 1;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    gpu::check(vkAllocateCommandBuffers(context_.device(), &allocate, &commands), "command buffer");

    if (!warm_) {
        frame_->update(camera);
        render_frame(commands, true);
        warm_ = true;
    }

    std::vector<double> wall, cpu, gpu_total;
    CreatedObjects created; // before the last frame
    std::vector<std::pair<std::string, std::vector<double>>> passes;
    for (uint32_t f = 0; f < frames; ++f) {
        created = created_since(context_, {});
        const double wall_start = wall_ms(), cpu_start = process_ms();
        frame_->update(camera);
        render_frame(commands, false);
        cpu.push_back(process_ms() - cpu_start);
        wall.push_back(wall_ms() - wall_start);
        double total = 0;
        const auto times = graph_->pass_times();
        passes.resize(times.size());
        for (size_t p = 0; p < times.size(); ++p) {
            passes[p].first = times[p].first;
            passes[p].second.push_back(times[p].second);
            total += times[p].second;
        }
        gpu_total.push_back(total);
    }
    created = created_since(context_, created);
    std::vector<std::vector<double>> pass_cpu;
    for (uint32_t f = 0; options_.pass_cpu && f < frames; ++f) {
        frame_->update(camera);
        time_passes(commands, pass_cpu);
    }
    vkFreeCommandBuffers(context_.device(), pool_, 1, &commands);

    stats_ = {};
    stats_.device = context_.name();
    stats_.driver = context_.driver();
    stats_.settings = settings_.all();
    stats_.notes = graph_->notes();
    stats_.lights = frame_->placed_lights().size();
    stats_.triangles = world_->triangles;
    stats_.draws = draws(*frame_);
    stats_.frames = frames;
    stats_.wall_ms = spread(wall);
    stats_.cpu_ms = spread(cpu);
    stats_.gpu_ms = spread(gpu_total);
    for (auto& [name, times] : passes)
        stats_.passes.push_back({name, spread(times)});
    const std::vector<graph::PassTraffic> traffic = graph_->traffic();
    for (size_t p = 0; p < stats_.passes.size(); ++p) {
        stats_.passes[p].bytes_read = traffic[p].bytes_read;
        stats_.passes[p].bytes_written = traffic[p].bytes_written;
        if (options_.pass_cpu)
            stats_.passes[p].cpu_ms = spread(pass_cpu[p]);
    }
    stats_.attachment_bytes = graph_->memory_bytes();
    stats_.attachment_bytes_unshared = graph_->unshared_bytes();
    stats_.device_bytes = context_.device_bytes();
    stats_.device_bytes_peak = context_.device_bytes_peak();
    stats_.created = created;
    count_pairs();
    drawn_ = true;
}

void DeviceRenderer::count_pairs() {
    stats_.pairs_counted = options_.count_pairs;
    if (!options_.count_pairs)
        return;
    const uint32_t* rows = pair_counters_.mapped<uint32_t>();
    for (size_t y = 0; y < options_.height; ++y) {
        stats_.pairs_evaluated += rows[2 * y];
        stats_.pairs_contributing += rows[2 * y + 1];
    }
}

Image DeviceRenderer::read(std::string_view view) {
    if (!drawn_)
        throw Error("renderer: render() comes before read()");
    const auto found = views_.find(view);
    if (found == views_.end())
        throw UsageError(fmt::format("--view {}: was not asked for when the renderer was made", view));
    const graph::ImageDesc& desc = graph_->desc(found->second);
    return unpack(graph_->read_back(found->second), desc.format, desc.extent);
}

} // namespace prelight
