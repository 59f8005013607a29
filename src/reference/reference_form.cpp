#include <cstdlib>
#include <prelight/reference.hpp>

namespace prelight {

ReferenceForm reference_form(Shading shading, const std::map<std::string, std::string>& settings) {
    const auto is = [&](const char* key, const char* value) {
        const auto found = settings.find(key);
        return found != settings.end() && found->second == value;
    };
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
    return form;
}

} // namespace prelight
