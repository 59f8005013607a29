#include "texture_limit.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace prelight::resident {
namespace {

uint32_t halvings_to(const TextureImage& image, uint32_t limit) {
    uint32_t halvings = 0;
    while (std::max(image.width, image.height) >> halvings > limit)
        ++halvings;
    return halvings;
}

} // namespace

std::optional<TextureImage> scaled_to_limit(const TextureImage& image, images::Texels kind, uint32_t limit) {
    if (const uint32_t halvings = halvings_to(image, limit))
        return images::scaled_down(image, halvings, kind);
    return {};
}

std::vector<std::string> notes_on_large_textures(const Scene& scene, uint32_t limit) {
    std::set<uint32_t> used;
    for (const Material& m : scene.materials) {
        for (const TextureRef* ref : {&m.base_colour_texture, &m.metallic_roughness_texture, &m.normal_texture,
                                      &m.occlusion_texture, &m.emissive_texture})
            used.insert(ref->image);
        for (const auto& [name, ref] : m.textures)
            used.insert(ref.image);
    }
    std::vector<std::string> notes;
    for (const uint32_t i : used) {
        if (i >= scene.images.size())
            continue;
        const TextureImage& image = scene.images[i];
        if (const uint32_t halvings = halvings_to(image, limit))
            notes.push_back(fmt::format(
                "{}: image {}{}: scaled down from {} × {} to {} × {} pixels: the device takes {} a side", scene.name, i,
                image.name.empty() ? "" : fmt::format(" ({})", image.name), image.width, image.height,
                images::halved(image.width, halvings), images::halved(image.height, halvings), limit));
    }
    return notes;
}

} // namespace prelight::resident
