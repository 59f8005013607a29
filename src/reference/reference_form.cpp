#include <cstdlib>
#include <prelight/reference.hpp>

namespace prelight {
namespace {

using InForce = std::map<std::string, std::string>;

bool says(const InForce& settings, const char* key, const char* value) {
    const auto found = settings.find(key);
    return found != settings.end() && found->second == value;
}

/// "none", a number, or a fraction.
double inferred_scale(const std::string& word) {
    char* end = nullptr;
    const double above = std::strtod(word.c_str(), &end);
    return *end == '/' ? above / std::strtod(end + 1, nullptr) : above;
}

ReferenceSamples samples_form(const InForce& settings, uint32_t count) {
    using Rate = ReferenceSamples::Rate;
    ReferenceSamples form{.count = count};
    if (count == 1)
        return form;
    const bool forward = !settings.contains("msaa-light");
    if (forward && !says(settings, "msaa-material", "sample")) {
        form.light = ReferenceSamples::Light::fragment;
        form.material = form.geometry = Rate::fragment;
    } else if (!forward) {
        form.geometry = says(settings, "msaa-geometry", "sample") ? Rate::sample : Rate::fragment;
        if (says(settings, "msaa-light", "pixel"))
            form.light = ReferenceSamples::Light::pixel;
        else if (!says(settings, "msaa-light", "samples"))
            form.light = ReferenceSamples::Light::edges;
        form.colours_apart = settings.contains("g-buffer") && form.light != ReferenceSamples::Light::sample;
        if (says(settings, "msaa-material", "fragment") || settings.contains("g-buffer"))
            form.material = Rate::fragment;
    }
    form.shadows_per_pixel = says(settings, "msaa-shadows", "pixel");
    return form;
}

} // namespace

ReferenceForm reference_form(Shading shading, const InForce& settings, uint32_t samples) {
    const auto is = [&](const char* key, const char* value) { return says(settings, key, value); };
    using Fresnel = ReferenceForm::Fresnel;
    ReferenceForm form;
    form.shading = shading;
    form.fresnel = is("model", "weighted") ? Fresnel::weighted
                   : is("model", "nv")     ? Fresnel::nv
                   : is("model", "mono")   ? Fresnel::mono
                                           : Fresnel::full;
    form.mono_specular = is("model", "mono");
    form.grey_reflectance = is("g-buffer", "killzone2");
    form.gate_by_step = is("specular-gate", "step");
    form.reflection_vector = is("specular-vector", "reflection");
    form.ambient_as_light = is("ambient", "light");
    form.shadows = is("shadows", "on");
    form.specular_antialiasing = is("specular-antialiasing", "on");
    form.bilinear_level0 = !is("texture-filter", "trilinear");
    if (settings.contains("ssao") && !is("ssao", "off"))
        form.occlusion_radius = std::strtod(settings.at("ssao-radius").c_str(), nullptr);
    using Own = ReferenceForm::OwnShaders;
    form.own_shaders = settings.contains("g-buffer") ? Own::no_lights
                       : is("lights-per-pass", "1")  ? Own::each_light
                                                     : Own::sums;
    using Specular = ReferenceForm::Specular;
    if (shading == Shading::phong)
        form.specular = is("specular", "luv")             ? Specular::luv
                        : is("specular", "fifth-channel") ? Specular::fifth_channel
                        : is("specular", "luminance")     ? Specular::luminance
                        : is("specular", "bent")          ? Specular::bent
                                                          : Specular::stored;
    if (settings.contains("transparency") && !is("transparency", "opaque"))
        form.transparency = ReferenceForm::Transparency::layers;
    if (const auto scale = settings.find("inferred-scale"); scale != settings.end())
        form.inferred_scale = inferred_scale(scale->second);
    if (is("inferred-layers", "on"))
        form.transparency = ReferenceForm::Transparency::layers;
    form.half_samples = samples == 4 && is("transparency", "half-samples");
    using Shadows = ReferenceForm::TransparentShadows;
    form.transparent_shadows = is("transparent-shadows", "opaque") ? Shadows::opaque
                               : is("transparent-shadows", "none") ? Shadows::none
                                                                   : Shadows::filtered;
    form.samples = samples_form(settings, samples);
    if (samples > 1 && form.transparency == ReferenceForm::Transparency::layers && !is("msaa-layers", "sample"))
        form.samples.layers = ReferenceSamples::Rate::fragment;
    return form;
}

} // namespace prelight
