#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <prelight/glm_defaults.hpp>
#include <string>

namespace prelight {

struct LightProfile; // light_distribution.hpp

/// Light::cookie of a light that throws no picture.
inline constexpr uint32_t no_cookie = 0xffffffffu;

/// Where a light shines from, and where to.
enum class LightKind {
    directional, ///< from infinitely far away, one way
    point,       ///< from one point, all ways
    spot,        ///< from one point, into a cone
};
/// Falloff with distance. `gltf` is the default everywhere; the others are the source texts'.
enum class Falloff {
    gltf,     ///< clamp(1 − (d/range)⁴, 0, 1) / max(d, 0.01 m)²   (KHR_lights_punctual)
    linear,   ///< clamp(1 − d/range, 0, 1)
    quadratic ///< clamp(1 − (d/range)², 0, 1)
};

/// One light, in the space of the node that carries it: position is the node's origin, direction is
/// the node's −Z axis (KHR_lights_punctual). The node's scale does not matter.
struct Light {
    std::string name;                                     ///< of the file; may be empty
    LightKind kind = LightKind::point;                    ///< which of the members below count
    glm::vec3 colour{1};                                  ///< linear RGB, each ≥ 0
    float intensity = 1;                                  ///< candela (point, spot) or lux (directional)
    float range = std::numeric_limits<float>::infinity(); ///< metres; infinite: reaches everything
    float inner_cone = 0;                                 ///< radians from the axis, 0 … outer_cone; spot only
    float outer_cone = 0.785398163f;                      ///< radians from the axis, … π/2; spot only
    float shininess = 1;             ///< [phong] light shininess n: multiplies the material's exponent (8.5.4)
    Falloff falloff = Falloff::gltf; ///< linear and quadratic need a finite range
    bool casts_shadow = true;        ///< where a renderer draws shadows at all (setting `shadows`)
    /// What it sends in which direction; light_distribution.hpp says how. Points and spots only.
    uint32_t cookie = no_cookie;                   ///< index into Scene::images, or no_cookie
    std::shared_ptr<const LightProfile> profile{}; ///< measured; null: the same everywhere
    bool profile_candela = false; ///< `intensity` is a factor on the profile's candela, not its maximum
    float size = 0.03f;           ///< metres: radius of the sphere that soft shadows take it for; not directional
    /// Member by member; the same profile is the same object.
    bool operator==(const Light&) const = default;
};

} // namespace prelight
