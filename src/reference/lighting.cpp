#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <image/luminance.hpp>
#include <numbers>
#include <reference/lighting.hpp>
#include <reference/transmission.hpp>

namespace prelight::reference {
namespace {

using std::numbers::pi;

double clamped_dot(glm::dvec3 a, glm::dvec3 b) { return std::clamp(glm::dot(a, b), 0.0, 1.0); }

double fifth_power(double x) { return x * x * x * x * x; }

/// F0 + (1 − F0)·s, Schlick 1994 with s = (1 − cos)⁵.
glm::dvec3 schlick(glm::dvec3 f0, double s) { return f0 + (1.0 - f0) * s; }

glm::dvec3 half_vector(glm::dvec3 to_light, glm::dvec3 view) {
    const glm::dvec3 sum = to_light + view;
    const double length = glm::length(sum);
    return length > 0 ? sum / length : glm::dvec3(0);
}

} // namespace

Lighting::Lighting(const ReferenceForm& form, const Surface& surface, double exposure,
                   const EnvironmentLight* environment)
    : form_(form), surface_(surface), diffuse_colour_(surface.base_colour * (1 - surface.metallic)),
      material_f0_(glm::mix(glm::dvec3(0.04), surface.base_colour, surface.metallic)),
      f0_(surface.gloss * (form.grey_reflectance ? glm::dvec3(luminance(material_f0_)) : material_f0_)),
      alpha_(surface.roughness * surface.roughness), exponent_(std::max(2 / (alpha_ * alpha_) - 2, 0.0)),
      exposure_(exposure), environment_(environment) {}

double Lighting::cosine(const Incident& light) const { return clamped_dot(surface_.normal, light.to_light); }

bool Lighting::comes_through(const Incident& light) const {
    return surface_.layers.shows_behind && glm::dot(surface_.normal, light.to_light) < 0;
}

bool Lighting::is_lit_by(const Incident& light) const {
    return light.radiance != glm::dvec3(0) && (cosine(light) > 0 || comes_through(light));
}

void Lighting::add(const Incident& light) {
    if (!is_lit_by(light))
        return;
    ++sums_.contributing;
    if (comes_through(light)) { // as a mirror's highlight, seen from the light's side
        Surface other = surface_;
        other.normal = -surface_.normal;
        other.view = glm::reflect(surface_.view, surface_.normal);
        other.roughness = std::max(roughness_through(surface_, surface_.roughness), 0.089);
        Lighting behind(form_, other, exposure_);
        behind.add_one(light, behind.cosine(light));
        sums_.through += behind.sums_.specular;
        return;
    }
    const double nl = cosine(light);
    if (surface_.shaded && form_.own_shaders == ReferenceForm::OwnShaders::each_light) {
        Lighting one(form_, surface_, exposure_, environment_);
        one.add_one(light, nl);
        each_ += one.own_shader(one.sums_, glm::dvec3(0), true, false) - own_shader({}, glm::dvec3(0), true, false);
    }
    add_one(light, nl);
}

void LightSums::add(const LightSums& other, double share) {
    diffuse += share * other.diffuse;
    specular += share * other.specular;
    weight += share * other.weight;
    diffuse_fresnel += share * other.diffuse_fresnel;
    specular_fresnel += share * other.specular_fresnel;
    through += share * other.through;
    full += share * other.full;
    contributing = std::max(contributing, other.contributing);
}

void Lighting::take(const Lighting& other, double share) {
    sums_.add(other.sums_, share);
    each_ += share * other.each_;
}

void Lighting::add_one(const Incident& light, double nl) {
    if (form_.shading == Shading::ggx)
        add_ggx(light, nl);
    else
        add_phong(light, nl);
}

// glTF 2.0, appendix B.3: Trowbridge-Reitz distribution, separable Smith visibility, Schlick.
void Lighting::add_ggx(const Incident& light, double nl) {
    const glm::dvec3 half = half_vector(light.to_light, surface_.view);
    const double nv = std::clamp(glm::dot(surface_.normal, surface_.view), 1e-4, 1.0);
    const double nh = clamped_dot(surface_.normal, half);
    const double s = fifth_power(1 - clamped_dot(surface_.view, half));

    const double a2 = alpha_ * alpha_;
    const double spread = nh * nh * (a2 - 1) + 1;
    const double distribution = a2 / (pi * spread * spread);
    const double visibility =
        1 / ((nl + std::sqrt(a2 + (1 - a2) * nl * nl)) * (nv + std::sqrt(a2 + (1 - a2) * nv * nv)));

    const glm::dvec3 diffuse = nl * light.radiance;
    const glm::dvec3 specular = diffuse * (distribution * visibility);
    sums_.diffuse += diffuse;
    sums_.specular += specular;
    sums_.diffuse_fresnel += luminance(diffuse) * s;
    sums_.specular_fresnel += luminance(specular) * s;
    const glm::dvec3 fresnel = schlick(f0_, s);
    sums_.full += diffuse_colour_ / pi * (1.0 - fresnel) * diffuse + fresnel * specular;
}

// Engel's equation 8.5.1/8.5.2 with the choices of systems.md.
void Lighting::add_phong(const Incident& light, double nl) {
    double cosine = 0;
    if (form_.reflection_vector) {
        const glm::dvec3 reflected = 2 * nl * surface_.normal - light.to_light;
        cosine = clamped_dot(reflected, surface_.view);
    } else {
        cosine = clamped_dot(surface_.normal, half_vector(light.to_light, surface_.view));
    }
    const double gate = form_.gate_by_step ? 1 : nl; // nl > 0 here
    const bool stored = form_.specular == ReferenceForm::Specular::stored;
    const double exponent = light.shininess * (stored ? exponent_ : 1);
    sums_.diffuse += nl * light.radiance;
    sums_.specular += gate * std::pow(cosine, exponent) * light.radiance;
    sums_.weight += nl * luminance(light.radiance);
}

glm::dvec3 Lighting::compose_ggx() const {
    using Fresnel = ReferenceForm::Fresnel;
    if (form_.fresnel == Fresnel::full)
        return sums_.full;
    glm::dvec3 specular = sums_.specular;
    double s_diffuse = 0, s_specular = 0;
    if (form_.fresnel == Fresnel::weighted) {
        const double diffuse_luminance = luminance(sums_.diffuse);
        const double specular_luminance = luminance(sums_.specular);
        if (diffuse_luminance > 0)
            s_diffuse = sums_.diffuse_fresnel / diffuse_luminance;
        if (specular_luminance > 0)
            s_specular = sums_.specular_fresnel / specular_luminance;
    } else {
        s_diffuse = s_specular = fifth_power(1 - clamped_dot(surface_.normal, surface_.view));
        if (form_.fresnel == Fresnel::mono)
            specular = glm::dvec3(luminance(specular));
    }
    return diffuse_colour_ / pi * (1.0 - schlick(f0_, s_diffuse)) * sums_.diffuse + schlick(f0_, s_specular) * specular;
}

// The ways of 8.5 to apply a material's exponent mn to the lights' sum (equations 8.5.4 to 8.5.7).
glm::dvec3 Lighting::phong_specular(const LightSums& sums) const {
    using Specular = ReferenceForm::Specular;
    if (form_.specular == Specular::stored)
        return form_.mono_specular ? glm::dvec3(luminance(sums.specular)) : sums.specular;
    const double channel4 = luminance(sums.specular);
    if (channel4 <= 0)
        return glm::dvec3(0);
    const auto raised = [&](double base) { return std::pow(std::min(base, 1.0), exponent_); };
    if (form_.specular == Specular::bent)
        return glm::dvec3(raised(channel4 * exposure_) / exposure_);
    // LUV stores the luminance of diffuse light as it is, so that it differs by rounding only.
    const double weight = form_.specular == Specular::fifth_channel ? sums.weight : luminance(sums.diffuse);
    return glm::dvec3(weight > 0 ? raised(channel4 / weight) * weight : 0);
}

glm::dvec3 Lighting::own_shader(const LightSums& sums, glm::dvec3 ambient, bool lights, bool around) const {
    const EnvironmentLight* environment = around ? environment_ : nullptr;
    const bool ggx = form_.shading == Shading::ggx;
    const double at_viewer = fifth_power(1 - clamped_dot(surface_.normal, surface_.view));
    const double facing = clamped_dot(surface_.normal, surface_.view);
    const double e = luminance(sums.diffuse), s = luminance(sums.specular);
    const bool by_lamps =
        lights && ggx &&
        (form_.fresnel == ReferenceForm::Fresnel::weighted || form_.fresnel == ReferenceForm::Fresnel::full);
    return shade_own({.surface = surface_,
                      .diffuse = sums.diffuse / (ggx ? pi : 1.0),
                      .specular = !ggx                                            ? phong_specular(sums)
                                  : form_.fresnel == ReferenceForm::Fresnel::mono ? glm::dvec3(s)
                                                                                  : sums.specular,
                      .ambient = (environment ? environment->lambert(surface_.normal) : ambient) * surface_.occlusion *
                                 surface_.visibility,
                      .through = sums.through,
                      .grazing_diffuse = !by_lamps ? at_viewer
                                         : e > 0   ? sums.diffuse_fresnel / e
                                                   : 0,
                      .grazing_specular = !by_lamps ? at_viewer
                                          : s > 0   ? sums.specular_fresnel / s
                                                    : 0,
                      .exposure = exposure_,
                      .environment = environment,
                      .openness = surface_.occlusion *
                                  mirror_visibility(facing, surface_.visibility, surface_.environment_roughness)});
}

glm::dvec3 Lighting::radiance(glm::dvec3 ambient) {
    if (surface_.unlit)
        return surface_.base_colour;
    if (!surface_.shaded)
        return standard(ambient, true);
    using Own = ReferenceForm::OwnShaders;
    const bool as_light = form_.ambient_as_light && !environment_; // an environment is no light
    if (form_.own_shaders == Own::sums && !as_light)
        return own_shader(sums_, ambient, true, true);
    if (form_.own_shaders == Own::sums) {
        sums_.diffuse += form_.shading == Shading::ggx ? pi * ambient : ambient;
        return own_shader(sums_, glm::dvec3(0), true, false);
    }
    const glm::dvec3 lights = form_.own_shaders == Own::each_light ? each_ : standard(glm::dvec3(0), false);
    return lights + own_shader({}, ambient, false, true);
}

glm::dvec3 Lighting::ambient_term(glm::dvec3 ambient) const {
    if (!environment_)
        return ambient * surface_.occlusion * surface_.visibility * (diffuse_colour_ + material_f0_);
    const double nv = glm::dot(surface_.normal, surface_.view), facing = std::clamp(nv, 0.0, 1.0);
    const double roughness = surface_.environment_roughness;
    const glm::dvec3 mirrored =
        environment_->mirrored(mirror_direction(surface_.normal, surface_.view, roughness), roughness) *
        mirror_visibility(facing, surface_.visibility, roughness);
    const glm::dvec3 share = environment_share(material_f0_, 1, roughness, facing);
    return surface_.occlusion *
           (diffuse_colour_ * environment_->lambert(surface_.normal) * surface_.visibility + share * mirrored);
}

glm::dvec3 Lighting::standard(glm::dvec3 ambient, bool with_base) {
    const bool ggx = form_.shading == Shading::ggx;
    glm::dvec3 result = with_base ? surface_.emissive : glm::dvec3(0);
    if (form_.ambient_as_light && !environment_) {
        // Uniform radiance gives irradiance π·L; it comes from everywhere, so it has no half vector
        // and adds nothing to the Fresnel sums.
        const glm::dvec3 irradiance = ggx ? pi * ambient : ambient;
        sums_.diffuse += irradiance;
        sums_.full += diffuse_colour_ / pi * (1.0 - f0_) * irradiance;
    } else if (with_base) {
        result += ambient_term(ambient);
    }
    if (ggx)
        return result + compose_ggx();
    return result + diffuse_colour_ * sums_.diffuse + f0_ * phong_specular(sums_);
}

} // namespace prelight::reference
