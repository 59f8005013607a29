#pragma once
#include <array>
#include <cstdint>

namespace prelight::gpu {

/// Frames that may be in flight at once: the host prepares one while the device works on another.
/// What the host writes or reads each frame exists as often, and the frames take turns.
inline constexpr uint32_t frames_in_flight = 2;

template <class T>
using PerFrame = std::array<T, frames_in_flight>;

/// Which copy a frame uses, and what is known of the frames before it.
struct FrameTurn {
    uint32_t slot = 0; ///< < frames_in_flight; the frame that had it last is done
    bool alone = true; ///< every frame before is done
};

} // namespace prelight::gpu
