#include "sample_settings.hpp"

namespace prelight {
namespace {

constexpr Choice<gpu::SampleShading> material_words[] = {{"fragment", gpu::SampleShading::fragment},
                                                         {"sample", gpu::SampleShading::sample}};
constexpr ChoiceSetting<gpu::SampleShading> material_setting{
    "msaa-material", material_words, "fragment",
    "several samples a pixel: surfaces are shaded once a fragment, which is what a triangle covers of a pixel, or once "
    "a sample"};

using passes::SampleLight;
constexpr Choice<SampleLight> light_words[] = {
    {"edges", SampleLight::edges}, {"samples", SampleLight::samples}, {"pixel", SampleLight::pixel}};
constexpr ChoiceSetting<SampleLight> light_setting{"msaa-light", light_words, "edges",
                                                   "several samples a pixel: what is lit by itself: the samples of "
                                                   "edge pixels, all samples, or (pixel) no more than a pixel"};

constexpr Choice<bool> shadows_words[] = {{"sample", false}, {"pixel", true}};
constexpr ChoiceSetting<bool> shadows_setting{"msaa-shadows", shadows_words, "sample",
                                              "several samples a pixel: shadows wherever lights are evaluated, or once "
                                              "for the whole pixel, whatever its samples show"};

} // namespace

SettingInfo msaa_light_setting(bool once) {
    SettingInfo info = light_setting.info();
    if (!once)
        std::erase(info.values, light_setting.word(SampleLight::pixel));
    return info;
}

SampleLight sample_light(const Settings& settings) { return settings.value(light_setting); }

SettingInfo msaa_shadows_setting() { return shadows_setting.info(); }

bool shadows_per_pixel(const Settings& settings) { return settings.value(shadows_setting); }

void resolve_sample_settings(Settings& settings, const gpu::Context& context, uint32_t samples) {
    if (samples == 1)
        return;
    const auto give_way = [&](const char* key, const char* value, const char* why) {
        if (settings.has(key) && !settings.is(key, value))
            settings.fall_back(key, value, why);
    };
    give_way("depth", "attachment", "with several samples a pixel their depth is read from the attachment");
    give_way("roughness", "normal", "with several samples a pixel roughness is stored with the normals");
    if (settings.is("shadows", "on") && sample_light(settings) != SampleLight::pixel)
        give_way("shadow-memory", "atlas", "edge samples are lit by all lights at once");
    give_way("g-buffer", "wide", "with several samples a pixel a G-buffer is wide");
    give_way("accumulation", "rgba16f", "with several samples a pixel light is added up in half floats");
    if (settings.has(material_setting.key) && sample_light(settings) != SampleLight::pixel &&
        !context.features().centre_depth)
        give_way(material_setting.key, "sample",
                 "the driver does not tell a fragment's depth under the pixel's centre");
    if (settings.has("g-buffer"))
        give_way("ssao", "off", "with several samples a pixel deferred shading has no occlusion of ambient light");
}

gpu::SampleShading material_shading(const Settings& settings) { return settings.value(material_setting); }

SettingInfo msaa_material_setting() { return material_setting.info(); }

} // namespace prelight
