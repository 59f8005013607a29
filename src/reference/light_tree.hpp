#pragma once
#include <glm/vec3.hpp>
#include <optional>
#include <prelight/scene.hpp>
#include <reference/light_distribution.hpp>
#include <vector>

namespace prelight::reference {

/// What one light gives to one point, before the surface has a say.
struct Incident {
    glm::dvec3 to_light{0}; ///< unit, from the point towards the light
    glm::dvec3 radiance{0}; ///< attenuation × colour × intensity × what the light sends this way
    double distance = 0;    ///< metres; infinity for a directional light
    double shininess = 1;
    bool casts_shadow = true;
};

/// All lights of a world, those of finite range in a bounding-volume hierarchy of their spheres, so
/// that a point among 65,536 of them asks only the few that may reach it. No light is ever dropped.
class LightTree {
public:
    /// Positions are kept relative to `origin` (the camera), in double precision.
    LightTree(const World& world, glm::dvec3 origin);

    /// Fills `found` with the lights whose range holds `point` (relative to the origin), in a fixed
    /// order: the unbounded ones, then the others by the tree.
    void reach(glm::dvec3 point, std::vector<uint32_t>& found) const;

    /// Light `index` (of World::lights) seen from `point`; radiance is 0 where it does not reach.
    /// Falloffs: light.hpp; the spot's cone: KHR_lights_punctual; cookies and profiles: docs/cookies.md.
    /// `pixel`: metres that a pixel covers there, which picks the level of a cookie.
    Incident incident(uint32_t index, glm::dvec3 point, double pixel = 0) const;

private:
    struct Sphere {
        glm::dvec3 centre{0};
        double radius;
        uint32_t light;
    };
    struct Node {
        glm::dvec3 low{0}, high{0}; ///< box around the spheres below
        uint32_t first = 0;         ///< leaf: first sphere; inner: index of the second child
        uint32_t count = 0;         ///< spheres in a leaf; 0: inner node, first child is the next node
    };
    void build(size_t begin, size_t end);

    struct Prepared {
        LightKind kind;
        Falloff falloff;
        glm::dvec3 position{0}, direction{0}, radiance{0}; ///< radiance: colour × intensity
        double range, cos_outer, cone_scale, shininess;
        bool casts_shadow;
        std::optional<LightDistribution> distribution;
    };
    std::vector<Prepared> lights_;
    std::vector<uint32_t> unbounded_;
    std::vector<Sphere> spheres_;
    std::vector<Node> nodes_;
};

} // namespace prelight::reference
