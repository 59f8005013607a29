#include "memory_check.hpp"

#include <platform/program/watchdog.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <platform/spare_memory.hpp>
#include <prelight/error.hpp>

namespace prelight::app {
namespace {

constexpr uint64_t mebi = 1 << 20;
/// A software device with its compiler, measured with a frame of 64x36: what it writes to, and what it reserves.
constexpr uint64_t driver_bytes = 90 * mebi, driver_reserves = 330 * mebi;
/// Images of a frame with those that the host reads, a pixel and sample (1280x720 to 3840x2160).
constexpr uint64_t bytes_per_sample = 48;

std::string in_mebi(uint64_t bytes) { return fmt::format("{} MiB", (bytes + mebi / 2) / mebi); }

template <class T>
uint64_t size_of(const std::vector<T>& values) {
    return values.size() * sizeof(T);
}

/// Beyond the largest a renderer says what its limit is.
uint64_t image_bytes(uint32_t width, uint32_t height, uint32_t msaa) {
    const uint64_t frame = uint64_t(width) * height;
    constexpr uint64_t largest = uint64_t(1) << 32;
    return frame <= largest ? frame * msaa * bytes_per_sample : 0;
}

} // namespace

bool fits_frame(uint32_t width, uint32_t height, uint32_t msaa) {
    return 2 * image_bytes(width, height, msaa) <= spare_memory();
}

void check_memory(const std::string& what, uint64_t bytes, uint64_t reserved) {
    for (const MemoryRoom& room : memory_rooms())
        if (const uint64_t wanted = room.reserved ? std::max(bytes, reserved) : bytes; room.bytes < wanted)
            throw Error(fmt::format("out of memory: {} needs about {}{}, {} leaves {}", what, in_mebi(wanted),
                                    room.reserved ? " of address space" : "", room.limit, in_mebi(room.bytes)));
}

std::unique_ptr<Device> open_device(const DeviceOptions& options, uint32_t width, uint32_t height, uint32_t msaa) {
    const uint64_t images = image_bytes(width, height, msaa);
    check_memory(fmt::format("a frame of {}x{}", width, height), driver_bytes + images, driver_reserves + images);
    start_watchdog();
    return Device::create(options);
}

void check_memory_for(const Scene& scene) {
    uint64_t bytes = 0;
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& primitive : mesh.primitives)
            bytes += size_of(primitive.positions) + size_of(primitive.normals) + size_of(primitive.indices) +
                     size_of(primitive.tangents) + size_of(primitive.texcoords[0]) + size_of(primitive.texcoords[1]);
    for (const auto& image : scene.images)
        bytes += size_of(image.rgba) / 3 * 4; // with its mip levels
    check_memory(fmt::format("{} on the device", scene.name), bytes, bytes);
}

} // namespace prelight::app
