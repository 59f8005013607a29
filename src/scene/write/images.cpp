#include <fmt/format.h>
#include <scene/environment_codes.hpp>
#include <scene/write/parts.hpp>

// Static: other libraries of this program hold their own copy of stb.
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace prelight::write {
namespace {

constexpr uint32_t max_size = 16384; // stb counts bytes in int

std::vector<uint8_t> without_alpha(const std::vector<uint8_t>& rgba) {
    std::vector<uint8_t> rgb;
    rgb.reserve(rgba.size() / 4 * 3);
    for (size_t i = 0; i < rgba.size(); i += 4)
        rgb.insert(rgb.end(), {rgba[i], rgba[i + 1], rgba[i + 2]});
    return rgb;
}

bool has_alpha(const std::vector<uint8_t>& rgba) {
    for (size_t i = 3; i < rgba.size(); i += 4)
        if (rgba[i] != 255)
            return true;
    return false;
}

void append_bytes(void* sink, void* data, int size) {
    const auto* bytes = static_cast<const std::byte*>(data);
    auto& out = *static_cast<std::vector<std::byte>*>(sink);
    out.insert(out.end(), bytes, bytes + size);
}

std::vector<std::byte> encode_png(const TextureImage& image) {
    const bool alpha = has_alpha(image.rgba);
    const std::vector<uint8_t> rgb = alpha ? std::vector<uint8_t>{} : without_alpha(image.rgba);
    const uint8_t* pixels = alpha ? image.rgba.data() : rgb.data();
    std::vector<std::byte> png;
    if (!stbi_write_png_to_func(append_bytes, &png, static_cast<int>(image.width),
                                static_cast<int>(image.height), alpha ? 4 : 3, pixels, 0))
        png.clear();
    return png;
}

} // namespace

void add_images(const Scene& scene, Document& document) {
    std::vector<const TextureImage*> images;
    for (const TextureImage& image : scene.images)
        images.push_back(&image);
    TextureImage environment, backdrop;
    if (scene.environment) {
        environment = to_picture(scene.environment->name, scene.environment->image);
        Json& written = document.root["extras"]["prelight"]["environment"];
        written = {{"source", images.size()}};
        if (scene.environment->intensity != 1)
            written["intensity"] = scene.environment->intensity;
        if (scene.environment->rotation != 0)
            written["rotation"] = scene.environment->rotation;
        if (!scene.environment->background)
            written["background"] = false;
        images.push_back(&environment);
        if (!scene.environment->backdrop.pixels.empty()) {
            backdrop = to_picture("backdrop", scene.environment->backdrop);
            written["backdrop"] = images.size();
            images.push_back(&backdrop);
        }
    }
    for (size_t i = 0; i < images.size(); ++i) {
        const TextureImage& image = *images[i];
        const auto fail = [&](const std::string& reason) {
            document.fail(label("image", i, image.name), reason);
        };
        if (image.width < 1 || image.height < 1 || image.width > max_size ||
            image.height > max_size)
            fail(fmt::format("{} × {} pixels cannot be written (1 … {} each)", image.width,
                             image.height, max_size));
        if (image.rgba.size() != size_t(image.width) * image.height * 4)
            fail(fmt::format("holds {} bytes, not {} × {} × 4", image.rgba.size(), image.width,
                             image.height));
        const std::vector<std::byte> png = encode_png(image);
        if (png.empty())
            fail("cannot be encoded as PNG");
        Json entry = Json::object();
        set_name(entry, image.name);
        entry["mimeType"] = "image/png";
        entry["bufferView"] = document.add_view(png, ViewKind::other);
        document.add("images", std::move(entry));
    }
}

} // namespace prelight::write
