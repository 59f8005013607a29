#pragma once
#include <prelight/camera.hpp>
#include <shared/frame.h>

namespace prelight::resident {

/// Fills the camera's part of the frame constants for a picture of width × height pixels: reversed
/// depth (near 1, far 0), +Y of clip space downwards, world space relative to the camera.
/// The previous state (PlacedCamera::previous) is seen with the same projection.
void fill_camera(shared::FrameConstants& constants, const PlacedCamera& camera, uint32_t width, uint32_t height);

} // namespace prelight::resident
