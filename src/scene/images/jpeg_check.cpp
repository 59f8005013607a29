#include <fmt/format.h>
#include <scene/images/codecs.hpp>

namespace prelight::images {
namespace {

/// A progressive JPEG walks the whole picture once a scan, and a scan may be a few bytes long.
constexpr int max_scans = 100;

/// Huffman tables of a DHT segment: a class byte, 16 counts, then as many values. stb_image 2.27
/// writes values beyond 256 past the end of its table.
void check_huffman_tables(std::span<const uint8_t> tables) {
    while (!tables.empty()) {
        size_t values = 0;
        if (tables.size() < 17)
            throw DecodeError("does not decode (JPEG: Huffman table cut short)");
        for (size_t i = 1; i <= 16; ++i)
            values += tables[i];
        if (values > 256 || 17 + values > tables.size())
            throw DecodeError("does not decode (JPEG: bad Huffman table)");
        tables = tables.subspan(17 + values);
    }
}

} // namespace

/// Follows the markers as stb_image does: a segment is skipped by its length, anything else up to
/// the next 0xff; within a scan's data 0xff 0 is a byte and 0xff 0xd0 … 0xd7 a restart.
void check_jpeg(std::span<const uint8_t> bytes) {
    int scans = 0;
    for (size_t at = 2; at + 1 < bytes.size();) {
        if (bytes[at++] != 0xff)
            continue;
        while (at < bytes.size() && bytes[at] == 0xff)
            ++at;
        if (at == bytes.size())
            break;
        const uint8_t marker = bytes[at++];
        if (marker == 0xd9)
            return;
        if (marker <= 0x01 || (marker >= 0xd0 && marker <= 0xd8))
            continue;
        if (bytes.size() - at < 2)
            break;
        const size_t length = size_t(bytes[at]) << 8 | bytes[at + 1];
        if (length < 2 || length > bytes.size() - at)
            break;
        if (marker == 0xc4)
            check_huffman_tables(bytes.subspan(at + 2, length - 2));
        if (marker == 0xda && ++scans > max_scans)
            throw DecodeError(fmt::format("JPEG has more than {} scans", max_scans));
        at += length;
    }
    // stb_image fills what is missing with grey without a word.
    throw DecodeError("JPEG is truncated");
}

} // namespace prelight::images
