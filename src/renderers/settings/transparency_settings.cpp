#include "transparency_settings.hpp"
#include <setting_values/needs.hpp>

namespace prelight {
namespace {

constexpr Choice<Transparency> transparency_words[] = {
    {"lists", Transparency::lists},       {"sorted", Transparency::sorted},
    {"peeled", Transparency::peeled},     {"k-buffer", Transparency::k_buffer},
    {"weighted", Transparency::weighted}, {"half-samples", Transparency::half_samples},
    {"opaque", Transparency::opaque}};
constexpr ChoiceSetting<Transparency> transparency_setting{
    "transparency", transparency_words, "lists",
    "BLEND surfaces, objects back to front: lights by lists of their place, or a few of the object's a draw; peeled: "
    "layer after layer, exact; k-buffer: so are the nearest ones; weighted: in any order, approximate; half-samples: "
    "the nearest layer lit as if it were opaque, in two of four samples (--msaa 4); or drawn opaque, and what light "
    "comes through too"};

constexpr Choice<LightOfLayers> light_of_layers_words[] = {
    {"auto", LightOfLayers::automatic}, {"lists", LightOfLayers::lists}, {"light-buffer", LightOfLayers::light_buffer}};
constexpr ChoiceSetting<LightOfLayers> light_of_layers_set{"layer-light", light_of_layers_words, "auto",
                                                           "peeled, k-buffer: a layer's fragments walk lists of their "
                                                           "place, or each layer has a light pre-pass of its own; "
                                                           "auto: that where there are many lights"};

} // namespace

std::vector<SettingInfo> transparency_settings(bool lit_later) {
    SettingInfo transparency = transparency_setting.info();
    if (!lit_later)
        std::erase(transparency.values, transparency_setting.word(Transparency::half_samples));
    return {
        transparency,
        {"blended-lights",
         {"1", "2", "3", "4", "5", "6", "7", "8"},
         "8",
         "transparency=sorted: lights that one draw of a blended object takes"},
        {"peeled-layers",
         {"auto", "1 … 256"},
         "auto",
         "transparency=peeled: the farthest layers of a pixel that are drawn one by one, nearer ones object by "
         "object; auto: as many as there are"},
        {"k-buffer-layers",
         {"2", "3", "4", "5", "6", "7", "8"},
         "4",
         "transparency=k-buffer: the nearest layers of a pixel that are drawn one by one, over the weighted mean of "
         "the rest"}};
}

void resolve_transparency(Settings& settings, const gpu::Context& context, const RenderOptions& options) {
    if (transparency(settings) == Transparency::half_samples)
        check_half_samples(options);
    if (needs_lists(transparency(settings)) && context.features().shuffle_lanes == 0)
        settings.fall_back(transparency_setting.key, transparency_setting.word(Transparency::sorted),
                           context.name() +
                               " cannot build light lists, which need shuffles within subgroups of at most 64");
}

Transparency transparency(const Settings& settings) {
    return settings.has(transparency_setting.key) ? settings.value(transparency_setting) : Transparency::opaque;
}

std::string transparency_word(Transparency one) { return transparency_setting.word(one); }

std::optional<uint32_t> peeled_layers(const Settings& settings) {
    if (settings.is("peeled-layers", "auto"))
        return {};
    return static_cast<uint32_t>(settings.number("peeled-layers"));
}

SettingInfo light_of_layers_setting() { return light_of_layers_set.info(); }

LightOfLayers light_of_layers(const Settings& settings) {
    return settings.has(light_of_layers_set.key) ? settings.value(light_of_layers_set) : LightOfLayers::lists;
}

void resolve_light_of_layers(Settings& settings, LightOfLayers taken, const std::string& why) {
    settings.resolve(light_of_layers_set, taken, why);
}

uint32_t k_buffer_layers(const Settings& settings) { return static_cast<uint32_t>(settings.number("k-buffer-layers")); }

uint32_t blended_lights(const Settings& settings) { return static_cast<uint32_t>(settings.number("blended-lights")); }

} // namespace prelight
