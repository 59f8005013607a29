#pragma once
#include <map>
#include <queue>
#include <scene/gltf/buffers.hpp>
#include <scene/images/decode.hpp>

namespace prelight::gltf {

/// The file's textures: those that a material uses are decoded, each image once.
class Textures {
public:
    Textures(Document& document, Buffers& buffers, Scene& scene);
    /// Decodes the materials' pictures on all processors, before they are read one by one; none of them unless the
    /// budget has room for all as they are stored.
    void decode_ahead();
    /// Gives up what no material wanted after all.
    void drop_early() { early_.clear(); }
    /// The textureInfo object under `key` of a material; no image when it is absent, or when its picture is missing
    /// or does not decode (with a warning).
    TextureRef read(const Item& material, std::string_view key);
    /// One of the file's images, decoded, that is no material's; nothing when it cannot be read (with a warning).
    std::optional<TextureImage> take(uint32_t image);
    /// Warns of the textures that had to be scaled down. After all have been read.
    void tell_scaled();

private:
    /// An image of the scene's and what became of it.
    struct Loaded {
        uint32_t image = 0;             ///< of the file
        uint32_t width = 0, height = 0; ///< as stored
        uint32_t halvings = 0;
        images::Texels kind = images::Texels::values;
    };
    /// An image that decode_ahead() has looked at.
    struct Early {
        uint32_t image = 0; ///< of the file
        std::span<const uint8_t> bytes;
        uint64_t size = 0;    ///< bytes, decoded
        TextureImage picture; ///< until it is taken
        std::string mistake;  ///< why it does not decode
    };
    static constexpr uint32_t never = 32; ///< halvings that are too many

    uint32_t image_of(const Item& texture, images::Texels kind);
    /// The image's place at the end of Scene::images; nothing, with a warning, when it is not to be had.
    std::optional<uint32_t> try_load(uint32_t image, images::Texels kind, uint32_t most_halvings = never);
    uint32_t load_image(uint32_t index, images::Texels kind, uint32_t most_halvings);
    uint32_t make_room(const images::Cost& cost, uint32_t most_halvings);
    void halve(uint32_t slot);
    std::span<const uint8_t> image_bytes(uint32_t image);
    std::span<const uint8_t> find_bytes(const Item& image);
    TextureImage decode(uint32_t image, std::span<const uint8_t> bytes, uint32_t halvings, images::Texels kind);
    Sampler read_sampler(uint32_t index) const;
    void read_transform(const Item& info, TextureRef& ref, uint64_t& texcoord) const;

    Document& document_;
    Buffers& buffers_;
    Scene& scene_;
    std::vector<uint32_t> slots_;                                ///< glTF image → Scene::images, or no_image
    std::map<uint32_t, Early> early_;                            ///< by image
    std::vector<bool> lost_;                                     ///< images that have been tried in vain
    std::vector<Loaded> loaded_;                                 ///< as Scene::images
    std::priority_queue<std::pair<uint64_t, uint32_t>> largest_; ///< bytes and slot of each
};

/// Takes over a material's `extras.prelight` (schema in scene/write/parts.hpp).
void read_material_extras(Textures& textures, const Item& item, Material& material);

/// KHR_materials_ior, _specular, _clearcoat, _sheen, _transmission and _volume as parameters of the material `layered`;
/// nothing where they say what glTF says without them, or where the material has a shader or no light.
void read_material_layers(Document& document, Textures& textures, const Item& item, Material& material);

/// KHR_materials_pbrSpecularGlossiness in place of pbrMetallicRoughness: plain metallic-roughness where that says the
/// same, else the built-in material `specular-glossiness`.
void read_specular_glossiness(Textures& textures, const Item& extension, Material& material);

/// Fills `scene.materials`, one for each of the file's.
void read_materials(Document& document, Textures& textures, Scene& scene);

} // namespace prelight::gltf
