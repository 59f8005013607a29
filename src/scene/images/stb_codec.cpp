#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace {

/// What stb_image may still take in this thread. A PNG's compressed data can be far longer than its
/// picture; stb grows its buffer without asking the header, so the allocator has to say no.
thread_local size_t allowance = 0;
constexpr size_t block_header = alignof(std::max_align_t); ///< holds the block's size

/// Zeroed: for a damaged JPEG stb reads tables that it never filled.
void* bounded_malloc(size_t size) {
    if (size > allowance || size + block_header < size)
        return nullptr;
    auto* block = static_cast<std::byte*>(std::calloc(size + block_header, 1));
    if (!block)
        return nullptr;
    allowance -= size;
    *reinterpret_cast<size_t*>(block) = size;
    return block + block_header;
}

void bounded_free(void* pointer) {
    if (!pointer)
        return;
    std::byte* block = static_cast<std::byte*>(pointer) - block_header;
    allowance += *reinterpret_cast<size_t*>(block);
    std::free(block);
}

void* bounded_realloc(void* pointer, size_t size) {
    if (!pointer)
        return bounded_malloc(size);
    std::byte* block = static_cast<std::byte*>(pointer) - block_header;
    const size_t old = *reinterpret_cast<size_t*>(block);
    if (size > old && size - old > allowance)
        return nullptr;
    block = static_cast<std::byte*>(std::realloc(block, size + block_header));
    if (!block)
        return nullptr;
    allowance = allowance + old - size;
    *reinterpret_cast<size_t*>(block) = size;
    return block + block_header;
}

} // namespace

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wcast-qual"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#define STBI_MALLOC bounded_malloc
#define STBI_REALLOC bounded_realloc
#define STBI_FREE bounded_free
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

#include <fmt/format.h>
#include <scene/images/codecs.hpp>
#include <string>

namespace prelight::images {
namespace {

/// stb's reason in one printable line: it may quote the four bytes of an unknown PNG chunk's name.
DecodeError stb_error() {
    const char* reason = stbi_failure_reason();
    std::string text = reason ? reason : "unknown reason";
    for (char& c : text)
        if (c < 0x20 || c > 0x7e)
            c = '?';
    return DecodeError(fmt::format("does not decode ({})", text));
}

} // namespace

Cost inspect_stb(std::span<const uint8_t> bytes, Format format) {
    if (format == Format::jpeg)
        check_jpeg(bytes);
    allowance = size_t(1) << 20;
    int width = 0, height = 0, channels = 0;
    if (!stbi_info_from_memory(bytes.data(), int(bytes.size()), &width, &height, &channels))
        throw stb_error();
    // 8-bit PNG: unpacked lines, picture, de-interlaced picture, at most 4 bytes a pixel each;
    // JPEG: coefficients, planes, picture, 13 in all. 16-bit PNG: the same twice as wide, and
    // converted.
    const bool wide = stbi_is_16_bit_from_memory(bytes.data(), int(bytes.size())) != 0;
    const uint64_t pixels = uint64_t(width) * uint64_t(height);
    return {uint32_t(width), uint32_t(height),
            pixels * (wide ? 32 : 16) + 2 * bytes.size() + (1u << 20)};
}

TextureImage decode_stb(std::span<const uint8_t> bytes, const Cost& cost) {
    allowance = cost.working;
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(bytes.data(), int(bytes.size()), &width, &height, &channels, 4),
        stbi_image_free);
    if (!pixels)
        throw stb_error();
    if (uint32_t(width) != cost.width || uint32_t(height) != cost.height)
        throw DecodeError("has two sizes");
    TextureImage image;
    image.width = cost.width;
    image.height = cost.height;
    image.rgba.assign(pixels.get(), pixels.get() + size_t(cost.width) * cost.height * 4);
    return image;
}

} // namespace prelight::images
