#include "inferred_settings.hpp"

namespace prelight {
namespace {

/// In eighths.
constexpr Choice<uint32_t> scale_words[] = {{"1", 8}, {"3/4", 6}, {"5/8", 5}, {"1/2", 4}};
constexpr ChoiceSetting<uint32_t> scale_setting{"inferred-scale", scale_words, "5/8",
                                                "the light's resolution: this share of the picture's width and height"};

constexpr Choice<bool> layer_words[] = {{"on", true}, {"off", false}};
constexpr ChoiceSetting<bool> layer_setting{
    "inferred-layers", layer_words, "on",
    "BLEND surfaces as up to three layers of the light's resolution; off: drawn opaque"};

} // namespace

std::vector<SettingInfo> inferred_settings() { return {scale_setting.info(), layer_setting.info()}; }

VkExtent2D inferred_extent(const Settings& settings, VkExtent2D frame) {
    const uint32_t eighths = settings.value(scale_setting);
    const auto scaled = [&](uint32_t pixels) { return static_cast<uint32_t>((uint64_t(pixels) * eighths + 7) / 8); };
    return {scaled(frame.width), scaled(frame.height)};
}

bool has_layers(const Settings& settings) { return settings.value(layer_setting); }

} // namespace prelight
