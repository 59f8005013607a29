#include <fmt/format.h>
#include <image/display_bytes.hpp>
#include <image/png_reader.hpp>
#include <image/png_writer.hpp>
#include <platform/atomic_file.hpp>
#include <platform/read_file.hpp>
#include <platform/spare_memory.hpp>
#include <prelight/error.hpp>
#include <prelight/image.hpp>

namespace prelight {
namespace {

Image decode(std::span<const uint8_t> bytes) {
    PngReader reader(bytes);
    if (reader.sixteen_bits())
        throw DecodeError("16 bits a channel, 8 are wanted");
    const uint64_t pixels = uint64_t(reader.width()) * reader.height();
    if (pixels * (sizeof(glm::vec3) + (reader.interlaced() ? 4 : 0)) > spare_memory())
        throw DecodeError(
            fmt::format("{} × {} pixels need more memory than there is", reader.width(), reader.height()));
    Image image(reader.width(), reader.height());
    const size_t row_bytes = size_t(reader.width()) * 4;
    std::vector<uint8_t> rows(row_bytes * (reader.interlaced() ? reader.height() : 1));
    if (reader.interlaced())
        reader.read_all(rows.data());
    for (uint32_t y = 0; y < reader.height(); ++y) {
        if (!reader.interlaced())
            reader.read_row(rows.data());
        const uint8_t* row = rows.data() + (reader.interlaced() ? y * row_bytes : 0);
        for (uint32_t x = 0; x < reader.width(); ++x)
            for (int channel = 0; channel < 3; ++channel)
                image.at(x, y)[channel] = static_cast<float>(row[4 * size_t(x) + static_cast<size_t>(channel)]) / 255;
    }
    return image;
}

} // namespace

void save_png(const Image& display, const std::filesystem::path& path) {
    AtomicFile file(path);
    if (display.width == 0 || display.height == 0)
        throw Error(fmt::format("{}: a picture of {}x{} pixels cannot be written", path.string(), display.width,
                                display.height));
    file.write(encode_png(display.width, display.height, 3, display_bytes(display)));
    file.commit();
}

Image load_png(const std::filesystem::path& path) {
    const FileBytes bytes = read_file(path, largest_file::picture);
    try {
        return decode(bytes);
    } catch (const DecodeError& error) {
        throw Error(fmt::format("{}: not a readable PNG ({})", path.string(), error.what()));
    }
}

} // namespace prelight
