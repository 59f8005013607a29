#include <algorithm>
#include <array>
#include <cstring>
#include <image/png_filter.hpp>
#include <image/png_writer.hpp>
#include <libdeflate.h>
#include <memory>
#include <new>
#include <parallel/parallel_for.hpp>
#include <stdexcept>
#include <string_view>

namespace prelight {
namespace {

/// libdeflate's fastest: files a few percent larger than zlib makes them in ten times the time.
constexpr int compression = 1;
constexpr size_t band_bytes = size_t(1) << 18; ///< of rows that one thread filters at once
constexpr size_t largest_chunk = 0x7fffffff;
constexpr std::array<uint8_t, 5> colour_types{0, 0, 4, 2, 6}; ///< by channels

void put(std::vector<std::byte>& out, uint32_t big_endian) {
    for (int shift = 24; shift >= 0; shift -= 8)
        out.push_back(static_cast<std::byte>(big_endian >> shift & 0xff));
}

void put_chunk(std::vector<std::byte>& out, std::string_view type, std::span<const std::byte> data) {
    put(out, static_cast<uint32_t>(data.size()));
    const size_t begin = out.size();
    const auto name = std::as_bytes(std::span(type));
    out.insert(out.end(), name.begin(), name.end());
    out.insert(out.end(), data.begin(), data.end());
    put(out, libdeflate_crc32(0, out.data() + begin, out.size() - begin));
}

/// Each row behind its filter's number.
std::vector<uint8_t> filter_rows(size_t row_bytes, uint32_t height, uint32_t channels,
                                 std::span<const uint8_t> pixels) {
    std::vector<uint8_t> filtered((row_bytes + 1) * height);
    const std::vector<uint8_t> zeros(row_bytes);
    const auto rows = static_cast<uint32_t>(std::clamp<size_t>(band_bytes / row_bytes, 1, height));
    parallel_for((height + rows - 1) / rows, [&](uint32_t band) {
        PngRowFilter filter(channels);
        for (uint32_t y = band * rows; y < std::min((band + 1) * rows, height); ++y)
            filter(pixels.subspan(y * row_bytes, row_bytes),
                   y == 0 ? std::span<const uint8_t>(zeros) : pixels.subspan((y - 1) * row_bytes, row_bytes),
                   std::span(filtered).subspan(y * (row_bytes + 1), row_bytes + 1));
    });
    return filtered;
}

std::vector<std::byte> compress(std::span<const uint8_t> bytes) {
    const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
        libdeflate_alloc_compressor(compression), libdeflate_free_compressor);
    if (!compressor)
        throw std::bad_alloc();
    std::vector<std::byte> packed(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()));
    packed.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), packed.data(), packed.size()));
    return packed;
}

} // namespace

std::vector<std::byte> encode_png(uint32_t width, uint32_t height, uint32_t channels, std::span<const uint8_t> pixels) {
    if (channels < 1 || channels > 4 || pixels.empty() || pixels.size() != uint64_t(width) * height * channels)
        throw std::invalid_argument("encode_png: the pixels do not fit the size");
    const std::vector<std::byte> packed = compress(filter_rows(size_t(width) * channels, height, channels, pixels));
    constexpr std::array<uint8_t, 8> signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    std::vector<std::byte> header, out;
    put(header, width);
    put(header, height);
    for (const int byte : {8, int(colour_types[channels]), 0, 0, 0}) // bits, colour, deflate, filters, no interlacing
        header.push_back(static_cast<std::byte>(byte));
    out.reserve(packed.size() + 128);
    for (const uint8_t byte : signature)
        out.push_back(static_cast<std::byte>(byte));
    put_chunk(out, "IHDR", header);
    for (size_t at = 0; at < packed.size(); at += largest_chunk)
        put_chunk(out, "IDAT", std::span(packed).subspan(at, std::min(largest_chunk, packed.size() - at)));
    put_chunk(out, "IEND", {});
    return out;
}

} // namespace prelight
