#pragma once
#include <glm/vec3.hpp>
#include <prelight/scene.hpp>

namespace prelight::reference {

/// The scene's environment, as mirrors of any roughness show it.
class EnvironmentLight {
public:
    /// `environment` may be null.
    explicit EnvironmentLight(const Environment* environment) : environment_(environment) {}
    bool there() const { return environment_ != nullptr; }
    /// Radiance from a direction.
    glm::dvec3 radiance(glm::dvec3 direction) const;
    /// The mean over a mirror's lobe around `direction`, as a viewer there sees it along the normal: half
    /// vectors by D N·H, each light weighted by N·L.
    glm::dvec3 mirrored(glm::dvec3 direction, double roughness) const;

    /// What a white Lambert surface sends on: the mean over the hemisphere around `normal`, weighted by cosine.
    glm::dvec3 lambert(glm::dvec3 normal) const;

private:
    const Environment* environment_;
};

} // namespace prelight::reference
