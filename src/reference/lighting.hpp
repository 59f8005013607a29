#pragma once
#include <prelight/reference.hpp>
#include <reference/light_tree.hpp>
#include <reference/own_shaders.hpp>
#include <reference/surface.hpp>

namespace prelight::reference {

/// The sums of all lights at one point, equations in docs/lighting-model.md.
struct LightSums {
    glm::dvec3 diffuse{0};       ///< [ggx] E = Σ N·L·radiance; [phong] the same
    glm::dvec3 specular{0};      ///< [ggx] S = Σ N·L·radiance·D·V; [phong] Σ gate·radiance·(N·H)^n,
                                 ///< where n is the light's alone unless `specular` is stored
    double weight = 0;           ///< [phong] channel 5 of equation 8.5.5: Σ N·L·luminance(radiance)
    double diffuse_fresnel = 0;  ///< Σ luminance(E_i)·(1 − V·H)⁵
    double specular_fresnel = 0; ///< Σ luminance(S_i)·(1 − V·H)⁵
    glm::dvec3 through{0};       ///< specular sum of lights behind a transmissive surface
    glm::dvec3 full{0};          ///< `full`: Σ of the whole model, Fresnel light by light
    uint32_t contributing = 0;   ///< lights with attenuation and N·L above zero

    /// A share of others; of `contributing`, the most.
    void add(const LightSums& other, double share);
};

/// Evaluates one form of the lighting model at one surface.
class Lighting {
public:
    /// `exposure`: the factor that a picture's radiance is multiplied by; only specular=bent depends
    /// on it, for its base is what the light buffer holds.
    /// `environment`: in place of ambient radiance; null: none.
    Lighting(const ReferenceForm& form, const Surface& surface, double exposure = 1,
             const EnvironmentLight* environment = nullptr);

    /// A light that the surface turns away from, or without radiance, gives nothing and need not be added; what lies
    /// behind a transmissive surface comes through.
    bool is_lit_by(const Incident& light) const;
    void add(const Incident& light);
    /// Adds a share of what another point of the surface has gathered.
    void take(const Lighting& other, double share);
    /// The same of sums by themselves.
    void take(const LightSums& other, double share) { sums_.add(other, share); }
    /// Radiance towards the viewer, not exposed. `ambient`: radiance from everywhere, where there is no environment.
    glm::dvec3 radiance(glm::dvec3 ambient);
    const LightSums& sums() const { return sums_; }

private:
    double cosine(const Incident& light) const;
    bool comes_through(const Incident& light) const;
    void add_ggx(const Incident& light, double nl);
    void add_phong(const Incident& light, double nl);
    void add_one(const Incident& light, double nl);
    glm::dvec3 compose_ggx() const;
    /// What a shader of the material's own makes of sums of lights, and of ambient radiance.
    /// `lights`: false for what is drawn where no light is looked at.
    /// `around`: with the environment.
    glm::dvec3 own_shader(const LightSums& sums, glm::dvec3 ambient, bool lights, bool around) const;
    glm::dvec3 standard(glm::dvec3 ambient, bool with_base);
    /// What metallic-roughness and Blinn-Phong make of ambient light.
    glm::dvec3 ambient_term(glm::dvec3 ambient) const;
    glm::dvec3 phong_specular(const LightSums& sums) const;

    ReferenceForm form_;
    const Surface& surface_;
    glm::dvec3 diffuse_colour_{0}; ///< base · (1 − metallic)
    glm::dvec3 material_f0_{0};    ///< reflectance at normal incidence
    glm::dvec3 f0_{0};             ///< as lights meet it
    double alpha_;                 ///< roughness²
    double exponent_;              ///< [phong] 2/α² − 2
    double exposure_;
    const EnvironmentLight* environment_;
    LightSums sums_;
    glm::dvec3 each_{0}; ///< OwnShaders::each_light: what the lights added one by one
};

} // namespace prelight::reference
