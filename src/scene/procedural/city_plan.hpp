#pragma once
#include <array>
#include <prelight/scene.hpp>
#include <scene/procedural/city_mesh.hpp>
#include <scene/procedural/random.hpp>
#include <vector>

namespace prelight::city {

/// Where a light may go. Sites of a lower rank get their lights first.
enum class Rank : uint32_t { lamp, head, neon, shop, tail, window, count };

struct Site {
    Light light;
    glm::dvec3 position{0};
    glm::dvec3 direction{0, -1, 0}; ///< of a spot, unit
};

/// A bulb of a string of lights: world position and colour.
struct Bulb {
    glm::vec3 position{0};
    glm::vec3 colour{0};
};

/// A vertical or horizontal rectangle, frame.origin its lower left corner, where small lights may
/// lie.
struct Sheet {
    Frame frame;
    glm::vec2 size{0};
};

// The street's measures in metres, all symmetric about x = 0.
inline constexpr float road_half = 5.0f;    ///< kerb of the main street
inline constexpr float house_line = 8.5f;   ///< façades of the main street
inline constexpr float cross_z = -26.0f;    ///< middle of the cross street
inline constexpr float cross_half = 4.0f;   ///< its kerbs
inline constexpr float cross_line = 7.0f;   ///< its façades
inline constexpr float street_near = 30.0f; ///< the main street's ends
inline constexpr float street_far = -118.0f;
inline constexpr float cross_end = 62.0f; ///< the cross street's ends at ±x
inline constexpr float kerb_height = 0.14f;

/// The scene while it is being put together.
struct Plan {
    Scene scene;
    Random random{0};
    std::array<std::vector<Site>, static_cast<size_t>(Rank::count)> sites;
    std::vector<Bulb> bulbs;
    std::vector<Sheet> sheets;

    void add_site(Rank rank, Site site) { sites[static_cast<size_t>(rank)].push_back(std::move(site)); }
    /// Point light; `cd` at colour value 1.
    void add_point(Rank rank, glm::vec3 position, glm::vec3 colour, float cd, float range);
    /// Adds the mesh, without a node. Returns its index.
    uint32_t add_mesh(Mesh mesh);
    /// A node at `position`, turned about +Y by `yaw` radians.
    void place(uint32_t mesh, glm::vec3 position, float yaw = 0);
    /// Finishes the builder's mesh and places it at `origin`.
    void build(MeshBuilder& builder, std::string name, glm::vec3 origin = glm::vec3(0));
    float uniform(float lo, float hi) { return static_cast<float>(random.uniform(lo, hi)); }
    bool chance(double share) { return random.unit() < share; }
};

void add_materials(Scene& scene); // city_materials.cpp; they refer to make_pictures()
void add_ground(Plan& plan);      // city_street.cpp
void add_buildings(Plan& plan);   // city_buildings.cpp
void add_signs(Plan& plan);       // city_signs.cpp
void add_cars(Plan& plan);        // city_cars.cpp
void add_props(Plan& plan);       // city_props.cpp
void add_strings(Plan& plan);     // city_strings.cpp
/// Exactly `count` lights as nodes of the scene, by rank, then bulbs, then places on the sheets.
void place_lights(Plan& plan, uint32_t count); // city_lights.cpp

} // namespace prelight::city
