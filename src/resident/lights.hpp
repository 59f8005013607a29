#pragma once
#include "light_spheres.hpp"
#include <array>
#include <prelight/scene.hpp>
#include <shared/frame.h>
#include <span>
#include <vector>

namespace prelight::resident {

/// How lights find their pixels: the setting `light-culling`.
enum class LightCulling {
    fullscreen, ///< every light by a full-screen triangle, wherever it is: the baseline
    rectangles, ///< the rectangle that its volume covers on the screen
    volumes,    ///< spheres and cones
    stencil,    ///< volumes that mark in stencil the pixels they hold, before they light them
    tiles,      ///< lists for tiles of the screen, with their depth range
    clusters,   ///< lists for depth slices of tiles
    grid,       ///< lists for cells of the world
};

/// The depth bounds test of rectangles: the setting `depth-bounds`.
enum class DepthBounds { automatic, on, off };

/// How rectangles and volumes are drawn: settings that only they obey.
struct VolumeOptions {
    bool spot_boxes = false; ///< `spot-volume=box`: boxes instead of cones
    bool depth_test = true;  ///< `volume-depth-test`; off: only the cull mode goes by the camera's place
    DepthBounds depth_bounds = DepthBounds::automatic;
};

/// Tiles, clusters, grid: lights with a volume are of one group, `listed`.
bool builds_lists(LightCulling culling);

/// How one light is drawn: full screen, or a volume seen from outside or inside; or listed.
enum class LightGroup { fullscreen, sphere_outside, sphere_inside, cone_outside, cone_inside, listed };
inline constexpr size_t light_group_count = 6;

/// Indices of lights that can reach the picture, group by group; within a group in the world's order.
struct LightGroups {
    std::vector<uint32_t> order;
    std::vector<shared::LightScreenBounds> bounds; ///< beside `order`; LightCulling::rectangles only
    std::array<uint32_t, light_group_count> first{};
    std::array<uint32_t, light_group_count> count{};
    double listed_pictures = 0; ///< how many pictures the listed lights' discs would fill, roughly
};

/// The device's record of a light without shadow and distribution; `exposure` multiplies its colour.
shared::LightData light_data(const PlacedLight& light, glm::dvec3 camera, double exposure);

/// `spheres`: those of `lights`. Leaves out what is dark or outside the view, and sorts the rest. A light is drawn
/// "inside" (back faces, reversed depth test) as soon as its volume may touch the near plane. `aspect`: width ÷ height
/// of what the camera sees; `extent`: of the picture, whose pixels screen bounds are padded by. Without `depth_clamp`,
/// a volume that the far plane would cut is drawn full screen.
LightGroups group_lights(std::span<const PlacedLight> lights, const LightSpheres& spheres, const PlacedCamera& camera,
                         const shared::FrameConstants& constants, double aspect, VkExtent2D extent,
                         LightCulling culling, bool depth_clamp, bool spot_boxes = false);

/// Sides of the cone's mesh, shared with passes::cone_volume.
inline constexpr uint32_t cone_sides = 16;
/// Largest distance of a point of the light's volume mesh from the light, in ranges.
double volume_reach(const Light& light, bool spot_boxes = false);
/// Spots of 80° and more, and point lights, use the sphere.
bool is_cone(const Light& light);

} // namespace prelight::resident
