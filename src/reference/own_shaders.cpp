// The built-in materials, from their equations in docs/materials.md.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <image/luminance.hpp>
#include <prelight/error.hpp>
#include <prelight/material_shader.hpp>
#include <reference/own_shaders.hpp>
#include <reference/transmission.hpp>

namespace prelight::reference {
namespace {

glm::dvec4 parameter(const Material& material, const char* name) {
    const auto given = material.parameters.find(name);
    if (given != material.parameters.end())
        return glm::dvec4(given->second);
    const MaterialParameter* declared = material.shader->find_parameter(name);
    if (!declared)
        throw Error(fmt::format("reference: {} has no parameter {}", material.shader->name, name));
    return glm::dvec4(declared->default_value);
}

/// Hermite interpolation between two edges.
double hermite(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

double facing(const Surface& surface) { return glm::dot(surface.normal, surface.view); }

struct Colours {
    glm::dvec3 diffuse{0}, f0{0};
};

Colours colours_of(const Surface& s) {
    return {s.base_colour * (1 - s.metallic), glm::mix(glm::dvec3(0.04), s.base_colour, s.metallic)};
}

/// Lights on metallic-roughness; Schlick's Fresnel at the lights' mean.
glm::dvec3 lamps_on(const OwnLight& light, const Colours& c) {
    const glm::dvec3 at_diffuse = c.f0 + (1.0 - c.f0) * light.grazing_diffuse;
    const glm::dvec3 at_specular = c.f0 + (1.0 - c.f0) * light.grazing_specular;
    return c.diffuse * (1.0 - at_diffuse) * light.diffuse + at_specular * light.specular;
}

/// What a mirror of this roughness shows, with occlusion.
glm::dvec3 mirrored(const OwnLight& light, double roughness) {
    const Surface& s = light.surface;
    return light.environment->mirrored(mirror_direction(s.normal, s.view, roughness), roughness) * light.openness;
}

/// The environment's reflection by a surface of this roughness; nothing without one.
glm::dvec3 environment_on(const OwnLight& light, glm::dvec3 f0, double roughness, double f90 = 1) {
    if (!light.environment)
        return glm::dvec3(0);
    return environment_share(f0, f90, roughness, std::clamp(facing(light.surface), 0.0, 1.0)) *
           mirrored(light, roughness);
}

/// Ambient light: the environment, or what comes from everywhere.
glm::dvec3 ambient_on(const OwnLight& light, const Colours& c) {
    if (!light.environment)
        return light.ambient * (c.diffuse + c.f0);
    return light.ambient * c.diffuse + environment_on(light, c.f0, light.surface.environment_roughness);
}

glm::dvec3 metallic_roughness(const OwnLight& light) {
    const Colours c = colours_of(light.surface);
    return lamps_on(light, c) + ambient_on(light, c) + light.surface.emissive;
}

/// Metallic-roughness of which gloss leaves part of what it reflects; the rest reaches the diffuse layer.
glm::dvec3 detailed(const OwnLight& light) {
    const Surface& s = light.surface;
    const Colours c = colours_of(s);
    const auto fresnel = [&](double grazing) { return s.gloss * (c.f0 + (1.0 - c.f0) * grazing); };
    const glm::dvec3 around =
        light.environment ? environment_on(light, c.f0, s.environment_roughness) : light.ambient * c.f0;
    return c.diffuse * ((1.0 - fresnel(light.grazing_diffuse)) * light.diffuse + light.ambient) +
           fresnel(light.grazing_specular) * light.specular + s.gloss * around + s.emissive;
}

glm::dvec3 blinn_phong(const OwnLight& light) {
    const Colours c = colours_of(light.surface);
    return c.diffuse * light.diffuse + c.f0 * light.specular + ambient_on(light, c) + light.surface.emissive;
}

glm::dvec3 skin(const OwnLight& light) {
    const Material& m = *light.surface.shaded;
    const double roll_off = parameter(m, "roll_off").x, glow = parameter(m, "glow").x;
    const double lit = luminance(light.diffuse) * light.exposure;
    double amount = std::max(hermite(-roll_off, 1, lit) - hermite(0, 1, lit), 0.0);
    amount *= glow + (1 - glow) * hermite(0, std::max(roll_off, 0.001), lit);
    const glm::dvec3 under = amount * glm::dvec3(parameter(m, "subsurface_colour")) / light.exposure;
    return light.surface.base_colour * (light.diffuse + light.ambient) + under +
           (0.04 + 0.96 * light.grazing_specular) * light.specular +
           environment_on(light, glm::dvec3(0.04), light.surface.environment_roughness) + light.surface.emissive;
}

glm::dvec3 minnaert(const OwnLight& light) {
    const double k = parameter(*light.surface.shaded, "k").x;
    const double lit = luminance(light.diffuse) * light.exposure, nv = std::clamp(facing(light.surface), 0.05, 1.0);
    const double factor = lit > 0 ? std::pow(lit, k) / lit * std::pow(nv, 1 - k) : 0;
    return light.surface.base_colour * (factor * light.diffuse + light.ambient) + light.surface.emissive;
}

glm::dvec3 reflection(const OwnLight& light) {
    const Surface& s = light.surface;
    const Colours c = colours_of(s);
    const double roughness = s.environment_roughness;
    const glm::dvec3 shown = light.environment ? mirrored(light, roughness) : light.ambient * s.occlusion;
    const double nv = std::clamp(facing(s), 0.0, 1.0);
    const glm::dvec3 share =
        light.environment ? environment_share(c.f0, 1, roughness, nv) : uniform_share(c.f0, roughness, nv);
    return lamps_on(light, c) + c.diffuse * light.ambient + parameter(*s.shaded, "strength").x * share * shown +
           s.emissive;
}

glm::dvec3 fresnel_rim(const OwnLight& light) {
    const Material& m = *light.surface.shaded;
    const double edge = std::pow(std::clamp(1 - facing(light.surface), 0.0001, 1.0), parameter(m, "power").x);
    const double lit = parameter(m, "lit").x;
    const glm::dvec3 source = (1 - lit) * glm::dvec3(1) + lit * (light.diffuse + light.ambient);
    return metallic_roughness(light) + parameter(m, "rim").x * edge * glm::dvec3(parameter(m, "rim_colour")) * source;
}

/// KHR_materials_specular, _ior, _clearcoat, _sheen, _transmission, _volume from one sum of specular light
/// (docs/materials.md).
glm::dvec3 layered(const OwnLight& light) {
    const Surface& s = light.surface;
    const SurfaceLayers& layers = s.layers;
    const double part = (layers.ior - 1) / (layers.ior + 1);
    const glm::dvec3 f0 = glm::mix(glm::min(part * part * layers.specular_colour, glm::dvec3(1)) * layers.specular,
                                   s.base_colour, s.metallic);
    const double f90 = layers.specular + (1 - layers.specular) * s.metallic;
    const auto fresnel = [&](double grazing) { return f0 + (f90 - f0) * grazing; };
    const double nv = std::clamp(facing(s), 0.0, 1.0);
    // Opaque forms know of no transmission: there is nothing behind.
    const double transmission = layers.shows_behind ? layers.transmission : 0;
    const glm::dvec3 body_colour = s.base_colour * (1 - s.metallic), colour = body_colour * (1 - transmission);
    const glm::dvec3 through = body_colour * transmission * (1.0 - fresnel(std::pow(1 - nv, 5))) *
                               (layers.behind + transmittance(s) * light.through);
    const glm::dvec3 ambient = light.environment ? glm::dvec3(0) : light.ambient;
    const glm::dvec3 body = colour * (1.0 - fresnel(light.grazing_diffuse)) * light.diffuse +
                            fresnel(light.grazing_specular) * light.specular + ambient * (colour + f0) + s.emissive +
                            through;
    const double cloth = std::pow(std::max(1 - nv, 0.0001), 1 + 3 * (1 - layers.sheen_roughness));
    const glm::dvec3 sheen = layers.sheen_colour * cloth;
    const double strongest = std::max({sheen.r, sheen.g, sheen.b});
    const glm::dvec3 dressed = body * (1 - strongest) + sheen * (light.diffuse + ambient);
    const double coat = layers.clearcoat * (0.04 + 0.96 * light.grazing_specular);
    const glm::dvec3 out = dressed * (1 - coat) + coat * light.specular + 0.04 * layers.clearcoat * ambient;
    if (!light.environment)
        return out;
    // Body and coat mirror it each with a roughness of its own.
    const glm::dvec3 around =
        (colour * light.ambient + environment_on(light, f0, layers.body_roughness, f90)) * (1 - strongest) +
        sheen * light.ambient;
    const glm::dvec3 on_coat = layers.clearcoat * environment_share(glm::dvec3(0.04), 1, layers.coat_roughness, nv);
    return out + around * (1.0 - on_coat) + on_coat * mirrored(light, layers.coat_roughness);
}

/// KHR_materials_pbrSpecularGlossiness.
glm::dvec3 specular_glossiness(const OwnLight& light) {
    const DiffuseAndSpecular& own = light.surface.specular_glossiness;
    const Colours c{own.diffuse, own.f0};
    return lamps_on(light, c) + ambient_on(light, c) + light.surface.emissive;
}

} // namespace

glm::dvec3 shade_own(const OwnLight& light) {
    const MaterialShader& shader = *light.surface.shaded->shader;
    if (shader.file.empty()) {
        if (shader.name == "metallic-roughness")
            return metallic_roughness(light);
        if (shader.name == "detailed")
            return detailed(light);
        if (shader.name == "blinn-phong")
            return blinn_phong(light);
        if (shader.name == "skin")
            return skin(light);
        if (shader.name == "minnaert")
            return minnaert(light);
        if (shader.name == "reflection")
            return reflection(light);
        if (shader.name == "fresnel-rim")
            return fresnel_rim(light);
        if (shader.name == "layered")
            return layered(light);
        if (shader.name == "specular-glossiness")
            return specular_glossiness(light);
    }
    throw Error(fmt::format("reference: {}: it knows the built-in materials alone",
                            shader.file.empty() ? shader.name : shader.file));
}

} // namespace prelight::reference
