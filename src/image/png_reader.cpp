#include <algorithm>
#include <array>
#include <cstring>
#include <fmt/format.h>
#include <image/png_reader.hpp>
#include <new>
#include <spng.h>
#include <string_view>

namespace prelight {
namespace {

constexpr size_t signature_size = 8, chunk_overhead = 12;
constexpr size_t header_at = 12, width_at = 16, height_at = 20, colour_type_at = 25; ///< in the file
constexpr auto working_constant = uint64_t(1) << 20;                                 ///< zlib's window, libspng's rows

uint32_t big_endian(const uint8_t* bytes) {
    return uint32_t(bytes[0]) << 24 | uint32_t(bytes[1]) << 16 | uint32_t(bytes[2]) << 8 | bytes[3];
}

DecodeError damaged(const char* reason) { return DecodeError(fmt::format("does not decode (PNG: {})", reason)); }

} // namespace

void check_picture_size(uint64_t width, uint64_t height) {
    if (width == 0 || height == 0)
        throw DecodeError("has no pixels");
    if (width > max_picture_side || height > max_picture_side || width * height > max_picture_pixels)
        throw DecodeError(fmt::format("{} × {} pixels are beyond the limit of {} a side and {} in all", width, height,
                                      max_picture_side, max_picture_pixels));
}

PngReader::PngReader(std::span<const uint8_t> bytes) : context_(spng_ctx_new(0), spng_ctx_free) {
    if (!context_)
        throw std::bad_alloc();
    find_chunks(bytes);
    check(spng_set_png_stream(context_.get(), feed, this));
    spng_ihdr header{};
    check(spng_get_ihdr(context_.get(), &header));
    width_ = header.width;
    height_ = header.height;
    bits_ = header.bit_depth;
    interlaced_ = header.interlace_method != 0;
    // zlib packs at most 1,032 times. So a header that lies takes no memory.
    constexpr uint64_t most_packed = 1032;
    constexpr std::array<uint8_t, 7> channels{1, 0, 3, 1, 2, 0, 4};
    const uint64_t row = (uint64_t(width_) * channels[std::min<size_t>(header.color_type, 6)] * bits_ + 7) / 8;
    if (row * height_ > most_packed * packed_)
        throw damaged("its data are too short for its size");
}

/// Chunks by their lengths. Those that change no pixel are left out: https://www.w3.org/TR/png-3/#11Chunks
void PngReader::find_chunks(std::span<const uint8_t> bytes) {
    if (bytes.size() <= colour_type_at)
        throw damaged("it is cut short");
    if (std::memcmp(&bytes[header_at], "IHDR", 4) != 0)
        throw damaged("it does not begin with its header");
    check_picture_size(big_endian(&bytes[width_at]), big_endian(&bytes[height_at]));
    parts_.push_back(bytes.first(signature_size));
    const bool alpha = (bytes[colour_type_at] & 4) != 0;
    for (size_t at = signature_size;;) {
        if (bytes.size() - at < chunk_overhead || big_endian(&bytes[at]) > bytes.size() - at - chunk_overhead)
            throw damaged("it is cut short");
        const uint32_t length = big_endian(&bytes[at]);
        const std::string_view type(reinterpret_cast<const char*>(&bytes[at + 4]), 4);
        const bool critical = (type[0] & 0x20) == 0;
        if (critical && type != "IHDR" && type != "PLTE" && type != "IDAT" && type != "IEND")
            throw damaged("it has a chunk of an unknown kind that matters");
        if (critical || (type == "tRNS" && !alpha))
            parts_.push_back(bytes.subspan(at, length + chunk_overhead));
        if (type == "IDAT")
            packed_ += length;
        if (type == "IEND")
            return;
        at += length + chunk_overhead;
    }
}

int PngReader::feed(spng_ctx*, void* self, void* to, size_t length) {
    auto& reader = *static_cast<PngReader*>(self);
    auto* out = static_cast<uint8_t*>(to);
    while (length > 0) {
        if (reader.part_ == reader.parts_.size())
            return SPNG_IO_EOF;
        const auto part = reader.parts_[reader.part_].subspan(reader.at_);
        const size_t taken = std::min(length, part.size());
        std::memcpy(out, part.data(), taken);
        out += taken;
        length -= taken;
        reader.at_ += taken;
        if (taken == part.size()) {
            ++reader.part_;
            reader.at_ = 0;
        }
    }
    return 0;
}

void PngReader::check(int error) const {
    if (error == SPNG_EMEM)
        throw std::bad_alloc();
    if (error)
        throw damaged(spng_strerror(error));
}

uint64_t PngReader::working_bytes() const {
    return working_constant + (interlaced_ ? uint64_t(width_) * height_ * (bits_ == 16 ? 8 : 0) : 0);
}

void PngReader::start() {
    started_ = true;
    const int format = sixteen_bits() ? SPNG_FMT_RGBA16 : SPNG_FMT_RGBA8;
    check(spng_decode_image(context_.get(), nullptr, 0, format, SPNG_DECODE_TRNS | SPNG_DECODE_PROGRESSIVE));
    if (sixteen_bits())
        wide_row_.resize(size_t(width_) * 4);
}

/// To the nearest of 256 values: 65535 / 257 = 255.
void PngReader::narrow(const uint16_t* wide, uint8_t* rgba, size_t values) const {
    std::transform(wide, wide + values, rgba, [](uint16_t v) { return static_cast<uint8_t>((v + 128u) / 257u); });
}

void PngReader::read_row(uint8_t* rgba) {
    if (!started_)
        start();
    const size_t values = size_t(width_) * 4;
    const int error = sixteen_bits() ? spng_decode_row(context_.get(), wide_row_.data(), values * 2)
                                     : spng_decode_row(context_.get(), rgba, values);
    check(error == SPNG_EOI ? spng_decode_chunks(context_.get()) : error); // after the last row: all checksums
    if (sixteen_bits())
        narrow(wide_row_.data(), rgba, values);
}

void PngReader::read_all(uint8_t* rgba) {
    const size_t values = size_t(width_) * height_ * 4;
    if (!sixteen_bits()) {
        check(spng_decode_image(context_.get(), rgba, values, SPNG_FMT_RGBA8, SPNG_DECODE_TRNS));
    } else {
        std::vector<uint16_t> wide(values);
        check(spng_decode_image(context_.get(), wide.data(), values * 2, SPNG_FMT_RGBA16, SPNG_DECODE_TRNS));
        narrow(wide.data(), rgba, values);
    }
    check(spng_decode_chunks(context_.get()));
}

} // namespace prelight
