#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <prelight/glm_defaults.hpp>
#include <vector>

namespace prelight {

/// A fountain of glowing particles, each of them a point light. It always has `count` of them: a particle whose
/// life ends begins a new one, thrown anew. Where each is at a time is a closed form of that time, the emitter's
/// node at that time, the seed and the particle's number, so that any frame can be drawn by itself.
///
/// A particle is thrown from within `radius` of the node's origin into a cone around the node's −Z axis (the
/// node's scale does not matter); from then on it moves in the world's axes, under gravity along −Y, and
/// either in air that holds it back (`drag`) or bouncing on a horizontal plane (`ground`). Particles move along
/// with their node.
struct Emitter {
    uint32_t count = 64; ///< particles at any time, 1 … 65,536
    uint64_t seed = 1;
    float lifetime_from = 1, lifetime_to = 2; ///< seconds, > 0; each particle's own, between these
    float speed_from = 2, speed_to = 4;       ///< metres a second, ≥ 0
    float cone = 0.5f;                        ///< radians from the axis, 0 … π; directions even over the solid angle
    float radius = 0;                         ///< metres ≥ 0: of the ball that particles start in
    float gravity = 9.81f;                    ///< metres a second², along −Y; may be negative (smoke)
    float drag = 0;                           ///< 1/s ≥ 0: dv/dt = gravity − drag · v; not with `ground`
    std::optional<float> ground{}; ///< height in the world, metres: what falls on it bounces; needs gravity > 0
    float bounce = 0.4f;           ///< 0 … 1: vertical speed that a bounce leaves
    float slip = 0.7f;             ///< 0 … 1: horizontal speed that a bounce leaves
    /// Colours at even steps of a life, the first at birth, the last at its end; linear RGB ≥ 0, at least one.
    std::vector<glm::vec3> colours{glm::vec3(1)};
    float intensity = 1; ///< candela of a light whose colour is 1
    float range = 1;     ///< metres > 0, finite
    float size = 0.01f;  ///< metres ≥ 0: radius of what is drawn; 0: nothing is
    float streak = 0;    ///< seconds ≥ 0: how much of its way is drawn, along its velocity
    /// Index into Scene::materials, drawn with vertex colours (the colour over life, scaled to a largest channel of
    /// at most 1), texture coordinates (age ÷ lifetime, number ÷ count). Meant for one that is unlit.
    uint32_t material = 0;
    bool casts_shadow = false; ///< its lights do
};

} // namespace prelight
