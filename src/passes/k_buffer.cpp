#include "k_buffer.hpp"
#include "blended.hpp"
#include "fullscreen.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <shared/bindings.h>

namespace prelight::passes {

KBuffer::KBuffer(graph::FrameGraph& graph, const resident::View& view, const std::string& name, graph::ImageId opaque,
                 uint32_t count)
    : count_(count), samples_(graph.raster(opaque).samples) {
    const gpu::Raster raster = graph.raster(opaque);
    const uint64_t slot_bytes = uint64_t(raster.extent.width) * raster.extent.height * samples_ * sizeof(uint32_t);
    const uint64_t room = view.context().limits().maxStorageBufferRange / slot_bytes;
    if (room == 0)
        throw Error(fmt::format("{}: layers of {}x{} pixels need buffers of {} bytes, and the device's limit is {}",
                                view.context().name(), raster.extent.width, raster.extent.height, slot_bytes,
                                view.context().limits().maxStorageBufferRange));
    if (room < count_)
        graph.note(
            fmt::format("{}: a buffer holds {} layers of each sample, not {}", view.context().name(), room, count_));
    count_ = static_cast<uint32_t>(std::min<uint64_t>(room, count_));
    buffer_ = std::make_shared<gpu::Buffer>(view.context(), "k-buffer", slot_bytes * count_,
                                            VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                            gpu::BufferPlace::device);
    slots_ = graph.buffer("k-buffer", *buffer_);
    depth_ = graph.image("layer depth", {VK_FORMAT_D32_SFLOAT, raster});
    graph.pass(name + " none").copy_to(slots_).record([buffer = buffer_](const graph::PassContext& context) {
        vkCmdFillBuffer(context.commands, buffer->handle(), 0, VK_WHOLE_SIZE, 0);
    });
    graph::Pass& pass = graph.pass(name);
    pass.depth_test(opaque).storage(INPUT_K_BUFFER, slots_, true);
    draw_blended(pass, view,
                 {.name = "k-buffer",
                  .fragment = "k_buffer.frag",
                  .constants = constants(),
                  .depth = gpu::DepthTest::behind_or_at,
                  .sample_shading = gpu::SampleShading::sample,
                  .positions_only = true,
                  .draws = resident::DrawClass::blended});
}

graph::ImageId KBuffer::depth(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                              uint32_t slot) {
    graph::Pass& pass = graph.pass(name);
    pass.depth_write(depth_, graph::Load::discard);
    declare(pass);
    gpu::Constants all = constants();
    all.emplace_back(CONSTANT_K_BUFFER_SLOT, slot);
    draw_fullscreen(pass, view, "k_buffer_depth.frag", all, gpu::Blend::none, gpu::DepthTest::overwrite);
    return depth_;
}

void KBuffer::declare(graph::Pass& pass) const { pass.storage(INPUT_K_BUFFER, slots_, false); }

gpu::Constants KBuffer::constants() const { return {{CONSTANT_K_BUFFER_SLOTS, count_}, {CONSTANT_SAMPLES, samples_}}; }

} // namespace prelight::passes
