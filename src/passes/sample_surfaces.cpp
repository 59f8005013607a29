#include "sample_surfaces.hpp"
#include "fullscreen.hpp"
#include <algorithm>
#include <gpu/compute_pipeline.hpp>
#include <shared/bindings.h>
#include <shared/light_lists.h>
#include <utility>

namespace prelight::passes {
namespace {

uint32_t blocks_along(uint32_t pixels) { return (pixels + LIT_BLOCK - 1) / LIT_BLOCK; }

/// One surface a pixel, and in `edges` whether it is one of several.
SurfaceBuffers resolve_surfaces(graph::FrameGraph& graph, const resident::View& view, const SurfaceBuffers& surface,
                                graph::ImageId edges, bool every_pixel, GBufferColours* colours) {
    SurfaceBuffers out{surface.format};
    out.depth = out.depth_source = make_depth(graph, view.raster(), surface.format.stencil);
    const auto like = [&](const char* name, graph::ImageId image) {
        return graph.image(name, {graph.desc(image).format, view.raster()});
    };
    out.normal = out.roughness = like("pixel normal", surface.normal);
    graph::Pass& pass = graph.pass("sample-surfaces");
    pass.depth_write(out.depth).colour(out.normal, graph::Load::discard).colour(edges, graph::Load::discard);
    const bool apart = surface.roughness != surface.normal;
    if (apart)
        pass.colour(out.roughness = like("pixel roughness", surface.roughness), graph::Load::discard);
    if (colours) {
        const GBufferColours drawn = *colours;
        *colours = {like("pixel light", drawn.light), like("pixel motion", drawn.material),
                    like("pixel albedo", drawn.albedo)};
        pass.sample(INPUT_COLOUR_BEFORE, drawn.light)
            .sample(INPUT_MATERIAL, drawn.material)
            .sample(INPUT_ALBEDO, drawn.albedo);
        for (const graph::ImageId image : {colours->light, colours->material, colours->albedo})
            pass.colour(image, graph::Load::discard);
    }
    pass.sample(INPUT_DEPTH, surface.depth_source)
        .sample(INPUT_NORMAL, surface.normal)
        .sample(INPUT_ROUGHNESS, surface.roughness);
    gpu::Constants constants = surface.format.constants();
    constants.insert(constants.end(),
                     {{CONSTANT_SAMPLES, graph.raster(surface.depth).samples}, {CONSTANT_EVERY_EDGE, every_pixel}});
    draw_fullscreen(pass, view,
                    {"sample_surfaces.frag", gpu::when(apart, gpu::Variant::roughness_target) |
                                                 gpu::when(colours, gpu::Variant::deferred_target)},
                    constants, gpu::Blend::none, gpu::DepthTest::overwrite);
    return out;
}

/// A sample light buffer for so many tiles: as wide as the picture, unless that were higher than an image may be.
SampleEdges room_for(const resident::View& view, uint32_t tiles) {
    const uint32_t most_rows = view.context().limits().maxImageDimension2D / EDGE_TILE_ROWS;
    SampleEdges edges{.row = std::max(blocks_along(view.raster().extent.width), (tiles + most_rows - 1) / most_rows)};
    const uint32_t rows = (tiles + edges.row - 1) / edges.row;
    edges.raster = {{edges.row * LIT_BLOCK, rows * EDGE_TILE_ROWS}};
    edges.tile_count = rows * edges.row;
    return edges;
}

} // namespace

gpu::Constants SampleEdges::constants() const {
    return {{CONSTANT_SAMPLES, samples},
            {CONSTANT_EDGE_TILES, tile_count},
            {CONSTANT_EDGE_ROW, row},
            {CONSTANT_EDGE_FIRST_ROW, first_row},
            {CONSTANT_EVERY_EDGE, every_sample}};
}

void SampleEdges::lay_beneath(const resident::View& view) {
    first_row = view.raster().extent.height;
    const VkExtent2D extent = whole_raster(view).extent;
    if (std::max(extent.width, extent.height) > view.context().limits().maxImageDimension2D)
        first_row = 0;
}

gpu::Raster SampleEdges::whole_raster(const resident::View& view) const {
    return {{std::max(view.raster().extent.width, raster.extent.width), first_row + raster.extent.height}};
}

EdgeCounter::EdgeCounter(const gpu::Context& context) {
    for (gpu::Buffer& one : counts_) {
        one = gpu::Buffer(context, "edge tile count", sizeof(uint32_t),
                          VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                          gpu::BufferPlace::readback);
        *one.mapped<uint32_t>() = 0;
    }
}

uint32_t EdgeCounter::room(uint32_t all) {
    for (uint32_t slot = 0; slot < gpu::frames_in_flight; ++slot)
        take(slot); // of the graph before, whose pictures may have been of another size
    if (all_ > 0)
        needed_ = static_cast<uint32_t>((uint64_t(needed_) * all + all_ - 1) / all_);
    all_ = all;
    const uint32_t guess = all / 8; // two surfaces in a quarter of the pixels
    return std::clamp(needed_ > 0 ? needed_ + needed_ / 4 : guess, std::min(64u, all), all); // more, for cameras move
}

bool EdgeCounter::take(uint32_t slot) {
    if (std::exchange(warming_, false))
        for (const gpu::Buffer& one : counts_)
            *one.mapped<uint32_t>() = 0;
    const uint32_t counted = std::exchange(*counts_[slot].mapped<uint32_t>(), 0u);
    needed_ = std::max(needed_, counted);
    return counted > room_;
}

SampledSurfaces sampled_surfaces(graph::FrameGraph& graph, const resident::View& view, const SurfaceBuffers& surface,
                                 SampleLight light, EdgeCounter& counter, GBufferColours* colours) {
    const uint32_t samples = graph.raster(surface.depth).samples;
    if (light == SampleLight::pixel) {
        const graph::ImageId flags = graph.image("edges", {VK_FORMAT_R16_UINT, view.raster()});
        return {surface, resolve_surfaces(graph, view, surface, flags, false, colours), {}};
    }
    const auto [width, height] = view.raster().extent;
    const uint32_t across = blocks_along(width), down = blocks_along(height);
    const uint32_t all = across * down * samples * LIT_BLOCK / EDGE_TILE_ROWS, guess = counter.room(all);
    SampleEdges edges = room_for(view, light == SampleLight::samples ? all : guess);
    edges.samples = samples;
    edges.every_sample = light == SampleLight::samples;
    counter.room_ = edges.tile_count;
    // Slots lie beside the flags, so that a material has both by one fetch. In formats that every device stores.
    const bool wide = edges.tile_count * (LIT_BLOCK * EDGE_TILE_ROWS) >= 1u << (32 - EDGE_BITS);
    const graph::ImageId flags =
        graph.image("edges", {wide ? VK_FORMAT_R32G32B32A32_UINT : VK_FORMAT_R32_UINT, view.raster()});
    edges.flags = flags;
    SampledSurfaces out{surface, resolve_surfaces(graph, view, surface, flags, edges.every_sample, colours), {}};
    const auto make = [&](const char* name, uint64_t words, VkBufferUsageFlags more) {
        return std::make_shared<gpu::Buffer>(view.context(), name, words * sizeof(uint32_t),
                                             VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | more, gpu::BufferPlace::device);
    };
    constexpr uint64_t head = sizeof(shared::LitBlocks) / sizeof(uint32_t);
    const auto tiles = make("edge tiles", head + edges.tile_count,
                            VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    const auto pixels = make("edge pixels", uint64_t(edges.tile_count) * (LIT_BLOCK * EDGE_TILE_ROWS), 0);
    edges.tile_buffer = tiles;
    edges.tiles = graph.buffer("edge tiles", *tiles);
    edges.pixels = graph.buffer("edge pixels", *pixels);

    const shared::LitBlocks none[2]{{{LIT_ROW, 0, 1, 0}}, {}};
    const auto empty = std::make_shared<gpu::Buffer>(gpu::make_device_buffer(
        view.context(), "no edge tiles", std::as_bytes(std::span(none)), VK_BUFFER_USAGE_TRANSFER_SRC_BIT));
    const graph::BufferId counts = graph.buffer("edge tile count", counter.counts_);
    graph.pass("sample-edges none")
        .copy_to(edges.tiles)
        .copy_to(counts)
        .record([=, &counter](const graph::PassContext& context) {
            const VkBufferCopy whole{0, 0, sizeof(shared::LitBlocks)};
            vkCmdCopyBuffer(context.commands, empty->handle(), tiles->handle(), 1, &whole);
            const VkBufferCopy zero{sizeof(shared::LitBlocks), 0, sizeof(uint32_t)};
            vkCmdCopyBuffer(context.commands, empty->handle(), counter.counts_[context.slot].handle(), 1, &zero);
        });
    graph::Pass& pass = graph.pass("sample-edges");
    pass.raster(view.raster())
        .sample(INPUT_EDGES, flags)
        .store(INPUT_EDGE_TARGET, flags)
        .storage(INPUT_LIT_BLOCKS, edges.tiles, true)
        .storage(INPUT_EDGE_PIXELS, edges.pixels, true)
        .storage(INPUT_EDGE_COUNTS, counts, true);
    auto pipeline = std::make_shared<gpu::ComputePipeline>();
    pass.prepare([=, &view, constants = edges.constants()](const graph::PassInterface& interface) {
        *pipeline = gpu::ComputePipeline(view.context(),
                                         {.name = "sample edges",
                                          .shader = {"sample_edges.comp", gpu::when(wide, gpu::Variant::wide_slots)},
                                          .constants = constants,
                                          .sets = {view.layout(), interface.inputs}});
    });
    pass.record([=, &view, warming = &counter.warming_,
                 kept = std::pair(tiles, pixels)](const graph::PassContext& context) { // as long as the graph
        pipeline->bind(context.commands);
        pipeline->bind_set(context.commands, SET_FRAME, view.set());
        pipeline->bind_set(context.commands, SET_INPUTS, context.inputs);
        // Warming up draws a pixel, and the others' flags are anything: what they add up to is not to be counted.
        *warming = *warming || context.one_pixel;
        vkCmdDispatch(context.commands, context.one_pixel ? 1 : (across * down + LIST_GROUP - 1) / LIST_GROUP, 1, 1);
    });
    out.edges = edges;
    return out;
}

} // namespace prelight::passes
