#pragma once
#include "gltf_builder.hpp"

namespace prelight::test {

/// A PNG put together by hand, chunk by chunk: what libspng is checked against.
struct RawPng {
    uint32_t width = 1, height = 1;
    uint8_t bits = 8;
    uint8_t colour = 6; ///< PNG's colour type: 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
    bool interlaced = false;
    std::vector<std::pair<std::string, Bytes>> chunks{}; ///< between IHDR and IDAT
    Bytes lines{};        ///< before packing: of each line the filter's number and its bytes
    bool truthful = true; ///< false: checksums of `chunks` are wrong

    Bytes bytes() const;
};
/// Lines of filter 0 for `rows` of packed bytes.
Bytes unfiltered(const std::vector<Bytes>& rows);
/// A chunk with its length and checksum.
Bytes png_chunk(const std::string& type, const Bytes& content, bool truthful = true);

/// How a JPEG is written by libjpeg, at quality 100 and without subsampling.
struct JpegForm {
    enum class Stored { grey, ycc, rgb, cmyk, ycck };
    Stored stored = Stored::ycc;
    bool adobe_marker = false, jfif_marker = true;
    bool progressive = false;
    bool arithmetic = false;
    int quality = 100;
    Bytes exif{}; ///< an APP1 segment's content
};
/// `samples`: 1, 3 or 4 a pixel; of inks as they shall be stored.
Bytes jpeg_of(uint32_t width, uint32_t height, const Bytes& samples, const JpegForm& form);

} // namespace prelight::test
