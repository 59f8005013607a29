#include <cstring>
#include <fmt/format.h>
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
    const Format format = format_of(bytes);
    if (format == Format::unknown)
        throw DecodeError("is neither PNG, JPEG nor WebP");
    // The codecs' interfaces count in int.
    if (bytes.size() > 0x7fffffff)
        throw DecodeError("is larger than 2 GiB");
    const Cost cost = format == Format::webp ? inspect_webp(bytes) : inspect_stb(bytes, format);
    if (cost.width == 0 || cost.height == 0 || cost.width > max_side || cost.height > max_side ||
        uint64_t(cost.width) * cost.height > max_pixels)
        throw DecodeError(
            fmt::format("{} × {} pixels are beyond the limit of {} a side and {} in all",
                        cost.width, cost.height, max_side, max_pixels));
    return cost;
}

TextureImage decode(std::span<const uint8_t> bytes) {
    const Cost cost = inspect(bytes);
    return format_of(bytes) == Format::webp ? decode_webp(bytes, cost) : decode_stb(bytes, cost);
}

} // namespace prelight::images
