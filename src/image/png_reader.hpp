#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

struct spng_ctx;

namespace prelight {

/// Why a picture could not be decoded, as one short reason.
struct DecodeError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Longest side of a picture in pixels, and most pixels of one picture.
inline constexpr uint32_t max_picture_side = 1u << 17;
inline constexpr uint64_t max_picture_pixels = uint64_t(1) << 30;
/// Throws DecodeError when the picture is larger, or empty.
void check_picture_size(uint64_t width, uint64_t height);

/// Decodes PNG by libspng to 8-bit RGBA as stored: gamma and colour profiles are not applied, transparent colours
/// (tRNS) are. 16 bits a channel are rounded to 8. A palette's missing entries are opaque black. libspng sees the
/// chunks that matter alone, never texts, profiles or anything else that could unpack to any size.
class PngReader {
public:
    /// `bytes` outlive it. Throws DecodeError when header or chunks are damaged, when the picture is beyond the limits
    /// above, or when the file is too short for it.
    explicit PngReader(std::span<const uint8_t> bytes);
    PngReader(const PngReader&) = delete; // libspng knows where it is
    PngReader& operator=(const PngReader&) = delete;
    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }
    bool sixteen_bits() const { return bits_ == 16; }
    /// Rows do not come one by one: read_all() takes working_bytes().
    bool interlaced() const { return interlaced_; }
    uint64_t working_bytes() const;

    /// The next row, width × 4 bytes. Not for interlaced pictures. Throws DecodeError.
    void read_row(uint8_t* rgba);
    /// All rows. Throws DecodeError.
    void read_all(uint8_t* rgba);

private:
    void find_chunks(std::span<const uint8_t> bytes);
    void start();
    void check(int error) const;
    void narrow(const uint16_t* wide, uint8_t* rgba, size_t values) const;
    static int feed(spng_ctx*, void* self, void* to, size_t length);

    std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context_;
    std::vector<std::span<const uint8_t>> parts_; ///< of the file, that libspng sees
    size_t part_ = 0, at_ = 0;
    uint64_t packed_ = 0; ///< bytes of all IDAT chunks
    uint32_t width_ = 0, height_ = 0;
    uint8_t bits_ = 8;
    bool interlaced_ = false, started_ = false;
    std::vector<uint16_t> wide_row_;
};

} // namespace prelight
