#include "texture_settings.hpp"
#include <fmt/format.h>

namespace prelight {

namespace {

constexpr const char* key = "texture-filter";

} // namespace

SettingInfo texture_filter_setting() {
    return {key,
            {"auto", "trilinear", "anisotropic", "bilinear"},
            "auto",
            "trilinear: as the file's samplers say; anisotropic: up to 8 times where they mix mip maps (auto on a GPU; "
            "trilinear on a "
            "CPU); bilinear: level 0 only, for comparing with the reference"};
}

void resolve_texture_filter(Settings& settings, const gpu::Context& context) {
    // A software device pays for anisotropy with most of a textured frame; lavapipe's also blurs what is magnified.
    if (settings.is(key, "auto"))
        settings.resolve(key, context.is_software() || !context.features().anisotropy ? "trilinear" : "anisotropic");
    if (settings.is(key, "anisotropic") && !context.features().anisotropy) {
        settings.resolve(key, "trilinear");
        settings.note(fmt::format("texture-filter=anisotropic: {} has no anisotropic filtering, trilinear is taken",
                                  context.name()));
    }
}

gpu::TextureFilter texture_filter(const Settings& settings) {
    return settings.is(key, "bilinear")      ? gpu::TextureFilter::bilinear
           : settings.is(key, "anisotropic") ? gpu::TextureFilter::anisotropic
                                             : gpu::TextureFilter::trilinear;
}

} // namespace prelight
