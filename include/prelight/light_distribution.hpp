#pragma once
#include <filesystem>
#include <glm/mat3x3.hpp>
#include <optional>
#include <prelight/export.hpp>
#include <prelight/glm_defaults.hpp>
#include <prelight/scene.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace prelight {

// What a point or spot light sends in which direction: a cookie (a picture that it throws), a profile (how much
// a lamp was measured to send), or both, which multiply. docs/cookies.md has pictures.
//
// Directions are those of the node: it shines along −Z, +Y is up, +X is right. Its scale does not matter.

/// A measured lamp, from an IES file (ANSI/IESNA LM-63), type C. Angles and candela are as an evaluator wants
/// them: symmetric halves and quarters are written out. Between two angles values are mixed linearly; beyond
/// the first and the last vertical one it is dark.
struct LightProfile {
    std::string name; ///< the file, for messages
    std::string text; ///< as it was read: save_glb() keeps it
    /// Degrees from the way the light shines, ascending, 0 … 180.
    std::vector<double> vertical;
    /// Degrees around it, ascending, 0 … below 360, where it is the first again: 0 is towards +X, 90 towards +Y.
    std::vector<double> horizontal;
    /// With all of the file's factors; those of one horizontal angle lie together.
    std::vector<double> candela;
    double largest = 0; ///< of `candela`, > 0
};

/// Reads LM-63-1986, -1991, -1995, -2002 and -2019. TILT=INCLUDE is checked and otherwise passed over: its factors are
/// for a lamp that hangs askew. `name` stands in messages. Throws Error "NAME: line N: REASON": not such a file, types
/// A and B, TILT in another file, several lamps in one file, angles that do not ascend or that no symmetry is known
/// for, numbers that are missing, too many, negative or not finite.
PRELIGHT_API LightProfile parse_profile(std::string_view text, const std::string& name);
/// The same of a file of at most 16 MiB. Throws Error.
PRELIGHT_API LightProfile load_profile(const std::filesystem::path& path);

/// How a light throws its cookie.
enum class CookieKind {
    none,   ///< it has none
    spot,   ///< the picture fills the square around the outer cone, as the light sees it
    sphere, ///< point, 2 : 1: equirectangular; the middle lies along −Z, the top row towards +Y, what is left of the
            ///< middle towards −X
    cube ///< point, 6 : 1: faces +X −X +Y −Y +Z −Z side by side, each as the light sees it, +Y up; +Y and −Y as it
         ///< tilts up and down from −Z
};
/// By the light's kind; `none` without a cookie.
PRELIGHT_API CookieKind cookie_kind(const Scene& scene, const Light& light);

/// Whether the light sends more in some directions than its cone says.
inline bool has_distribution(const Light& light) { return light.cookie != no_cookie || light.profile; }

/// Widest outer cone of a spot with a cookie: 85°, for the square around 90° has no end.
inline constexpr float widest_cookie_cone = 1.48352986f;

/// What is wrong with a light: a cookie or profile on a directional one, an image that is not there, not 2 : 1
/// or 6 : 1 on a point light, a spot too wide for one, a size that is no radius. Nothing: it is as it should be.
PRELIGHT_API std::optional<std::string> light_fault(const Scene& scene, const Light& light);
/// Throws that as an Error "OBJECT: REASON".
PRELIGHT_API void check_light(const Scene& scene, const Light& light, const std::string& object);

/// The same of all lights of a world, before a renderer takes them: "SCENE: light NAME: REASON".
PRELIGHT_API void check_lights(const Scene& scene, std::span<const PlacedLight> lights);

/// Largest intensity in any direction, before the colour: candela (directional: lux).
PRELIGHT_API double largest_intensity(const Light& light);

/// The light's +X, +Y and +Z axes, world: a rotation.
PRELIGHT_API glm::dmat3 light_axes(const PlacedLight& light);

} // namespace prelight
