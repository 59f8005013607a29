#include <scene/procedural/builder.hpp>
#include <scene/procedural/lights.hpp>
#include <scene/procedural/random.hpp>
#include <scene/procedural/shapes.hpp>

namespace prelight {
namespace {

constexpr double spacing = 7; // metres between spheres, and between columns

/// Untextured materials need no texture coordinates: the baseline's vertices stay small.
Primitive untextured(Primitive primitive) {
    primitive.texcoords[0].clear();
    return primitive;
}

void add_objects(Scene& scene) {
    scene.materials = {{.name = "ground", .base_colour = {0.5, 0.5, 0.5, 1}, .metallic = 0, .roughness = 0.7f},
                       {.name = "sphere", .base_colour = {0.8, 0.75, 0.7, 1}, .metallic = 0, .roughness = 0.35f},
                       {.name = "column", .base_colour = {0.6, 0.65, 0.7, 1}, .metallic = 0, .roughness = 0.5f}};
    const auto ground = add_mesh(scene, "ground", untextured(make_ground({100, 100}, 96)), 0);
    const auto sphere = add_mesh(scene, "sphere", untextured(make_sphere(1, 40, 20)), 1);
    const auto column = add_mesh(scene, "column", untextured(make_box({-0.25, 0, -0.25}, {0.25, 4, 0.25})), 2);

    add_root(scene, "ground", glm::dmat4(1)).mesh = ground;
    for (int z = 0; z < 12; ++z)
        for (int x = 0; x < 12; ++x) {
            const double height = 1 + 0.5 * ((x + z) % 3);
            add_root(scene, "sphere", translation({spacing * (x - 5.5), height, spacing * (z - 5.5)})).mesh = sphere;
        }
    for (int z = 0; z < 11; ++z)
        for (int x = 0; x < 11; ++x)
            add_root(scene, "column", translation({spacing * (x - 5), 0, spacing * (z - 5)})).mesh = column;
}

} // namespace

Scene make_lights_scene(uint32_t lights, uint64_t seed) {
    Scene scene;
    scene.name = "lights";
    scene.scenes = {{.name = "lights", .nodes = {}}};
    scene.ambient = glm::vec3(0.02f);
    add_camera(scene, {.name = "baseline", .yfov = 0.87}, {0, 14, 48}, {0, 0, 0});
    add_objects(scene);
    Random random(seed);
    for (uint32_t i = 0; i < lights; ++i) {
        // One statement each: the order in which a call's arguments are drawn is unspecified.
        const double x = random.uniform(-47, 47);
        const double y = random.uniform(0.4, 3.5);
        const double z = random.uniform(-47, 47);
        const glm::vec3 colour = hue_colour(random.unit(), 0.8);
        add_light(scene, {.colour = colour, .intensity = 12, .range = 5}, {x, y, z});
    }
    return scene;
}

} // namespace prelight
