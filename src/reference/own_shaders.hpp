#pragma once
#include <reference/environment.hpp>
#include <reference/surface.hpp>

namespace prelight::reference {

/// What a material's shader is given, none of it exposed.
struct OwnLight {
    const Surface& surface;
    glm::dvec3 diffuse{0};  ///< what a white Lambert surface sends on
    glm::dvec3 specular{0}; ///< what a mirror-coloured surface sends on
    glm::dvec3 ambient{
        0}; ///< radiance from everywhere, or what a white wall sends on of the environment; with occlusion
    glm::dvec3 through{0};                            ///< what lamps behind a transmissive surface send to its front
    double grazing_diffuse = 0, grazing_specular = 0; ///< mean (1 − V·H)⁵
    double exposure = 1;                              ///< for materials whose look depends on how bright the picture is
    const EnvironmentLight* environment = nullptr;
    double openness = 1; ///< what occlusion leaves of the environment's reflection
};

/// The built-in materials' equations (docs/materials.md), not exposed. Throws Error for one that is not built in.
glm::dvec3 shade_own(const OwnLight& light);

} // namespace prelight::reference
