#include "layer_counter.hpp"
#include "blended.hpp"
#include <algorithm>
#include <gpu/compute_pipeline.hpp>
#include <shared/bindings.h>
#include <shared/layer_counts.h>

namespace prelight::passes {
namespace {

double number_of(uint32_t low, uint32_t high) { return static_cast<double>((uint64_t(high) << 32) + low); }

} // namespace

graph::ImageId layer_count_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                                graph::ImageId depth) {
    // Half floats count to 2,048.
    const graph::ImageId image = graph.image("layers", view.surface_raster(), {VK_FORMAT_R16_SFLOAT});
    graph::Pass& pass = graph.pass(name);
    pass.colour(image, graph::Load::clear).blends().depth_test(depth);
    draw_blended(pass, view,
                 {.name = "layer count",
                  .fragment = "layer_count.frag",
                  .constants = {},
                  .depth = gpu::DepthTest::behind_or_at,
                  .blend = gpu::Blend::add,
                  .positions_only = true,
                  .draws = resident::DrawClass::blended});
    return image;
}

LayerCounter::LayerCounter(const gpu::Context& context) {
    for (gpu::Buffer& one : counts_)
        one = gpu::Buffer(context, "layer counts", sizeof(shared::LayerCounts), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                          gpu::BufferPlace::readback);
    forget();
}

void LayerCounter::count(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                         graph::ImageId image, uint32_t exact) {
    raster_ = graph.raster(image);
    graph.before_frame([this](const gpu::FrameTurn& turn) {
        slot_ = turn.slot;
        *counts_[slot_].mapped<shared::LayerCounts>() = {};
    });
    graph::Pass& pass = graph.pass(name);
    pass.raster(raster_)
        .sample(INPUT_COLOUR, image)
        .storage(INPUT_LAYER_COUNTS, graph.buffer("layer counts", counts_), true);
    const bool samples = raster_.samples > 1;
    auto pipeline = std::make_shared<gpu::ComputePipeline>();
    pass.prepare([=, &view, count = raster_.samples](const graph::PassInterface& interface) {
        *pipeline = gpu::ComputePipeline(view.context(),
                                         {.name = "layer counts",
                                          .shader = {"layer_counts.comp", gpu::when(samples, gpu::Variant::samples)},
                                          .constants = {{CONSTANT_SAMPLES, count}},
                                          .sets = {view.layout(), interface.inputs},
                                          .push_bytes = sizeof(shared::LayerCounting)});
    });
    pass.record([=, &view, extent = raster_.extent](const graph::PassContext& context) {
        pipeline->bind(context.commands);
        pipeline->bind_set(context.commands, SET_FRAME, view.set());
        pipeline->bind_set(context.commands, SET_INPUTS, context.inputs);
        // Warming up draws a pixel, and the others hold anything.
        const glm::uvec2 size = context.one_pixel ? glm::uvec2(0) : glm::uvec2(extent.width, extent.height);
        const shared::LayerCounting counting{size, exact};
        pipeline->push(context.commands, std::as_bytes(std::span(&counting, 1)));
        constexpr uint32_t side = LAYER_COUNT_GROUP * LAYER_COUNT_BLOCK;
        vkCmdDispatch(context.commands, std::max((size.x + side - 1) / side, 1u),
                      std::max((size.y + side - 1) / side, 1u), 1);
    });
}

uint32_t LayerCounter::most(uint32_t slot) const { return counts_[slot].mapped<const shared::LayerCounts>()->most; }

uint32_t LayerCounter::most() const {
    uint32_t most = 0;
    for (uint32_t slot = 0; slot < gpu::frames_in_flight; ++slot)
        most = std::max(most, this->most(slot));
    return most;
}

void LayerCounter::forget() {
    for (gpu::Buffer& one : counts_)
        *one.mapped<shared::LayerCounts>() = {};
}

LayerCounter::Sums LayerCounter::last() const {
    const auto& counts = *counts_[slot_].mapped<const shared::LayerCounts>();
    const double samples = raster_.samples;
    return {.most = counts.most,
            .mean = number_of(counts.total_low, counts.total_high) /
                    (samples * raster_.extent.width * raster_.extent.height),
            .more = number_of(counts.more_low, counts.more_high) / samples};
}

} // namespace prelight::passes
