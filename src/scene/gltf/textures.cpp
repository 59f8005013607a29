#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <parallel/parallel_for.hpp>
#include <scene/gltf/shown_images.hpp>
#include <scene/gltf/textures.hpp>
#include <scene/gltf/uri.hpp>
#include <scene/images/decode.hpp>

namespace prelight::gltf {
namespace {

Wrap wrap_of(const Item& item, const char* key) {
    switch (item.integer_or(key, 10497)) {
    case 10497: return Wrap::repeat;
    case 33648: return Wrap::mirrored_repeat;
    case 33071: return Wrap::clamp_to_edge;
    default: item.warn("{} {} is not known; REPEAT is used", key, item.integer_or(key, 0)); return Wrap::repeat;
    }
}

/// Why a picture cannot be read, as one short reason.
struct LostPicture : std::runtime_error {
    using std::runtime_error::runtime_error;
};
/// What a texture under this key holds; a shader's own are taken for values.
images::Texels texels_of(std::string_view key) {
    if (key.find("ormalTexture") != std::string_view::npos)
        return images::Texels::normals;
    for (const std::string_view colour : {"baseColor", "emissive", "diffuse", "olorTexture", "specularGlossiness"})
        if (key.find(colour) != std::string_view::npos)
            return images::Texels::colour;
    return key == "texture" ? images::Texels::colour : images::Texels::values; // a light's cookie
}

uint64_t bytes_at(uint32_t width, uint32_t height, uint32_t halvings) {
    return uint64_t(images::halved(width, halvings)) * images::halved(height, halvings) * 4;
}

} // namespace

Textures::Textures(Document& document, Buffers& buffers, Scene& scene)
    : document_(document), buffers_(buffers), scene_(scene) {
    document.charge("images", document.count(Table::images),
                    sizeof(slots_[0]) + sizeof(TextureImage) + sizeof(Loaded) + sizeof(Early) + 64);
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
    ref.image = image_of(texture, texels_of(key));
    if (const auto sampler = texture.index("sampler", document_.count(Table::samplers)))
        ref.sampler = read_sampler(*sampler);
    uint64_t texcoord = info->integer_or("texCoord", 0);
    read_transform(*info, ref, texcoord);
    if (texcoord > 1) {
        document_.warn("texture coordinates beyond set 1 are not read; set 0 is used", info->label());
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
    ref.uv_linear = glm::mat2(glm::vec2(c * scale[0], -s * scale[0]), glm::vec2(s * scale[1], c * scale[1]));
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
    sampler.mip = !mips ? MipFilter::none : min < first_mip + 2 ? MipFilter::nearest : MipFilter::linear;
    return sampler;
}

uint32_t Textures::image_of(const Item& texture, images::Texels kind) {
    auto source = texture.index("source", document_.count(Table::images));
    if (const auto webp = texture.extension("EXT_texture_webp"))
        source = webp->required_index("source", document_.count(Table::images));
    if (!source) {
        document_.warn("has no image in a format that is read; it is left out", texture.label());
        return no_image;
    }
    if (slots_[*source] == no_image)
        if (const auto slot = try_load(*source, kind))
            slots_[*source] = *slot;
    return slots_[*source];
}

std::optional<uint32_t> Textures::try_load(uint32_t image, images::Texels kind, uint32_t most_halvings) {
    if (lost_[image])
        return {};
    try {
        return load_image(image, kind, most_halvings);
    } catch (const LostPicture& lost) {
        lost_[image] = true;
        document_.item(Table::images, image).warn("{}; what shows it is plain", lost.what());
        return {};
    }
}

std::optional<TextureImage> Textures::take(uint32_t image) {
    if (slots_[image] != no_image && loaded_[slots_[image]].halvings == 0)
        return scene_.images[slots_[image]];
    // Codes that are no colours cannot be averaged.
    const auto slot = try_load(image, images::Texels::values, 0);
    if (!slot)
        return {};
    TextureImage taken = std::move(scene_.images[*slot]);
    scene_.images.pop_back();
    loaded_.pop_back();
    return taken;
}

void Textures::decode_ahead() {
    Budget& budget = document_.budget();
    uint64_t memory = 0, work = 0;
    for (const uint32_t index : shown_images(document_))
        try {
            Early early{.image = index, .bytes = find_bytes(document_.item(Table::images, index))};
            if (early.bytes.size() > budget.work_left() - work)
                return early_.clear();
            const images::Cost cost = images::inspect(early.bytes);
            const uint64_t pixels = uint64_t(cost.width) * cost.height;
            early.size = bytes_at(cost.width, cost.height, 0);
            memory += early.size + cost.working;
            work += early.bytes.size() + pixels;
            if (memory > budget.left(Budget::Pool::images) || work > budget.work_left())
                return early_.clear();
            early_.emplace(index, std::move(early));
        } catch (const LostPicture&) { // told when a material wants it
        } catch (const images::DecodeError&) {
        }
    std::vector<Early*> all;
    for (auto& [index, early] : early_) {
        early.picture.rgba.reserve(early.size); // here, where freed memory is; a thread would take new one
        all.push_back(&early);
    }
    // The largest ones first, so that no processor begins one when the others have nothing left to do.
    std::ranges::stable_sort(all, std::greater(), &Early::size);
    parallel_for(uint32_t(all.size()), [&](uint32_t i) {
        try {
            all[i]->picture = images::decode(all[i]->bytes, 0, images::Texels::values, std::move(all[i]->picture.rgba));
        } catch (const images::DecodeError& error) {
            all[i]->mistake = error.what();
        }
    });
}

TextureImage Textures::decode(uint32_t image, std::span<const uint8_t> bytes, uint32_t halvings, images::Texels kind) {
    const auto early = early_.find(image);
    if (early == early_.end())
        return images::decode(bytes, halvings, kind);
    if (!early->second.mistake.empty())
        throw images::DecodeError(early->second.mistake);
    TextureImage picture = std::move(early->second.picture);
    early_.erase(early);
    return halvings == 0 ? std::move(picture) : images::scaled_down(picture, halvings, kind);
}

std::span<const uint8_t> Textures::image_bytes(uint32_t image) {
    const auto early = early_.find(image);
    return early != early_.end() ? early->second.bytes : find_bytes(document_.item(Table::images, image));
}

std::span<const uint8_t> Textures::find_bytes(const Item& image) {
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

uint32_t Textures::load_image(uint32_t index, images::Texels kind, uint32_t most_halvings) {
    const Item item = document_.item(Table::images, index);
    const std::span<const uint8_t> bytes = image_bytes(index);
    try {
        Budget& budget = document_.budget();
        budget.charge_work(bytes.size()); // a million images may name the same bytes
        const images::Cost cost = images::inspect(bytes);
        budget.charge_work(uint64_t(cost.width) * cost.height);
        const uint32_t halvings = make_room(cost, most_halvings);
        const uint64_t size = bytes_at(cost.width, cost.height, halvings);
        {
            const Loan working(budget, Budget::Pool::images,
                               size + cost.working + (halvings > 0 ? cost.working_scaled : 0));
            scene_.images.push_back(decode(index, bytes, halvings, kind));
        }
        budget.charge(Budget::Pool::images, size);
        loaded_.push_back({index, cost.width, cost.height, halvings, kind});
        if (most_halvings > 0)
            largest_.emplace(size, uint32_t(scene_.images.size() - 1));
    } catch (const images::DecodeError& error) {
        throw LostPicture(error.what());
    } catch (const Budget::Exceeded& error) {
        item.fail(error.what());
    }
    scene_.images.back().name = item.text("name");
    return uint32_t(scene_.images.size() - 1);
}

/// How often a new image is halved so that it fits: whichever is the largest loses half its sides, it or one that
/// is there. What does not fit then, charge() says.
uint32_t Textures::make_room(const images::Cost& cost, uint32_t most_halvings) {
    const Budget& budget = document_.budget();
    uint32_t halvings = 0;
    if (cost.working + std::min(bytes_at(cost.width, cost.height, 0), cost.working_scaled + 4) >
        budget.limit(Budget::Pool::images))
        return halvings; // nothing that could be given up would help
    for (;;) {
        const uint64_t size = bytes_at(cost.width, cost.height, halvings);
        const uint64_t working = cost.working + (halvings > 0 ? cost.working_scaled : 0);
        if (size + working <= budget.left(Budget::Pool::images))
            return halvings;
        const bool shrinks = halvings < most_halvings && size > 4;
        if (!largest_.empty() && largest_.top().first > 4 && (!shrinks || largest_.top().first > size))
            halve(largest_.top().second);
        else if (shrinks)
            ++halvings;
        else
            return halvings;
    }
}

/// The largest one.
void Textures::halve(uint32_t slot) {
    Loaded& loaded = loaded_[slot];
    TextureImage& image = scene_.images[slot];
    const uint64_t before = largest_.top().first;
    largest_.pop();
    image = images::scaled_down(image, 1, loaded.kind);
    const uint64_t after = image.rgba.size();
    ++loaded.halvings;
    document_.budget().release(Budget::Pool::images, before - after);
    largest_.emplace(after, slot);
}

void Textures::tell_scaled() {
    for (size_t slot = 0; slot < loaded_.size(); ++slot) {
        const Loaded& loaded = loaded_[slot];
        const TextureImage& image = scene_.images[slot];
        if (loaded.halvings == 0)
            continue;
        const std::string name = image.name.empty() ? "" : fmt::format(" ({})", printable(image.name));
        document_.warn(fmt::format("scaled down from {} × {} to {} × {} pixels: pictures may take {} MiB "
                                   "(a quarter of the memory limit)",
                                   loaded.width, loaded.height, image.width, image.height,
                                   document_.budget().limit(Budget::Pool::images) >> 20),
                       document_.label(Table::images, loaded.image) + name);
    }
}

} // namespace prelight::gltf
