#pragma once
#include <scene/procedural/city_plan.hpp>

namespace prelight::city {

enum class Style { brick, stucco, modern };

/// One front of a house. Lengths in metres.
struct Facade {
    float width = 10;
    uint32_t floors = 5; ///< upper floors, above the ground floor
    Style style = Style::brick;
    Surface wall = Surface::brick;
    glm::vec3 wall_tint{1}, trim_tint{1}, frame_tint{1};
    bool cap_left = true; ///< cornices run around the corner at this end
    bool cap_right = true;
    bool corner_left = false; ///< another front begins at this end
    bool corner_right = false;
    bool shops = true;
};

inline constexpr float ground_floor = 4.2f, upper_floor = 3.25f, parapet = 0.9f;
/// Trims around openings and at the ends of a front stand this far out of the faces that they
/// cover: two faces in one plane would fight for the same pixels.
inline constexpr float lip = 0.005f;
inline float facade_height(const Facade& f) {
    return ground_floor + upper_floor * static_cast<float>(f.floors) + parapet;
}

/// Builds the front in the builder's frame (s to the right, d outwards, origin at the lower left
/// corner), and leaves its light sites in the plan.
void build_facade(Plan& plan, MeshBuilder& b, const Facade& f);

// Parts, one file each.
void build_ground_floor(Plan& plan, MeshBuilder& b, const Facade& f); // city_shops.cpp
void build_window(Plan& plan, MeshBuilder& b, const Facade& f, glm::vec2 low, glm::vec2 high,
                  bool balcony); // city_windows.cpp

/// Quads of a wall at d = 0 between the grid lines, with holes: no vertex lies on another's edge.
void wall_grid(MeshBuilder& b, const std::vector<float>& s, const std::vector<float>& y, const std::vector<bool>& hole);
/// The four sides of a hole in the wall, `depth` metres deep.
void reveal(MeshBuilder& b, glm::vec2 low, glm::vec2 high, float depth);

} // namespace prelight::city
