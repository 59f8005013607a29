#include <cstring>
#include <fmt/format.h>
#include <platform/read_file.hpp>
#include <scene/images/codecs.hpp>

namespace prelight::images {

Format format_of(std::span<const uint8_t> bytes) {
    const auto begins = [bytes](size_t at, const char* text, size_t length) {
        return bytes.size() >= at + length && std::memcmp(bytes.data() + at, text, length) == 0;
    };
    if (begins(0, "\x89PNG\r\n\x1a\n", 8))
        return Format::png;
    if (begins(0, "\xff\xd8\xff", 3))
        return Format::jpeg;
    if (begins(0, "RIFF", 4) && begins(8, "WEBP", 4))
        return Format::webp;
    return Format::unknown;
}

Cost inspect(std::span<const uint8_t> bytes) {
    if (bytes.size() > largest_file::picture)
        throw DecodeError("is larger than 2 GiB");
    switch (format_of(bytes)) {
    case Format::png: return inspect_png(bytes);
    case Format::jpeg: return inspect_jpeg(bytes);
    case Format::webp: return inspect_webp(bytes);
    default: throw DecodeError("is neither PNG, JPEG nor WebP");
    }
}

TextureImage decode(std::span<const uint8_t> bytes, uint32_t halvings, Texels kind, std::vector<uint8_t> room) {
    switch (format_of(bytes)) {
    case Format::png: return decode_png(bytes, halvings, kind, std::move(room));
    case Format::jpeg: return decode_jpeg(bytes, halvings, kind, std::move(room));
    default: return decode_webp(bytes, halvings, kind, std::move(room));
    }
}

} // namespace prelight::images
