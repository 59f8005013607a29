#pragma once
#include "against_reference.hpp"
#include <reference/worlds.hpp>

namespace prelight {

/// A floor of 12 × 12 m with five spheres of different material on it, seen from above its near
/// edge: enough curvature, overlap and horizon for every test of lights and formats.
struct Garden : TestWorld {
    Garden();
    /// `origin` moves everything, camera included.
    explicit Garden(glm::dvec3 origin);
    PlacedCamera camera;
    Light point(float range, float intensity, glm::vec3 colour = {1, 0.9f, 0.8f}) const;
    Light spot(float outer, float range, float intensity) const;
    /// `count` lights over the floor, hues in turn, each with this range.
    void add_lights(uint32_t count, float range, float intensity);
    Shot shot() const { return {.world = &world, .camera = camera}; }
    glm::dvec3 at(double x, double y, double z) const { return origin_ + glm::dvec3(x, y, z); }

private:
    glm::dvec3 origin_{0};
};

/// Low lights behind the garden, seen from low in front: V·H is small, and the forms' Fresnel terms
/// are far apart.
struct BacklitGarden : Garden {
    BacklitGarden();
};

/// At most four lights on a pixel, and no light above what eight bits hold. `grey`: no coloured metal.
struct FewLights : Garden {
    explicit FewLights(bool grey = false);
};

/// The garden with another shader on its spheres; what is metal there stays metal.
struct ShadedGarden : Garden {
    explicit ShadedGarden(std::shared_ptr<const MaterialShader> shader, uint32_t lights = 6);
    void set(const char* parameter, glm::vec4 value);
};

/// The measured light of a lamp on a wall.
std::shared_ptr<const LightProfile> wall_lamp();

/// A masked double-sided square from the front, one from behind, a mirrored one, an unlit wall and a
/// single-sided square that is turned away.
struct MixedMaterials : TestWorld {
    MixedMaterials();
    Shot shot() const { return {.world = &world, .camera = front_camera(5)}; }
};

} // namespace prelight
