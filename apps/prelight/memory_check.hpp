#pragma once
#include <cstdint>
#include <prelight/device.hpp>
#include <prelight/renderer.hpp>
#include <prelight/scene.hpp>
#include <string>

namespace prelight::app {

/// Throws Error when `bytes` for `what` (and `reserved` of address space) are more than one of the rooms has: a driver
/// that runs out of memory does not always say so.
void check_memory(const std::string& what, uint64_t bytes, uint64_t reserved);

/// Whether there is memory for the images of such a frame, and for as much beside them.
bool fits_frame(uint32_t width, uint32_t height, uint32_t msaa);

/// Opens the device for frames as these options have them, if there is memory for it; starts the watchdog.
std::unique_ptr<Device> open_device(const DeviceOptions& options, uint32_t width, uint32_t height, uint32_t msaa = 1);
/// What the scene takes on a device. Throws Error when there is not so much.
void check_memory_for(const Scene& scene);

} // namespace prelight::app
