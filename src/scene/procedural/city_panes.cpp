#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <scene/procedural/builder.hpp>
#include <scene/procedural/city.hpp>
#include <scene/procedural/city_plan.hpp>

namespace prelight {
namespace {

/// The meshes of what stands along the street, each once.
struct Sheets {
    uint32_t back, side, roof, canopies[3];
};

constexpr float shelter_width = 3.2f, shelter_depth = 1.3f, shelter_height = 2.3f, canopy_width = 3.6f;

Sheets add_sheets(Scene& scene) {
    const uint32_t clear = append(scene.materials, sheet_material("shelter glass", {0.75f, 0.92f, 0.88f}, 0.3f));
    const uint32_t tinted = append(scene.materials, sheet_material("tinted glass", {0.25f, 0.45f, 0.5f}, 0.55f, 0.15f));
    const glm::vec3 cloths[] = {{0.8f, 0.2f, 0.12f}, {0.85f, 0.6f, 0.15f}, {0.15f, 0.45f, 0.35f}};
    Sheets sheets{.back = add_mesh(scene, "shelter back", make_ground({shelter_width, shelter_height}, 1), clear),
                  .side = add_mesh(scene, "shelter side", make_ground({shelter_depth, shelter_height}, 1), clear),
                  .roof =
                      add_mesh(scene, "shelter roof", make_ground({shelter_width, shelter_depth + 0.2f}, 1), tinted),
                  .canopies = {}};
    for (size_t i = 0; i < std::size(cloths); ++i) {
        const uint32_t cloth = append(scene.materials, sheet_material("canopy", cloths[i], 0.75f, 0.9f));
        sheets.canopies[i] = add_mesh(scene, "canopy", make_ground({canopy_width, 1.7f}, 1), cloth);
    }
    return sheets;
}

/// A shelter that is open towards the road. `side`: ±1, that of the street.
void add_shelter(Scene& scene, const Sheets& sheets, double side, double z) {
    const glm::dmat4 place =
        glm::rotate(translation({side * 7.4, city::kerb_height, z}), -side * full_turn / 4, glm::dvec3(0, 1, 0));
    const auto add = [&](const char* name, uint32_t mesh, const glm::dmat4& local) {
        add_root(scene, name, place * local).mesh = mesh;
    };
    const double half_height = shelter_height / 2 + 0.1, half_depth = shelter_depth / 2;
    add("shelter back", sheets.back, upright(translation({0, half_height, 0})));
    for (const double end : {-1.0, 1.0})
        add("shelter side", sheets.side,
            upright(glm::rotate(translation({end * shelter_width / 2, half_height, half_depth}), end * full_turn / 4,
                                glm::dvec3(0, 1, 0))));
    add("shelter roof", sheets.roof, translation({0, shelter_height + 0.15, half_depth}));
}

} // namespace

Scene make_city_glass(uint32_t lights, uint64_t seed) {
    Scene scene = make_city(lights, seed);
    scene.name = "city-glass";
    const Sheets sheets = add_sheets(scene);
    Random random(seed);
    for (const double side : {-1.0, 1.0}) {
        for (double z = side < 0 ? 4 : -2; z > city::street_far + 8; z -= 17)
            if (std::abs(z - city::cross_z) > city::cross_line + 3)
                add_shelter(scene, sheets, side, z);
        // Above the shops' boards, sloping down to the road.
        for (double z = city::street_near - 4; z > city::street_far + 4; z -= canopy_width + 0.6) {
            const bool crossing = std::abs(z - city::cross_z) < city::cross_line + canopy_width / 2;
            const uint32_t cloth = random.below(5); // two in five shops have none
            if (crossing || cloth >= std::size(sheets.canopies))
                continue;
            const glm::dmat4 at = glm::rotate(translation({side * (city::house_line - 0.72), 4.25, z}),
                                              -side * full_turn / 4, glm::dvec3(0, 1, 0));
            add_root(scene, "canopy", glm::rotate(at, 0.65, glm::dvec3(1, 0, 0))).mesh = sheets.canopies[cloth];
        }
    }
    return scene;
}

} // namespace prelight
