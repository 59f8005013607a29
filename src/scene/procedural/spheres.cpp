#include <fmt/format.h>
#include <scene/procedural/builder.hpp>
#include <scene/procedural/random.hpp>
#include <scene/procedural/shapes.hpp>
#include <scene/procedural/spheres.hpp>

namespace prelight {
namespace {

constexpr int grid_columns = 8;
constexpr int rows = 5;
constexpr double grid_spacing = 1.2; // metres between centres; the radius is 0.5
constexpr double floor_gap = 0.7;    // metres from the floor to the lowest centres

void add_sphere(Scene& scene, int column, int row) {
    const double roughness = 0.1 + 0.9 * column / (grid_columns - 1);
    const double metallic = static_cast<double>(row) / (rows - 1);
    const auto name = fmt::format("roughness {:.2f} metallic {:.2f}", roughness, metallic);
    const auto material = append(scene.materials, {.name = name,
                                                   .base_colour = {0.9, 0.45, 0.2, 1},
                                                   .metallic = static_cast<float>(metallic),
                                                   .roughness = static_cast<float>(roughness)});
    const auto mesh = add_mesh(scene, name, make_sphere(0.5f, 64, 32), material);
    const glm::dvec3 centre(grid_spacing * (column - 0.5 * (grid_columns - 1)), floor_gap + grid_spacing * row, 0);
    add_root(scene, name, translation(centre)).mesh = mesh;
}

} // namespace

Scene make_spheres_scene(uint32_t lights, uint64_t seed) {
    Scene scene;
    scene.name = "spheres";
    scene.scenes = {{.name = "spheres", .nodes = {}}};
    scene.ambient = glm::vec3(0.05f);
    const double middle = floor_gap + 0.5 * grid_spacing * (rows - 1);
    add_camera(scene, {.name = "front", .yfov = 0.7}, {0, middle, 9.6}, {0, middle, 0});

    const auto floor = append(scene.materials,
                              {.name = "floor", .base_colour = {0.3, 0.3, 0.32, 1}, .metallic = 0, .roughness = 0.6f});
    add_root(scene, "floor", glm::dmat4(1)).mesh = add_mesh(scene, "floor", make_ground({24, 24}, 24), floor);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < grid_columns; ++column)
            add_sphere(scene, column, row);

    Random random(seed);
    for (uint32_t i = 0; i < lights; ++i) {
        const double x = random.uniform(-6, 6);
        const double y = random.uniform(0.5, 8);
        const double z = random.uniform(3, 6);
        const glm::vec3 colour = hue_colour(random.unit(), 0.35);
        add_light(scene, {.colour = colour, .intensity = 60.0f / static_cast<float>(lights), .range = 20}, {x, y, z});
    }
    return scene;
}

} // namespace prelight
