#pragma once
#include <scene/gltf/buffers.hpp>

namespace prelight::gltf {

/// The file's textures: those that a material uses are decoded, each image once.
class Textures {
public:
    Textures(Document& document, Buffers& buffers, Scene& scene);
    /// The textureInfo object under `key` of a material; no image when it is absent.
    TextureRef read(const Item& material, std::string_view key);

private:
    uint32_t image_of(const Item& texture);
    uint32_t load_image(uint32_t index);
    std::span<const uint8_t> image_bytes(const Item& image);
    Sampler read_sampler(uint32_t index) const;
    void read_transform(const Item& info, TextureRef& ref, uint64_t& texcoord) const;

    Document& document_;
    Buffers& buffers_;
    Scene& scene_;
    std::vector<uint32_t> slots_; ///< glTF image → Scene::images, or no_image
};

/// Fills `scene.materials`, one for each of the file's.
void read_materials(Document& document, Textures& textures, Scene& scene);

} // namespace prelight::gltf
