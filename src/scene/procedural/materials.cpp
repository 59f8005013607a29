#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <prelight/material_shader.hpp>
#include <scene/procedural/builder.hpp>
#include <scene/procedural/material_maps.hpp>
#include <scene/procedural/materials.hpp>
#include <scene/procedural/random.hpp>
#include <scene/procedural/shapes.hpp>
#include <scene/tangents.hpp>

namespace prelight {
namespace {

constexpr int shelf_columns = 6;
constexpr double shelf_spacing = 1.25, rise = 1.3; // metres
constexpr double sway_seconds = 8;                 // seconds

TextureRef add_map(Scene& scene, TextureImage image) {
    return {.image = append(scene.images, std::move(image)), .sampler = {}};
}

std::vector<Material> row(Scene& scene) {
    const TextureRef colours = add_map(scene, brick_colours()), heights = add_map(scene, brick_heights());
    const TextureRef normals = add_map(scene, brick_normals()), hammered = add_map(scene, hammered_normals());
    const TextureRef mask = add_map(scene, bands()), gloss = add_map(scene, checks()),
                     lines = add_map(scene, circuits());
    const auto of = [](const char* shader, Material material) {
        material.shader = find_material_shader(shader);
        return material;
    };
    const glm::vec4 red{0.75f, 0.16f, 0.1f, 1}, pale{0.86f, 0.66f, 0.55f, 1}, steel{0.62f, 0.64f, 0.68f, 1};
    std::vector<Material> list;
    list.push_back({.name = "metallic-roughness", .base_colour = red, .metallic = 0, .roughness = 0.3f});
    list.push_back(of("blinn-phong", {.name = "blinn-phong", .base_colour = red, .metallic = 0, .roughness = 0.3f}));
    list.push_back(of("skin", {.name = "skin", .base_colour = pale, .metallic = 0, .roughness = 0.55f}));
    list.push_back(
        of("minnaert", {.name = "minnaert", .base_colour = {0.45f, 0.12f, 0.4f, 1}, .metallic = 0, .roughness = 1}));
    list.push_back(of("reflection", {.name = "reflection", .base_colour = steel, .metallic = 1, .roughness = 0.1f}));
    list.push_back(
        of("fresnel-rim",
           {.name = "fresnel-rim", .base_colour = {0.05f, 0.08f, 0.15f, 1}, .metallic = 0, .roughness = 0.5f}));
    const Material bricks{.name = "normal map",
                          .metallic = 0,
                          .roughness = 0.7f,
                          .base_colour_texture = colours,
                          .normal_texture = normals};
    list.push_back(bricks);
    Material relief = of("detailed", bricks);
    relief.name = "parallax";
    relief.parameters["depth"] = glm::vec4(0.02f, 0, 0, 0);
    relief.textures["height_map"] = heights;
    list.push_back(relief);
    relief.name = "parallax occlusion";
    relief.parameters["occlusion_steps"] = glm::vec4(24, 0, 0, 0);
    list.push_back(relief);
    Material detail =
        of("detailed",
           {.name = "detail under a mask", .base_colour = {0.8f, 0.6f, 0.2f, 1}, .metallic = 1, .roughness = 0.4f});
    detail.textures = {{"detail_normal_map", hammered}, {"detail_mask", mask}};
    list.push_back(detail);
    Material polished =
        of("detailed", {.name = "gloss map", .base_colour = {0.1f, 0.3f, 0.2f, 1}, .metallic = 0, .roughness = 0.15f});
    polished.textures = {{"gloss_map", gloss}};
    polished.parameters["gloss_roughness"] = glm::vec4(1, 0, 0, 0);
    list.push_back(polished);
    Material glowing =
        of("detailed",
           {.name = "incandescence map", .base_colour = {0.05f, 0.05f, 0.06f, 1}, .metallic = 0, .roughness = 0.4f});
    glowing.textures = {{"incandescence_map", lines}};
    list.push_back(glowing);
    return list;
}

/// A node that turns about +Y once a sway_seconds, with a light out at `place`.
void add_carousel_light(Scene& scene, Animation& animation, const Light& light, const glm::dvec3& place,
                        bool backwards) {
    const uint32_t child = append(scene.nodes, Node{.name = {}, .local = translation(place)});
    scene.nodes[child].light = append(scene.lights, light);
    const uint32_t hub =
        append(scene.nodes, Node{.name = "carousel", .local = glm::dmat4(1), .children = {child}, .trs = Trs{}});
    scene.scenes.back().nodes.push_back(hub);
    AnimationSampler sampler{.times = {}, .values = {}, .interpolation = Interpolation::linear};
    for (int key = 0; key <= 4; ++key) {
        const double half = std::numbers::pi * key / 4 * (backwards ? -1 : 1);
        sampler.times.push_back(static_cast<float>(sway_seconds * key / 4));
        sampler.values.insert(sampler.values.end(),
                              {0, static_cast<float>(std::sin(half)), 0, static_cast<float>(std::cos(half))});
    }
    animation.channels.push_back({append(animation.samplers, std::move(sampler)), hub, AnimationPath::rotation});
}

} // namespace

Scene make_materials_scene(uint32_t lights, uint64_t seed) {
    Scene scene;
    scene.name = "materials";
    scene.scenes = {{.name = "materials", .nodes = {}}};
    scene.ambient = glm::vec3(0.06f);
    scene.environment = std::make_shared<Environment>(make_studio());
    add_camera(scene, {.name = "front", .yfov = 0.5}, {0, 1.7, 8.7}, {0, 1.15, 0});
    const auto floor = append(
        scene.materials, {.name = "floor", .base_colour = {0.3f, 0.3f, 0.32f, 1}, .metallic = 0, .roughness = 0.6f});
    add_root(scene, "floor", glm::dmat4(1)).mesh = add_mesh(scene, "floor", make_ground({16, 16}, 16), floor);
    const Primitive plain = make_sphere(0.5f, 96, 48);
    Primitive mapped = plain;
    generate_tangents(mapped, 0);
    for (int i = 0; const Material& material : row(scene)) {
        const auto index = append(scene.materials, material);
        const int column = i % shelf_columns, shelf = i / shelf_columns;
        const glm::dvec3 centre(shelf_spacing * (column - 0.5 * (shelf_columns - 1)), 0.5 + rise * (1 - shelf), 0);
        add_root(scene, material.name, translation(centre)).mesh =
            add_mesh(scene, material.name, material.shader || material.normal_texture ? mapped : plain, index);
        ++i;
    }
    Random random(seed);
    Animation animation{.name = "carousel", .samplers = {}, .channels = {}};
    add_light(scene, {.colour = {1, 0.95f, 0.9f}, .intensity = 42, .range = 18},
              {-6, 4, 4}); // shows round shapes as round
    for (uint32_t i = 1; i < lights; ++i) {
        const double out = random.uniform(4.4, 5.6), angle = random.uniform(0, 2 * std::numbers::pi),
                     y = random.uniform(0.5, 3.4);
        const glm::vec3 colour = hue_colour(random.unit(), 0.35);
        add_carousel_light(scene, animation,
                           {.colour = colour, .intensity = 40.0f / static_cast<float>(lights), .range = 14},
                           {out * std::sin(angle), y, out * std::cos(angle)}, i % 2 == 1);
    }
    if (lights > 1)
        scene.animations.push_back(std::move(animation));
    return scene;
}

} // namespace prelight
