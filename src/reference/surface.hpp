#pragma once
#include <reference/ray_scene.hpp>

namespace prelight::reference {

/// What the material `layered` knows beside metallic-roughness: factors × textures.
struct SurfaceLayers {
    double ior = 1.5, specular = 1;
    glm::dvec3 specular_colour{1}, sheen_colour{0};
    double clearcoat = 0, sheen_roughness = 0;
    double body_roughness = 1, coat_roughness = 0; ///< of each layer by itself
    double transmission = 0;
    double thickness = 0, attenuation_distance = 1; ///< metres
    glm::dvec3 attenuation_colour{1};
    bool shows_behind = false; ///< it is transmissive, and drawn as such
    glm::dvec3 behind{0};      ///< radiance from behind, with what the body takes of it
};

/// What the material `specular-glossiness` is made of.
struct DiffuseAndSpecular {
    glm::dvec3 diffuse{0}; ///< what the diffuse lobe sends on
    glm::dvec3 f0{0.04};
};

/// What the lighting model knows of a point. Directions are unit vectors in world space.
struct Surface {
    glm::dvec3 position{0};     ///< relative to the camera
    glm::dvec3 normal{0, 0, 1}; ///< shading normal, after the normal map
    glm::dvec3 view{0, 0, 1};   ///< towards the viewer
    glm::dvec3 base_colour{0};  ///< linear
    double alpha = 1;           ///< factor × texture × vertex colour, 0 … 1; layers alone heed it
    glm::dvec3 emissive{0};     ///< linear radiance
    double metallic = 0;
    double roughness = 1;             ///< perceptual, ≥ 0.089
    double environment_roughness = 1; ///< the same, without the least and the anti-aliasing of what lights see
    double gloss = 1;                 ///< of `detailed`: factor on all that it reflects
    double occlusion = 1;             ///< on ambient light; strength is worked in
    double visibility = 1;            ///< what nearby surfaces let through of ambient light
    bool unlit = false;
    SurfaceLayers layers{};
    DiffuseAndSpecular specular_glossiness{};
    const Material* shaded = nullptr; ///< the material, when it has a shader of its own
};

/// The shading normal that `evaluate_surface` finds there.
glm::dvec3 shading_normal(const RayScene& scene, const Textures& textures, const Hit& hit, glm::dvec3 view);

/// What α² grows by where normals beside it in the row and column of a quad of pixels are these:
/// ReferenceForm::specular_antialiasing.
double normal_spread(glm::dvec3 normal, glm::dvec3 across, glm::dvec3 down);
/// What lights see of the surface's roughness: as much rougher, and at least 0.089.
void set_lamp_roughness(Surface& surface, double spread);

/// Reads the material at a hit. `view` points towards the viewer; `beside`: where the rays beside it meet the surface,
/// for filters that need to know.
/// Throws Error for a material whose shader is a user's file: this knows built-in ones alone.
Surface evaluate_surface(const RayScene& scene, const Textures& textures, const Hit& hit, glm::dvec3 view,
                         const Beside* beside = nullptr);

} // namespace prelight::reference
