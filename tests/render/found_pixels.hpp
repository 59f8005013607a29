#pragma once
#include "garden.hpp"
#include <span>

namespace prelight {

/// What a way of finding the pixels of lights found in one picture.
struct Found {
    Image linear;
    Image counts; ///< --view light-count: lights that contribute to each pixel
    uint64_t evaluated = 0, contributing = 0;
};
using SettingMap = std::map<std::string, std::string>;

inline constexpr float degree = 3.14159265f / 180;
inline constexpr uint32_t found_width = 192, found_height = 108;

/// The world from each camera.
std::vector<Found> find_pixels(const World& world, std::span<const PlacedCamera> cameras, const SettingMap& settings,
                               Device& device = test_device());

/// Every setting finds what light-culling=fullscreen finds, from every camera: the same count on each
/// pixel, and no pixel twice. With one light the pictures are the same, with more they round by order.
/// Returns what each setting found from each camera.
std::vector<std::vector<Found>> expect_same_as_fullscreen(const World& world, std::span<const PlacedCamera> cameras,
                                                          std::span<const SettingMap> settings,
                                                          Device& device = test_device());

/// A garden with one light, and cameras outside its volume, on its edge, inside, and so that the near
/// plane cuts it; all look at the light.
struct LightFromEverywhere {
    LightFromEverywhere(const Light& light, glm::dvec3 direction);
    Garden garden;
    std::vector<PlacedCamera> cameras;
};

struct LightCase {
    const char* name;
    Light light;
    glm::dvec3 direction{0, -1, -0.3};
};
void PrintTo(const LightCase& c, std::ostream* out);
/// Points, and spots narrow, wide and past 80°, from all sides.
std::vector<LightCase> light_cases();

/// A garden whose lights stand beside the view, behind the camera and partly behind it, before and
/// past the far plane, and cameras of every projection.
struct LightsEverywhere {
    LightsEverywhere();
    Garden garden;
    std::vector<PlacedCamera> cameras;
};

} // namespace prelight
