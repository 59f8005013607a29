#pragma once
#include <scene/gltf/textures.hpp>

namespace prelight::gltf {

/// Cookies and profiles of lights, from `extras.prelight` (schema in scene/write/parts.hpp). A profile that several
/// lights name is read once.
class LightDistributions {
public:
    LightDistributions(Document& document, Buffers& buffers, Textures& textures)
        : document_(document), buffers_(buffers), textures_(textures) {}
    /// `own`: the light's `extras.prelight`. Throws Error.
    void read(const Item& own, Light& light);

private:
    using Profile = std::shared_ptr<const LightProfile>;
    Profile profile_of(const Item& own, const std::string& uri);
    Profile profile_of(const Item& own, uint32_t view);
    Profile parsed(const Item& own, const std::string& name, std::span<const uint8_t> bytes);
    Document& document_;
    Buffers& buffers_;
    Textures& textures_;
    std::map<std::string, Profile> by_uri_;
    std::map<uint32_t, Profile> by_view_;
};

} // namespace prelight::gltf
