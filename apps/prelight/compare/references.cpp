#include "references.hpp"

namespace prelight::app {
namespace {

std::string samples_name(const ReferenceSamples& samples) {
    using Light = ReferenceSamples::Light;
    using Rate = ReferenceSamples::Rate;
    std::string name = ", " + std::to_string(samples.count) + " samples a pixel";
    name += samples.light == Light::pixel      ? ", light once a pixel"
            : samples.light == Light::edges    ? ", light once a surface of a pixel"
            : samples.light == Light::fragment ? ", light once a fragment"
                                               : "";
    if (samples.material == Rate::fragment)
        name += ", materials once a fragment";
    if (samples.geometry == Rate::fragment)
        name += ", normals once a fragment";
    if (samples.shadows_per_pixel)
        name += ", shadows once a pixel";
    return name;
}

} // namespace

std::string form_name(const ReferenceForm& form) {
    using Fresnel = ReferenceForm::Fresnel;
    std::string name;
    if (form.shading == Shading::ggx)
        name = form.fresnel == Fresnel::weighted ? "ggx, Fresnel weighted over the lights"
               : form.fresnel == Fresnel::nv     ? "ggx, Fresnel at N·V"
               : form.fresnel == Fresnel::mono   ? "ggx, Fresnel at N·V, monochrome specular light"
                                                 : "ggx, Fresnel of each light";
    else
        name = form.mono_specular ? "phong, monochrome specular light" : "phong";
    if (form.shading == Shading::phong && form.gate_by_step)
        name += ", specular light gated by a step";
    if (form.shading == Shading::phong && form.reflection_vector)
        name += ", reflection vector";
    if (form.ambient_as_light)
        name += ", ambient as a light";
    if (form.grey_reflectance)
        name += ", grey reflectance";
    using Way = ReferenceForm::Specular;
    name += form.specular == Way::luv             ? ", specular=luv"
            : form.specular == Way::fifth_channel ? ", specular=fifth-channel"
            : form.specular == Way::luminance     ? ", specular=luminance"
            : form.specular == Way::bent          ? ", specular=bent"
                                                  : "";
    if (form.half_samples)
        name += ", the nearest layer in half of the samples";
    if (form.samples.count > 1)
        name += samples_name(form.samples);
    return name;
}

const References::Picture& References::of(const ReferenceForm& form) {
    for (const auto& [known, picture] : made_)
        if (known == form)
            return picture;
    ReferencePicture picture =
        render_reference(world_, camera_, options_.width, options_.height, options_.exposure, form);
    std::vector<uint8_t> left_out = picture.left_out();
    return made_.emplace_back(form, Picture{std::move(picture.linear), std::move(left_out)}).second;
}

} // namespace prelight::app
