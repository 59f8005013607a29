#include <algorithm>
#include <array>
#include <scene/gltf/shown_images.hpp>

namespace prelight::gltf {
namespace {

namespace dom = simdjson::dom;

constexpr std::array extensions_with_textures{"KHR_materials_specular", "KHR_materials_clearcoat",
                                              "KHR_materials_sheen",    "KHR_materials_transmission",
                                              "KHR_materials_volume",   "KHR_materials_pbrSpecularGlossiness"};

/// The number under `key` when it is an index below `count`.
std::optional<uint32_t> index_in(dom::object object, std::string_view key, size_t count) {
    uint64_t index = 0;
    if (object.at_key(key).get(index) != simdjson::SUCCESS || index >= count)
        return {};
    return static_cast<uint32_t>(index);
}

class ShownImages {
public:
    explicit ShownImages(const Document& document)
        : document_(document), seen_(document.count(Table::images)),
          textures_(elements_of("textures", document.count(Table::textures))) {}

    std::vector<uint32_t> run() {
        for (const dom::element material : elements_of("materials", document_.count(Table::materials))) {
            dom::object object;
            if (material.get(object) == simdjson::SUCCESS)
                walk(object);
        }
        return std::move(found_);
    }

private:
    std::vector<dom::element> elements_of(std::string_view table, size_t count) const {
        std::vector<dom::element> elements;
        dom::array array;
        const auto value = document_.root().find(table);
        if (!value || value->get(array) != simdjson::SUCCESS)
            return elements;
        elements.reserve(count);
        for (const dom::element element : array)
            elements.push_back(element);
        return elements;
    }

    void walk(dom::object object) {
        for (const auto [key, value] : object) {
            dom::object inner;
            if (value.get(inner) != simdjson::SUCCESS)
                continue;
            if (key.ends_with("Texture"))
                add(inner);
            else if (key == "pbrMetallicRoughness")
                walk(inner);
            else if (key == "extensions")
                for (const char* name : extensions_with_textures) {
                    dom::object extension;
                    if (inner.at_key(name).get(extension) == simdjson::SUCCESS)
                        walk(extension);
                }
        }
    }

    void add(dom::object info) {
        dom::object texture, webp;
        const auto index = index_in(info, "index", textures_.size());
        if (!index || textures_[*index].get(texture) != simdjson::SUCCESS)
            return;
        auto image = index_in(texture, "source", seen_.size());
        dom::object extensions;
        if (texture.at_key("extensions").get(extensions) == simdjson::SUCCESS &&
            extensions.at_key("EXT_texture_webp").get(webp) == simdjson::SUCCESS)
            image = index_in(webp, "source", seen_.size());
        if (!image || seen_[*image])
            return;
        seen_[*image] = true;
        found_.push_back(*image);
    }

    const Document& document_;
    std::vector<bool> seen_;
    std::vector<dom::element> textures_;
    std::vector<uint32_t> found_;
};

} // namespace

std::vector<uint32_t> shown_images(const Document& document) { return ShownImages(document).run(); }

} // namespace prelight::gltf
