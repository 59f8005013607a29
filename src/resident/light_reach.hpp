#pragma once
#include "scene.hpp"
#include <span>

namespace prelight::resident {

/// Whether a frame finds the lights of each object, and in which order it lists them.
enum class ObjectLights { none, world_order, strongest_first };

/// For each draw the lights that may reach it.
struct LightReach {
    std::vector<uint32_t> lights; ///< indices into World::lights, list after list
    std::vector<uint32_t> first;  ///< where each draw's list begins; one more than draws
    size_t draws() const { return first.empty() ? 0 : first.size() - 1; }
    std::span<const uint32_t> of(size_t draw) const {
        return std::span(lights).subspan(first[draw], first[draw + 1] - first[draw]);
    }
};

/// All of a light that decides what it reaches.
struct LightVolume {
    LightKind kind = LightKind::point;
    glm::dvec3 position{0}, direction{0, 0, -1};
    double range = 0, outer_cone = 0;
    explicit LightVolume(const PlacedLight& light);
    LightVolume() = default;
    bool operator==(const LightVolume&) const = default;
};

/// True where a light's range (and a spot's cone) meets the draw's box; may be true where it just
/// misses, never false where it meets.
bool reaches(const LightVolume& light, const Draw& draw);

/// The light's luminance at the point of the draw's box that is nearest to it: luminance of colour ×
/// intensity × attenuation, the cone left aside.
double strength(const PlacedLight& light, const Draw& draw);

/// Tests each light of `visible` (indices, any order) against each draw that is lit at all. With
/// `strongest_first` lists go by strength, falling; equal ones, and all others, by index. `blended`: the same of draws
/// that are Draw::blended() or transmissive(), where `order` leaves them out.
LightReach find_reach(std::span<const Draw> draws, std::span<const PlacedLight> lights,
                      std::span<const uint32_t> visible, ObjectLights order, ObjectLights blended = ObjectLights::none);

} // namespace prelight::resident
