#include <cmath>
#include <fmt/format.h>
#include <scene/gltf/textures.hpp>
#include <scene/gltf/uri.hpp>
#include <scene/images/decode.hpp>

namespace prelight::gltf {
namespace {

Wrap wrap_of(const Item& item, const char* key) {
    switch (item.integer_or(key, 10497)) {
    case 10497:
        return Wrap::repeat;
    case 33648:
        return Wrap::mirrored_repeat;
    case 33071:
        return Wrap::clamp_to_edge;
    default:
        item.warn("{} {} is not known; REPEAT is used", key, item.integer_or(key, 0));
        return Wrap::repeat;
    }
}

/// Why a picture cannot be read, as one short reason.
struct LostPicture : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace

Textures::Textures(Document& document, Buffers& buffers, Scene& scene)
    : document_(document), buffers_(buffers), scene_(scene) {
    document.charge("images", document.count(Table::images), sizeof(slots_[0]));
    slots_.assign(document.count(Table::images), no_image);
    lost_.resize(document.count(Table::images));
}

TextureRef Textures::read(const Item& material, std::string_view key) {
    TextureRef ref;
    const auto info = material.object(key);
    if (!info)
        return ref;
    const uint32_t index = info->required_index("index", document_.count(Table::textures));
    const Item texture = document_.item(Table::textures, index);
    ref.image = image_of(texture);
    if (const auto sampler = texture.index("sampler", document_.count(Table::samplers)))
        ref.sampler = read_sampler(*sampler);
    uint64_t texcoord = info->integer_or("texCoord", 0);
    read_transform(*info, ref, texcoord);
    if (texcoord > 1) {
        document_.warn("texture coordinates beyond set 1 are not read; set 0 is used",
                       info->label());
        texcoord = 0;
    }
    ref.texcoord = uint32_t(texcoord);
    return ref;
}

void Textures::read_transform(const Item& info, TextureRef& ref, uint64_t& texcoord) const {
    const auto transform = info.extension("KHR_texture_transform");
    if (!transform)
        return;
    texcoord = transform->integer_or("texCoord", texcoord);
    const auto offset = transform->numbers<2>("offset", {0, 0});
    const auto scale = transform->numbers<2>("scale", {1, 1});
    const double rotation = transform->number("rotation", 0);
    // Counter-clockwise in an image whose v points down, as the extension's example and the Khronos
    // sample viewer have it (the formula in the extension's text turns the other way).
    const double c = std::cos(rotation), s = std::sin(rotation);
    ref.uv_linear =
        glm::mat2(glm::vec2(c * scale[0], -s * scale[0]), glm::vec2(s * scale[1], c * scale[1]));
    ref.uv_offset = glm::vec2(offset[0], offset[1]);
    const glm::vec2 sum = ref.uv_linear[0] + ref.uv_linear[1] + ref.uv_offset;
    if (!std::isfinite(sum.x) || !std::isfinite(sum.y)) {
        transform->warn("is not finite; it is left out");
        ref.uv_linear = glm::mat2(1);
        ref.uv_offset = glm::vec2(0);
    }
}

Sampler Textures::read_sampler(uint32_t index) const {
    const Item item = document_.item(Table::samplers, index);
    Sampler sampler;
    sampler.wrap_s = wrap_of(item, "wrapS");
    sampler.wrap_t = wrap_of(item, "wrapT");
    constexpr uint64_t nearest = 9728, linear = 9729, first_mip = 9984;
    const uint64_t mag = item.integer_or("magFilter", linear);
    if (mag != nearest && mag != linear)
        item.warn("magFilter {} is not known; LINEAR is used", mag);
    sampler.mag = mag == nearest ? Filter::nearest : Filter::linear;
    uint64_t min = item.integer_or("minFilter", first_mip + 3);
    if (min != nearest && min != linear && (min < first_mip || min > first_mip + 3)) {
        item.warn("minFilter {} is not known; LINEAR_MIPMAP_LINEAR is used", min);
        min = first_mip + 3;
    }
    // 9984 … 9987: the low bit filters within a level, the next one between levels.
    const bool mips = min >= first_mip;
    sampler.min = (min & 1) == 0 ? Filter::nearest : Filter::linear;
    sampler.mip = !mips                 ? MipFilter::none
                  : min < first_mip + 2 ? MipFilter::nearest
                                        : MipFilter::linear;
    return sampler;
}

uint32_t Textures::image_of(const Item& texture) {
    auto source = texture.index("source", document_.count(Table::images));
    if (const auto webp = texture.extension("EXT_texture_webp"))
        source = webp->required_index("source", document_.count(Table::images));
    if (!source) {
        document_.warn("has no image in a format that is read; it is left out", texture.label());
        return no_image;
    }
    if (slots_[*source] == no_image && try_load(*source))
        slots_[*source] = uint32_t(scene_.images.size() - 1);
    return slots_[*source];
}

bool Textures::try_load(uint32_t image) {
    if (lost_[image])
        return false;
    try {
        load_image(image);
        return true;
    } catch (const LostPicture& lost) {
        lost_[image] = true;
        document_.item(Table::images, image).warn("{}; what shows it is plain", lost.what());
        return false;
    }
}

std::optional<TextureImage> Textures::take(uint32_t image) {
    if (slots_[image] != no_image)
        return scene_.images[slots_[image]];
    if (!try_load(image))
        return {};
    TextureImage taken = std::move(scene_.images.back());
    scene_.images.pop_back();
    return taken;
}

std::span<const uint8_t> Textures::image_bytes(const Item& image) {
    if (image.has("uri")) {
        try {
            return document_.read_uri(image.text("uri"), image.label());
        } catch (const UriError& error) {
            throw LostPicture(error.what());
        }
    }
    const auto view = image.index("bufferView", document_.count(Table::buffer_views));
    if (!view)
        throw LostPicture("has neither uri nor bufferView");
    return buffers_.view(*view).bytes;
}

void Textures::load_image(uint32_t index) {
    const Item item = document_.item(Table::images, index);
    const std::span<const uint8_t> bytes = image_bytes(item);
    try {
        Budget& budget = document_.budget();
        // The encoded bytes too: a million images may name the same ones, and each costs time.
        budget.charge(Budget::Pool::images, bytes.size());
        const images::Cost cost = images::inspect(bytes);
        budget.charge(Budget::Pool::images, uint64_t(cost.width) * cost.height, 4);
        const Loan working(budget, Budget::Pool::images, cost.working);
        scene_.images.push_back(images::decode(bytes));
    } catch (const images::DecodeError& error) {
        throw LostPicture(error.what());
    } catch (const Budget::Exceeded& error) {
        item.fail(error.what());
    }
    scene_.images.back().name = item.text("name");
}

} // namespace prelight::gltf
