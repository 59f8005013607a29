#include <fmt/format.h>
#include <image/png_reader.hpp>
#include <image/png_writer.hpp>
#include <scene/environment_codes.hpp>
#include <scene/write/parts.hpp>

namespace prelight::write {
namespace {

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

std::vector<std::byte> encode(const TextureImage& image) {
    if (has_alpha(image.rgba))
        return encode_png(image.width, image.height, 4, image.rgba);
    return encode_png(image.width, image.height, 3, without_alpha(image.rgba));
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
        const auto fail = [&](const std::string& reason) { document.fail(label("image", i, image.name), reason); };
        try {
            check_picture_size(image.width, image.height); // what is written can be read
        } catch (const DecodeError& error) {
            fail(error.what());
        }
        if (image.rgba.size() != size_t(image.width) * image.height * 4)
            fail(fmt::format("holds {} bytes, not {} × {} × 4", image.rgba.size(), image.width, image.height));
        const std::vector<std::byte> png = encode(image);
        Json entry = Json::object();
        set_name(entry, image.name);
        entry["mimeType"] = "image/png";
        entry["bufferView"] = document.add_view(png, ViewKind::other);
        document.add("images", std::move(entry));
    }
}

} // namespace prelight::write
