#include <algorithm>
#include <image/display_bytes.hpp>
#include <image/unorm_byte.hpp>
#include <parallel/parallel_for.hpp>

namespace prelight {

std::vector<uint8_t> display_bytes(const Image& display) {
    std::vector<uint8_t> bytes(display.pixels.size() * 3);
    constexpr size_t part = size_t(1) << 16; // pixels that one thread takes at once
    const size_t count = display.pixels.size();
    parallel_for(static_cast<uint32_t>((count + part - 1) / part), [&](uint32_t i) {
        for (size_t pixel = i * part; pixel < std::min((i + 1) * part, count); ++pixel)
            for (int channel = 0; channel < 3; ++channel)
                bytes[3 * pixel + static_cast<size_t>(channel)] = unorm_byte(display.pixels[pixel][channel]);
    });
    return bytes;
}

} // namespace prelight
