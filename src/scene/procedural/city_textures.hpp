#pragma once
#include <prelight/scene.hpp>
#include <scene/procedural/city_mesh.hpp>
#include <vector>

namespace prelight::city {

/// Index into Scene::images.
enum class Picture : uint32_t {
    asphalt_colour,
    asphalt_surface,
    asphalt_normal,
    paving_colour,
    paving_surface,
    paving_normal,
    brick_colour,
    brick_normal,
    plaster_normal,
    windows,
    shops,
    marking,
    wood,
    fabric,
    leaves,
    palette,
    sky,
    count
};

/// All pictures in the order of `Picture`. Those that repeat are tileable.
std::vector<TextureImage> make_pictures();

// Parts of make_pictures, one file each.
void add_ground_pictures(std::vector<TextureImage>& images); ///< asphalt …, paving …
void add_wall_pictures(std::vector<TextureImage>& images);   ///< brick …, plaster
void add_window_pictures(std::vector<TextureImage>& images); ///< windows, shops
void add_small_pictures(std::vector<TextureImage>& images);  ///< marking … sky

inline constexpr uint32_t window_cells = 4; ///< windows: 4 × 4 rooms
inline constexpr uint32_t lit_windows = 11; ///< the first 11 are lit, the rest dark
inline constexpr glm::uvec2 shop_cells{4, 2};

TexRect window_rect(uint32_t cell);
TexRect shop_rect(uint32_t cell);
/// The middle of a colour's cell in the palette.
glm::vec2 palette_uv(Glow colour);
/// Linear RGB of the palette, at most 1.
glm::vec3 glow_colour(Glow colour);
/// Mean linear RGB of a lit window or a shop, for the light it throws out.
glm::vec3 window_light(uint32_t cell);
glm::vec3 shop_light(uint32_t cell);

} // namespace prelight::city
