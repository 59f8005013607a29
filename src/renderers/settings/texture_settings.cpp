#include "texture_settings.hpp"

namespace prelight {

namespace {

using gpu::TextureFilter;

constexpr Choice<TextureFilter> texture_filter_words[] = {{"trilinear", TextureFilter::trilinear},
                                                          {"anisotropic", TextureFilter::anisotropic},
                                                          {"bilinear", TextureFilter::bilinear}};
constexpr ChoiceSetting<TextureFilter> texture_setting{
    "texture-filter", texture_filter_words, "auto",
    "trilinear: as the file's samplers say; anisotropic: up to 8 times where they mix mip maps (auto on a GPU; "
    "trilinear on a CPU); bilinear: level 0 only, for comparing with the reference",
    true};

} // namespace

SettingInfo texture_filter_setting() { return texture_setting.info(); }

void resolve_texture_filter(Settings& settings, const gpu::Context& context) {
    // A software device pays for anisotropy with most of a textured frame; lavapipe's also blurs what is magnified.
    const std::string none = context.name() + " has no anisotropic filtering";
    if (settings.is(texture_setting.key, "auto")) {
        const bool software = context.is_software(), trilinear = software || !context.features().anisotropy;
        settings.resolve(texture_setting, trilinear ? TextureFilter::trilinear : TextureFilter::anisotropic,
                         software    ? "anisotropy is slow on a software device"
                         : trilinear ? none
                                     : "the device filters anisotropically");
    }
    if (texture_filter(settings) == TextureFilter::anisotropic && !context.features().anisotropy)
        settings.fall_back(texture_setting.key, texture_setting.word(TextureFilter::trilinear), none);
}

TextureFilter texture_filter(const Settings& settings) { return settings.value(texture_setting); }

} // namespace prelight
