#pragma once
#include <glm/mat4x4.hpp>
#include <optional>
#include <prelight/scene.hpp>
#include <vector>

namespace prelight {

/// One particle at a time.
struct Particle {
    glm::dvec3 position{0}, velocity{0}; ///< world, metres and metres a second
    double share = 0;                    ///< of its life, 0 ≤ share < 1
    double age = 0;                      ///< seconds
    int64_t life = 0;                    ///< how many it has had
};

/// Particle `number` of an emitter at `node` (node → world), `time` seconds from the animations' start. A closed form:
/// equal arguments, equal bytes.
Particle particle_at(const Emitter& emitter, const glm::dmat4& node, uint32_t number, double time);

/// The colour at a share of a life.
glm::vec3 particle_colour(const Emitter& emitter, double share);

/// What an emitter shows at a time.
struct Emission {
    std::vector<PlacedLight> lights;
    std::optional<Primitive> shapes; ///< Emitter::shape, around `origin`; absent: Emitter::size is 0
    glm::dvec3 origin{0};            ///< world
};
/// `node`, `before`: node → world now and `interval` seconds earlier; without `before` nothing has moved. Throws Error
/// beginning with `object`: an emitter out of its ranges.
Emission emit(const Emitter& emitter, const glm::dmat4& node, double time, const std::optional<glm::dmat4>& before,
              double interval, const std::string& object);

} // namespace prelight
