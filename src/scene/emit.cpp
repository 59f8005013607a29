#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <prelight/error.hpp>
#include <scene/emit.hpp>
#include <scene/place_camera.hpp>
#include <scene/procedural/random.hpp>

namespace prelight {
namespace {

/// Bounces that are followed; then a particle lies still.
constexpr int most_bounces = 64;
constexpr double resting_speed = 1e-3; ///< metres a second

/// Moves by `time` seconds of free flight.
void fly(const Emitter& emitter, Particle& p, double time) {
    const glm::dvec3 gravity(0, -static_cast<double>(emitter.gravity), 0);
    const double drag = emitter.drag;
    if (drag * time < 1e-6) { // what drag does is less than rounding would make of it
        p.position += p.velocity * time + 0.5 * time * time * gravity;
        p.velocity += gravity * time;
        return;
    }
    // dv/dt = g − k v: towards g / k, by e^(−k t).
    const glm::dvec3 falling = gravity / drag, excess = p.velocity - falling;
    const double lost = -std::expm1(-drag * time);
    p.position += falling * time + excess * (lost / drag);
    p.velocity = falling + excess * (1 - lost);
}

/// Flight over a horizontal plane: each arc is as long as the one before times `bounce`.
void bounce(const Emitter& emitter, Particle& p, double time) {
    const double g = emitter.gravity, ground = *emitter.ground;
    p.position.y = std::max(p.position.y, ground);
    double speed = std::sqrt(p.velocity.y * p.velocity.y + 2 * g * (p.position.y - ground)); // where it meets the plane
    double arc = (p.velocity.y + speed) / g;
    for (int i = 0; time >= arc; ++i) {
        p.position += glm::dvec3(p.velocity.x * arc, 0, p.velocity.z * arc);
        p.position.y = ground;
        time -= arc;
        speed *= emitter.bounce;
        if (i == most_bounces || speed < resting_speed) {
            p.velocity = glm::dvec3(0);
            return;
        }
        p.velocity = {p.velocity.x * emitter.slip, speed, p.velocity.z * emitter.slip};
        arc = 2 * speed / g;
    }
    fly(emitter, p, time);
}

/// Between values at even steps of a life.
template <typename T>
T over_life(const std::vector<T>& values, double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    const size_t from = std::min(static_cast<size_t>(place), values.size() - 1);
    const size_t to = std::min(from + 1, values.size() - 1);
    return glm::mix(values[from], values[to], static_cast<float>(place - static_cast<double>(from)));
}

double size_of(const Emitter& emitter, const Particle& p) {
    return static_cast<double>(emitter.size) * static_cast<double>(over_life(emitter.sizes, p.share));
}

glm::vec4 vertex_colour(const Emitter& emitter, const Particle& p) {
    const glm::vec3 colour = particle_colour(emitter, p.share);
    const float largest = std::max({colour.r, colour.g, colour.b, 1.0f});
    return {colour / largest, over_life(emitter.opacities, p.share)};
}

glm::dvec3 way_of(const Particle& p, const Particle& before) {
    return p.life == before.life ? before.position - p.position : glm::dvec3(0);
}

/// A square around the particle that faces the camera.
void add_billboard(const Emitter& emitter, const Particle& p, const Particle& before, uint32_t number,
                   const glm::dvec3& origin, Primitive& out) {
    Random own(Random(emitter.seed ^ 0x62696c6cu).bits() ^ number ^ static_cast<uint64_t>(p.life) << 20);
    const double turned = own.uniform(0, 2 * std::numbers::pi), spin = emitter.spin,
                 angle = turned + own.uniform(-spin, spin) * p.age;
    const glm::dvec2 along = size_of(emitter, p) * glm::dvec2(std::cos(angle), std::sin(angle));
    const auto first = static_cast<uint32_t>(out.positions.size());
    const glm::dvec3 place = p.position - origin;
    for (int corner = 0; corner < 4; ++corner) { // from the lower left one round
        const double x = corner == 1 || corner == 2 ? 1 : -1, y = corner >= 2 ? 1 : -1;
        out.positions.emplace_back(place);
        out.previous_positions.emplace_back(place + way_of(p, before));
        out.facing.emplace_back(x * along + y * glm::dvec2(-along.y, along.x));
        out.normals.emplace_back(0, 0, 1);
        out.tangents.emplace_back(std::cos(angle), std::sin(angle), 0, 1);
        out.colours.push_back(vertex_colour(emitter, p));
        out.texcoords[0].emplace_back(0.5 + 0.5 * x, 0.5 - 0.5 * y);
    }
    for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u})
        out.indices.push_back(first + i);
}

/// An octahedron around the particle, drawn out backwards along its way.
void add_octahedron(const Emitter& emitter, const Particle& p, const Particle& before, uint32_t number,
                    const glm::dvec3& origin, Primitive& out) {
    const glm::dvec3 ahead = unit_or(p.velocity, {0, 1, 0});
    const glm::dvec3 side =
        glm::normalize(glm::cross(ahead, std::abs(ahead.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
    const glm::dvec3 other = glm::cross(ahead, side);
    const double size = size_of(emitter, p), tail = size + glm::length(p.velocity) * emitter.streak;
    const glm::dvec3 corners[6] = {ahead * size, ahead * -tail, side * size, side * -size, other * size, other * -size};
    const glm::dvec3 normals[6] = {ahead, -ahead, side, -side, other, -other};
    const glm::vec4 colour = vertex_colour(emitter, p);
    const auto first = static_cast<uint32_t>(out.positions.size());
    const glm::dvec3 moved = way_of(p, before);
    for (int i = 0; i < 6; ++i) {
        const glm::dvec3 corner = p.position - origin + corners[i];
        out.positions.emplace_back(corner);
        out.previous_positions.emplace_back(corner + moved);
        out.normals.emplace_back(normals[i]);
        out.colours.push_back(colour);
        out.texcoords[0].emplace_back(p.share, (number + 0.5) / emitter.count);
    }
    for (const uint32_t i :
         {0u, 2u, 4u, 0u, 4u, 3u, 0u, 3u, 5u, 0u, 5u, 2u, 1u, 4u, 2u, 1u, 3u, 4u, 1u, 5u, 3u, 1u, 2u, 5u})
        out.indices.push_back(first + i);
}

} // namespace

Particle particle_at(const Emitter& emitter, const glm::dmat4& node, uint32_t number, double time) {
    Random own(Random(emitter.seed).bits() ^ number);
    const double lifetime = own.uniform(emitter.lifetime_from, emitter.lifetime_to);
    const double lives = time / lifetime + own.unit();
    Particle p;
    p.life = static_cast<int64_t>(std::floor(lives));
    p.share = std::min(lives - static_cast<double>(p.life), std::nextafter(1.0, 0.0));

    Random thrown(own.bits() ^ static_cast<uint64_t>(p.life));
    const glm::dvec3 axis = unit_or(-glm::dvec3(node[2]), {0, 0, -1});
    const glm::dvec3 helper = std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 side = glm::normalize(glm::cross(axis, helper)), other = glm::cross(axis, side);
    const auto direction = [&](double least_cosine) { // even over the solid angle
        const double c = thrown.uniform(least_cosine, 1), s = std::sqrt(std::max(1 - c * c, 0.0));
        const double angle = thrown.uniform(0, 2 * std::numbers::pi);
        return axis * c + s * (std::cos(angle) * side + std::sin(angle) * other);
    };
    p.position = glm::dvec3(node[3]) + direction(-1) * (std::cbrt(thrown.unit()) * emitter.radius);
    p.velocity =
        direction(std::cos(static_cast<double>(emitter.cone))) * thrown.uniform(emitter.speed_from, emitter.speed_to);
    p.age = p.share * lifetime;
    if (emitter.ground)
        bounce(emitter, p, p.age);
    else
        fly(emitter, p, p.age);
    return p;
}

glm::vec3 particle_colour(const Emitter& emitter, double share) { return over_life(emitter.colours, share); }

Emission emit(const Emitter& emitter, const glm::dmat4& node, double time, const std::optional<glm::dmat4>& before,
              double interval, const std::string& object) {
    if (emitter.colours.empty() || emitter.sizes.empty() || emitter.opacities.empty() || emitter.count == 0 ||
        !(emitter.lifetime_from > 0) || !(emitter.lifetime_to >= emitter.lifetime_from) || !(emitter.range > 0) ||
        (emitter.ground && (!(emitter.gravity > 0) || emitter.drag > 0)))
        throw Error(object + ": its emitter is out of the ranges that prelight/emitter.hpp gives");
    Emission out;
    out.origin = glm::dvec3(node[3]);
    if (emitter.size > 0) {
        out.shapes.emplace();
        out.shapes->material = emitter.material;
    }
    out.lights.reserve(emitter.lights ? emitter.count : 0);
    for (uint32_t i = 0; i < emitter.count; ++i) {
        const Particle p = particle_at(emitter, node, i, time);
        if (emitter.lights) {
            PlacedLight& light = out.lights.emplace_back();
            light.light.colour = particle_colour(emitter, p.share);
            light.light.intensity = emitter.intensity;
            light.light.range = emitter.range;
            light.light.casts_shadow = emitter.casts_shadow;
            light.position = p.position;
        }
        if (!out.shapes)
            continue;
        const Particle earlier = before ? particle_at(emitter, *before, i, time - interval) : p;
        if (emitter.shape == ParticleShape::billboard)
            add_billboard(emitter, p, earlier, i, out.origin, *out.shapes);
        else
            add_octahedron(emitter, p, earlier, i, out.origin, *out.shapes);
    }
    return out;
}

} // namespace prelight
