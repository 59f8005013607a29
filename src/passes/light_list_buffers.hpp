#pragma once
#include "light_grid.hpp"
#include "light_rounds.hpp"
#include <algorithm>
#include <gpu/buffer.hpp>
#include <gpu/frames_in_flight.hpp>
#include <memory>
#include <optional>
#include <resident/view.hpp>
#include <shared/light_lists.h>

namespace prelight::passes {

/// What light lists lie in, and what of it changes from frame to frame. The room for lists begins as a guess and
/// grows to what the frames before needed.
class ListBuffers {
public:
    /// `first_room`: room for lists in the first frame, in lights; 0: a guess. Throws Error when a buffer of a
    /// fixed size would be larger than the device allows.
    ListBuffers(const resident::View& view, const shared::LightListConstants& layout, const LightGrid& grid,
                uint64_t first_room, const LightRounds& rounds, uint32_t round);

    /// Before each frame: the buffer whose place another one took as `entries`, if so.
    std::optional<gpu::Buffer> update(const gpu::FrameTurn& turn);
    std::shared_ptr<const shared::LightListConstants> constants() const { return constants_; }

private:
    uint64_t first_guess() const;
    uint64_t all_lights() const { return std::min<uint64_t>(view_.lights().capacity(), rounds_.lights); }
    uint64_t most_entries() const { return view_.context().limits().maxStorageBufferRange / sizeof(uint32_t); }
    void make_entries(uint64_t count);
    void grow(uint64_t count);

    const resident::View& view_;
    LightGrid grid_;
    LightRounds rounds_;
    uint32_t round_;
    bool full_ = false;
    std::optional<gpu::Buffer> outgrown_;
    bool guesses_;
    uint32_t listed_ = 0; ///< lights of the last frame's lists
    std::shared_ptr<shared::LightListConstants> constants_;

public:
    gpu::Buffer cells, coarse, masks, slices, entries;
    gpu::PerFrame<gpu::Buffer> total; ///< read by the host when its frame is done
};

} // namespace prelight::passes
