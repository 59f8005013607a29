#include "light_list_buffers.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <utility>

namespace prelight::passes {
namespace {

gpu::Buffer make_storage(const resident::View& view, const char* name, uint64_t size,
                         gpu::BufferPlace place = gpu::BufferPlace::device) {
    const uint64_t limit = view.context().limits().maxStorageBufferRange;
    if (size > limit)
        throw Error(fmt::format("{}: {} for {} lights and {}x{} pixels need {} bytes, and the device's limit is {}",
                                view.context().name(), name, view.lights().capacity(), view.raster().extent.width,
                                view.raster().extent.height, size, limit));
    return gpu::Buffer(view.context(), name, size, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, place);
}

} // namespace

ListBuffers::ListBuffers(const resident::View& view, const shared::LightListConstants& layout, const LightGrid& grid,
                         uint64_t first_room, const LightRounds& rounds, uint32_t round)
    : view_(view), grid_(grid), rounds_(rounds), round_(round), guesses_(first_room == 0),
      constants_(std::make_shared<shared::LightListConstants>(layout)),
      cells(make_storage(view, "light cells", uint64_t(layout.cells.w) * sizeof(shared::LightCell))),
      coarse(make_storage(view, "coarse light cells", uint64_t(layout.coarse.w) * sizeof(shared::LightCell))),
      masks(make_storage(view, "light masks", uint64_t(layout.coarse.w) * layout.lights.w * sizeof(uint32_t))),
      slices(make_storage(view, "depth slices", (LIST_SLICES + 1) * sizeof(float))) {
    for (gpu::Buffer& one : total) {
        one = make_storage(view, "light list total", sizeof(uint32_t), gpu::BufferPlace::readback);
        *one.mapped<uint32_t>() = 0;
    }
    make_entries(all_lights() + first_room);
}

std::optional<gpu::Buffer> ListBuffers::update(const gpu::FrameTurn& turn) {
    uint64_t needed = 0; // by the frames that are done
    for (uint32_t slot = 0; slot < gpu::frames_in_flight; ++slot)
        if (turn.alone || slot == turn.slot)
            needed = std::max<uint64_t>(needed, *total[slot].mapped<uint32_t>());
    // The first frame has no other to learn from, and neither has one with other lights.
    const RoundLights lights = lights_of_round(view_, rounds_, round_);
    if (guesses_ && std::exchange(listed_, lights.listed) != lights.listed)
        needed = std::max(needed, std::min<uint64_t>(first_guess(), most_entries()));
    const bool grows = needed > constants_->lights.z && constants_->lights.z < most_entries();
    if (grows && !full_)
        grow(needed + needed / 4);
    if (grid_.cells.x > 0)
        stretch(grid_, box_of(grid_.over, view_.scene())); // which grows where things move
    constants_->grid_origin = glm::vec4(grid_.low - view_.eye(), 0);
    constants_->grid_cell = glm::vec4(grid_.cell, 0);
    constants_->lights.x = lights.everywhere;
    constants_->lights.y = lights.listed;
    const bool none = lights.everywhere + lights.listed == 0; // then shaders may look at what stands first
    constants_->round = {none ? 0 : lights.first, rounds_.turns, round_, 0};
    return std::exchange(outgrown_, std::nullopt);
}

uint64_t ListBuffers::first_guess() const {
    const double overlap = grid_.cells.x > 0 ? grid_overlap(grid_, view_.lights().placed())
                                             : 1.5 * view_.light_groups().listed_pictures * constants_->cells.w;
    constexpr double most_guessed = 1 << 24; // 64 MiB; what is really needed is known a frame later
    return static_cast<uint64_t>(std::min(overlap, most_guessed)) + 2 * uint64_t(constants_->cells.w) +
           16 * all_lights();
}

void ListBuffers::make_entries(uint64_t count) {
    const uint64_t size = std::clamp<uint64_t>(count, all_lights() + 1, std::max(most_entries(), all_lights() + 1));
    const uint64_t vectors = (size + 3) / 4; // reaching_lights.glsl reads four at once
    entries = make_storage(view_, "light lists", vectors * 4 * sizeof(uint32_t));
    constants_->lights.z = static_cast<uint32_t>(std::min<uint64_t>(size, 0xffffffffu));
}

/// A device without room keeps the lists it has: what does not fit walks all lights.
void ListBuffers::grow(uint64_t count) {
    gpu::Buffer old = std::exchange(entries, gpu::Buffer());
    try {
        make_entries(count);
        outgrown_ = std::move(old);
    } catch (const Error&) {
        entries = std::move(old);
        full_ = true;
    }
}

} // namespace prelight::passes
