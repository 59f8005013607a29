#pragma once
#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <prelight/scene.hpp>
#include <vector>

namespace prelight::reference {

/// The scene's environment, as mirrors of any roughness and white walls show it.
class EnvironmentLight {
public:
    /// `environment` may be null.
    explicit EnvironmentLight(const Environment* environment);
    bool there() const { return environment_ != nullptr; }
    bool is_background() const { return environment_ && environment_->background; }
    /// Radiance from a direction: the map's texels, bilinear.
    glm::dvec3 radiance(glm::dvec3 direction) const { return blurred(direction, 0); }
    /// What is seen there behind everything: the same, or the backdrop's texels.
    glm::dvec3 background(glm::dvec3 direction) const;
    /// The mean over a mirror's lobe around `direction`, as a viewer there sees it along the normal: half
    /// vectors by D N·H, each light weighted by N·L. For the roughnesses 0 and 1/8 · 2^(i/4) up to 1; between two of
    /// them mixed, as what is prefiltered has to be.
    glm::dvec3 mirrored(glm::dvec3 direction, double roughness) const;
    /// What a white Lambert surface sends on, from the map's harmonics of degree 0 … 2: the mean over the
    /// hemisphere around `normal`, weighted by cosine, within a few percent.
    glm::dvec3 lambert(glm::dvec3 normal) const;

private:
    /// mirrored(), for any roughness by itself.
    glm::dvec3 lobe(glm::dvec3 direction, double roughness) const;
    /// The map averaged over `level` doublings of its texels.
    glm::dvec3 blurred(glm::dvec3 direction, double level) const;
    void take_moments();

    struct Level {
        uint32_t width = 0, height = 0;
        std::vector<glm::dvec3> texels;
        glm::dvec3 bilinear(double longitude, double latitude) const;
    };
    Level level_of(const Image& image) const;
    /// Of a direction, in the map that is turned as the environment is.
    glm::dvec3 look(const Level& level, glm::dvec3 direction) const;

    const Environment* environment_;
    Level backdrop_;            ///< nothing: as the map
    std::vector<Level> levels_; ///< each half of the one before; with intensity
    /// ∫ L dω, ∫ L d dω and ∫ L d dᵀ dω over all directions d, by colour.
    glm::dvec3 zeroth_{0};
    std::array<glm::dvec3, 3> first_{};
    std::array<glm::dmat3, 3> second_{glm::dmat3(0), glm::dmat3(0), glm::dmat3(0)};
};

/// Where a mirror looks: its lobe leans from the reflection of `view` towards the normal, the rougher the more, by
/// roughness⁴. That brings the split sum nearer to the true integral (tests/reference/environment_test.cpp).
glm::dvec3 mirror_direction(glm::dvec3 normal, glm::dvec3 view, double roughness);
/// What a surface sends on of what its mirror shows, for F0 and F90: ∫ D V F N·L over a uniform environment, with glTF
/// 2.0's D and V and Schlick's F. From a table with 65 × 65 entries.
glm::dvec3 environment_share(glm::dvec3 f0, double f90, double roughness, double nv);
/// The same without a map, as `reflection` has it: Karis' fit, "Physically Based Shading on Mobile", 2014.
glm::dvec3 uniform_share(glm::dvec3 f0, double roughness, double nv);

/// What is left of a mirror's light where `visibility` of ambient light comes through: Lagarde and de Rousiers, "Moving
/// Frostbite to Physically Based Rendering", 2014.
double mirror_visibility(double nv, double visibility, double roughness);

} // namespace prelight::reference
