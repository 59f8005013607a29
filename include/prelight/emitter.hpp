#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <prelight/glm_defaults.hpp>
#include <vector>

namespace prelight {

/// What a particle is drawn as: an octahedron, drawn out along its way; or a square that faces the camera, for smoke,
/// fog and glare.
enum class ParticleShape { octahedron, billboard };

/// A fountain of glowing particles, each of them a point light. It always has `count` of them: a particle whose
/// life ends begins a new one, thrown anew. Where each is at a time is a closed form of that time, the emitter's
/// node at that time, the seed and the particle's number, so that any frame can be drawn by itself.
///
/// A particle is thrown from within `radius` of the node's origin into a cone around the node's −Z axis (the
/// node's scale does not matter); from then on it moves in the world's axes, under gravity along −Y, and
/// either in air that holds it back (`drag`) or bouncing on a horizontal plane (`ground`). Particles move along
/// with their node.
struct Emitter {
    uint32_t count = 64;           ///< particles at any time, 1 … 65,536
    uint64_t seed = 1;             ///< another one throws other particles
    float lifetime_from = 1;       ///< seconds, > 0; each particle's own, between this
    float lifetime_to = 2;         ///< and this
    float speed_from = 2;          ///< metres a second, ≥ 0; each particle's own, between this
    float speed_to = 4;            ///< and this
    float cone = 0.5f;             ///< radians from the axis, 0 … π; directions even over the solid angle
    float radius = 0;              ///< metres ≥ 0: of the ball that particles start in
    float gravity = 9.81f;         ///< metres a second², along −Y; may be negative (smoke)
    float drag = 0;                ///< 1/s ≥ 0: dv/dt = gravity − drag · v; not with `ground`
    std::optional<float> ground{}; ///< height in the world, metres: what falls on it bounces; needs gravity > 0
    float bounce = 0.4f;           ///< 0 … 1: vertical speed that a bounce leaves
    float slip = 0.7f;             ///< 0 … 1: horizontal speed that a bounce leaves
    /// Colours at even steps of a life, the first at birth, the last at its end; linear RGB ≥ 0, at least one.
    std::vector<glm::vec3> colours{glm::vec3(1)};
    float intensity = 1; ///< candela of a light whose colour is 1
    float range = 1;     ///< metres > 0, finite
    bool lights = true;  ///< its particles are lights; else they are drawn and no more
    float size = 0.01f;  ///< metres ≥ 0: radius of what is drawn; 0: nothing is
    float streak = 0;    ///< seconds ≥ 0: how much of an octahedron's way is drawn, along its velocity
    /// Index into Scene::materials, drawn with vertex colours: the colour over life, scaled to a largest channel of at
    /// most 1, and the opacity over life as alpha. Texture coordinates of octahedra are (age ÷ lifetime, number ÷
    /// count), and their material is meant to be unlit; those of billboards are the corners of the picture.
    uint32_t material = 0;
    bool casts_shadow = false;                       ///< its lights do
    ParticleShape shape = ParticleShape::octahedron; ///< what is drawn
    std::vector<float> sizes{1};     ///< factors ≥ 0 on `size`, at even steps of a life as `colours`; at least one
    std::vector<float> opacities{1}; ///< 0 … 1, likewise; alpha of the vertices
    /// Radians a second ≥ 0, of billboards, which are turned anyhow: each by its own speed between −spin and +spin.
    float spin = 0;
};

} // namespace prelight
