#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <image/atomic_file.hpp>
#include <iterator>
#include <memory>
#include <prelight/error.hpp>
#include <prelight/image.hpp>

// Static: another library of this program may hold its own copy of stb.
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 65536
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace prelight {
namespace {

uint8_t to_byte(float value) {
    if (!(value > 0)) // also NaN, whose cast to an integer would be undefined
        return 0;
    return value >= 1 ? 255 : static_cast<uint8_t>(std::lround(value * 255));
}

void write_to(void* file, void* data, int size) {
    static_cast<AtomicFile*>(file)->write(data, static_cast<size_t>(size));
}

} // namespace

void save_png(const Image& display, const std::filesystem::path& path) {
    AtomicFile file(path);
    if (display.width == 0 || display.height == 0)
        throw Error(fmt::format("{}: a picture of {}x{} pixels cannot be written", path.string(),
                                display.width, display.height));
    std::vector<uint8_t> bytes;
    bytes.reserve(display.pixels.size() * 3);
    for (const glm::vec3& pixel : display.pixels)
        for (int channel = 0; channel < 3; ++channel)
            bytes.push_back(to_byte(pixel[channel]));
    if (!stbi_write_png_to_func(write_to, &file, static_cast<int>(display.width),
                                static_cast<int>(display.height), 3, bytes.data(), 0))
        throw Error(fmt::format("{}: the picture cannot be encoded as PNG", path.string()));
    file.commit();
}

Image load_png(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream)
        throw Error(fmt::format("{}: cannot be opened", path.string()));
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(std::min<size_t>(bytes.size(), 0x7fffffff));
    if (stbi_is_16_bit_from_memory(data, size))
        throw Error(fmt::format("{}: PNG of 16 bits a channel, 8 are wanted", path.string()));
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> decoded(
        stbi_load_from_memory(data, size, &width, &height, &channels, 3), stbi_image_free);
    if (!decoded)
        throw Error(
            fmt::format("{}: not a readable PNG ({})", path.string(), stbi_failure_reason()));
    Image image(static_cast<uint32_t>(width), static_cast<uint32_t>(height));
    for (size_t i = 0; i < image.pixels.size(); ++i)
        for (int channel = 0; channel < 3; ++channel)
            image.pixels[i][channel] =
                static_cast<float>(decoded.get()[i * 3 + static_cast<size_t>(channel)]) / 255;
    return image;
}

} // namespace prelight
