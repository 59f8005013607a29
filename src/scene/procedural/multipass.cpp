#include <cmath>
#include <scene/procedural/builder.hpp>
#include <scene/procedural/material_maps.hpp>
#include <scene/procedural/multipass.hpp>
#include <scene/procedural/random.hpp>
#include <scene/procedural/shapes.hpp>
#include <scene/tangents.hpp>

namespace prelight {
namespace {

/// The first is the floor's; each of the others has a mesh to begin with.
void add_materials(Scene& scene) {
    const auto map = [&](TextureImage image) {
        return TextureRef{.image = append(scene.images, std::move(image)), .sampler = {}};
    };
    const TextureRef colours = map(brick_colours()), normals = map(brick_normals()), hammered = map(hammered_normals());
    scene.materials = {
        {.name = "floor", .base_colour = {0.32f, 0.32f, 0.35f, 1}, .metallic = 0, .roughness = 0.5f},
        {.name = "bricks", .metallic = 0, .roughness = 0.6f, .base_colour_texture = colours, .normal_texture = normals},
        {.name = "red plastic", .base_colour = {0.7f, 0.08f, 0.06f, 1}, .metallic = 0, .roughness = 0.25f},
        {.name = "hammered gold",
         .base_colour = {1, 0.72f, 0.3f, 1},
         .metallic = 1,
         .roughness = 0.3f,
         .normal_texture = hammered},
        {.name = "white clay", .base_colour = {0.8f, 0.78f, 0.74f, 1}, .metallic = 0, .roughness = 0.9f},
        {.name = "blue steel", .base_colour = {0.35f, 0.45f, 0.7f, 1}, .metallic = 1, .roughness = 0.4f}};
}

} // namespace

Scene make_multipass_scene(uint32_t lights, uint64_t seed) {
    Scene scene;
    scene.name = "multipass";
    scene.scenes = {{.name = "multipass", .nodes = {}}};
    scene.ambient = glm::vec3(0.03f);
    add_camera(scene, {.name = "front", .yfov = 0.75}, {0, 2.6, 6.6}, {0, 0.65, 0});
    add_materials(scene);
    const auto add = [&](const char* name, Primitive primitive, const glm::dvec3& place, uint32_t material) {
        generate_tangents(primitive, 0);
        add_root(scene, name, translation(place)).mesh = add_mesh(scene, name, std::move(primitive), material);
    };
    add("floor", make_ground({14, 14}, 14), {0, 0, 0}, 0);
    add("knot", make_knot(0.55f, 0.18f, 192, 24), {0, 1.1, -0.6}, 1);
    add("ball", make_sphere(0.6f, 64, 32), {-2.2, 0.6, 0.4}, 2);
    add("box", make_box({-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}), {2.2, 0.5, 0.4}, 3);
    add("small ball", make_sphere(0.35f, 48, 24), {-0.9, 0.35, 1.7}, 4);
    add("small box", make_box({-0.3f, -0.3f, -0.3f}, {0.3f, 0.3f, 0.3f}), {1, 0.3, 1.8}, 5);

    Random random(seed);
    for (uint32_t i = 0; i < lights; ++i) {
        const double round = full_turn * (i + random.uniform(-0.2, 0.2)) / lights;
        const double radius = random.uniform(1.8, 3.6), height = random.uniform(1.2, 2.6);
        const glm::dvec3 place(radius * std::sin(round), height, radius * std::cos(round));
        Light light{.colour = hue_colour(random.unit(), 0.65f), .range = 6};
        light.intensity = 130.0f / static_cast<float>(lights + 4);
        if (i % 3 == 2) { // every third is a spot on the middle
            const PlacedCamera aim = look_at({}, place, {0, 0.5, 0});
            glm::dmat4 local(aim.axes);
            local[3] = {place, 1};
            light.kind = LightKind::spot;
            light.inner_cone = 0.3f;
            light.outer_cone = 0.5f;
            light.intensity *= 3;
            add_root(scene, {}, local).light = append(scene.lights, light);
        } else {
            add_light(scene, light, place);
        }
    }
    return scene;
}

} // namespace prelight
