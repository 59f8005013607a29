#include <prelight/light_distribution.hpp>
#include <scene/gltf/light_distributions.hpp>
#include <scene/gltf/uri.hpp>

namespace prelight::gltf {
namespace {

/// A number and a blank become a double, and four of them where a quarter stands for all; and the text is kept.
constexpr uint64_t profile_cost = 28;

} // namespace

void LightDistributions::read(const Item& own, Light& light) {
    if (const auto cookie = own.object("cookie")) {
        if (!cookie->has("texture"))
            cookie->warn("has no texture");
        if (const TextureRef texture = textures_.read(*cookie, "texture"))
            light.cookie = texture.image;
    }
    const auto ies = own.find("ies");
    if (!ies)
        return;
    if (ies->is_string()) {
        light.profile = profile_of(own, own.text("ies"));
        return;
    }
    const Item object = *own.object("ies");
    light.profile_candela = object.flag("candela");
    if (object.has("uri"))
        light.profile = profile_of(object, object.text("uri"));
    else if (const auto view = object.index("bufferView", document_.count(Table::buffer_views)))
        light.profile = profile_of(object, *view);
    else
        object.warn("has neither uri nor bufferView; the light has no profile");
}

LightDistributions::Profile LightDistributions::profile_of(const Item& own, const std::string& uri) {
    Profile& known = by_uri_[uri];
    if (!known) {
        try {
            known = parsed(own, is_data_uri(uri) ? "ies" : printable(uri), document_.read_uri(uri, own.label()));
        } catch (const UriError& error) {
            own.warn("ies: {}; the light has no profile", error.what());
        }
    }
    return known;
}

LightDistributions::Profile LightDistributions::profile_of(const Item& own, uint32_t view) {
    Profile& known = by_view_[view];
    if (!known)
        known = parsed(own, document_.label(Table::buffer_views, view), buffers_.view(view).bytes);
    return known;
}

LightDistributions::Profile LightDistributions::parsed(const Item& own, const std::string& name,
                                                       std::span<const uint8_t> bytes) {
    document_.charge(own.label(), bytes.size(), profile_cost);
    try {
        return std::make_shared<LightProfile>(
            parse_profile({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, name));
    } catch (const Error& error) {
        own.warn("{}; the light has no profile", error.what());
        return {};
    }
}

} // namespace prelight::gltf
