#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <scene/procedural/builder.hpp>
#include <scene/procedural/decal_maps.hpp>
#include <scene/procedural/decals.hpp>
#include <scene/procedural/material_maps.hpp>
#include <scene/procedural/random.hpp>
#include <scene/procedural/shapes.hpp>
#include <scene/tangents.hpp>

namespace prelight {
namespace {

constexpr double loop_seconds = 8; // seconds

TextureRef add_decal_map(Scene& scene, TextureImage image) {
    return {.image = append(scene.images, std::move(image)),
            .sampler = {.wrap_s = Wrap::clamp_to_edge, .wrap_t = Wrap::clamp_to_edge}};
}

TextureRef tiled(Scene& scene, TextureImage image, float times) {
    return {.image = append(scene.images, std::move(image)), .sampler = {}, .uv_linear = glm::mat2(times)};
}

/// A box whose +Z stands off a surface: `out` and `up` are unit vectors at a right angle, `size` is width, height,
/// depth.
glm::dmat4 box_on(glm::dvec3 at, glm::dvec3 out, glm::dvec3 up, glm::dvec3 size) {
    const glm::dvec3 right = glm::cross(up, out);
    return {glm::dvec4(right * size.x, 0), glm::dvec4(up * size.y, 0), glm::dvec4(out * size.z, 0), glm::dvec4(at, 1)};
}

Node& add_decal(Scene& scene, const char* name, const Decal& decal, const glm::dmat4& box) {
    Node& node = add_root(scene, name, box);
    node.decal = append(scene.decals, decal);
    return node;
}

void add_yard(Scene& scene) {
    const TextureRef colours = tiled(scene, brick_colours(), 2), normals = tiled(scene, brick_normals(), 2);
    const auto bricks = append(scene.materials, Material{.name = "bricks",
                                                         .metallic = 0,
                                                         .roughness = 0.75f,
                                                         .normal_scale = 0.3f,
                                                         .base_colour_texture = colours,
                                                         .normal_texture = normals});
    const auto floor =
        append(scene.materials,
               Material{.name = "floor", .base_colour = {0.42f, 0.42f, 0.44f, 1}, .metallic = 0, .roughness = 0.55f});
    const auto step =
        append(scene.materials,
               Material{.name = "step", .base_colour = {0.55f, 0.54f, 0.5f, 1}, .metallic = 0, .roughness = 0.6f});
    const auto ball =
        append(scene.materials,
               Material{.name = "ball", .base_colour = {0.3f, 0.42f, 0.55f, 1}, .metallic = 0, .roughness = 0.35f});
    const auto clean = append(scene.materials, Material{.name = "clean",
                                                        .base_colour = {0.75f, 0.75f, 0.72f, 1},
                                                        .metallic = 0,
                                                        .roughness = 0.4f,
                                                        .receives_decals = false});
    const auto add = [&](const char* name, Primitive shape, uint32_t material, glm::dvec3 at) {
        if (scene.materials[material].normal_texture)
            generate_tangents(shape, 0);
        add_root(scene, name, translation(at)).mesh = add_mesh(scene, name, std::move(shape), material);
    };
    add("floor", make_ground({9, 7}, 1), floor, {0, 0, 0});
    add("back wall", make_box({-4.5f, 0, -0.2f}, {4.5f, 4, 0}), bricks, {0, 0, -3.5});
    add("side wall", make_box({-0.2f, 0, -3.5f}, {0, 4, 3.5f}), bricks, {-4.5, 0, 0});
    add("step", make_box({-0.9f, 0, -0.5f}, {0.9f, 0.28f, 0.5f}), step, {0.4, 0, 0.1});
    add("ball", make_sphere(0.8f, 96, 48), ball, {2.9, 0.8, -1.4});
    add("post", make_box({-0.12f, 0, -0.12f}, {0.12f, 1.5f, 0.12f}), clean, {-1.6, 0, 0.9});
}

void add_decals(Scene& scene) {
    const auto material = [&](const char* name, const TextureRef& colours, float metallic, float roughness,
                              const TextureRef& normals = {}) {
        return append(scene.materials, Material{.name = name,
                                                .metallic = metallic,
                                                .roughness = roughness,
                                                .base_colour_texture = colours,
                                                .normal_texture = normals});
    };
    // Maps one by one: in which order a call's arguments are evaluated is the compiler's business.
    const TextureRef crack_bumps = add_decal_map(scene, crack_normals()),
                     crack_picture = add_decal_map(scene, crack_colours());
    const uint32_t cracks = material("cracks", crack_picture, 0, 0.9f, crack_bumps);
    const uint32_t paint = material("paint", add_decal_map(scene, arrow()), 0, 0.3f);
    const uint32_t mark = material("mark", add_decal_map(scene, target()), 0, 0.35f);
    const TextureRef bolt_bumps = add_decal_map(scene, bolt_normals()),
                     bolt_picture = add_decal_map(scene, bolt_colours());
    const uint32_t bolts = material("bolts", bolt_picture, 1, 0.35f, bolt_bumps);
    const uint32_t water = material("water", add_decal_map(scene, puddle()), 0, 0.12f);
    const uint32_t burn = material("burn", add_decal_map(scene, scorch()), 0, 0.95f);
    const glm::dvec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    add_decal(scene, "cracks in the wall", {.material = cracks, .order = 1},
              box_on({-1.2, 2.2, -3.5}, z, y, {2.6, 2.6, 0.4}));
    add_decal(scene, "cracks in the floor", {.material = cracks}, box_on({-2.3, 0, -1.2}, y, z, {2.4, 2.4, 0.3}));
    // Over floor and step; the step's sides are turned away.
    add_decal(scene, "arrow", {.material = paint},
              box_on({0.4, 0.2, 0.6}, y, glm::normalize(glm::dvec3(0.25, 0, -1)), {1.3, 2.4, 0.9}));
    add_decal(scene, "arrow on the wall", {.material = paint}, box_on({-1.2, 2.2, -3.5}, z, -x, {1.1, 1.9, 0.4}));
    for (const double height : {0.35, 3.6})
        for (const double across : {1.4, 3.0})
            add_decal(scene, "bolts", {.material = bolts}, box_on({across, height, -3.5}, z, y, {1.2, 0.6, 0.3}));
    add_decal(scene, "puddle", {.material = water, .colour = false, .normal = false},
              box_on({1.9, 0, 1.2}, y, z, {3.4, 2.6, 0.3}));
    add_decal(scene, "burn", {.material = burn, .opacity = 0.95f},
              box_on({2.6, 0.9, -0.8}, glm::normalize(glm::dvec3(-0.4, 0.25, 1)),
                     glm::normalize(glm::dvec3(0, 1, -0.25)), {1.3, 1.3, 1.2}));
    add_decal(scene, "lines around the post", {.material = mark}, box_on({-1.6, 0.4, 0.9}, y, z, {1.6, 1.6, 1.2}));
    add_decal(scene, "mark", {.material = mark, .order = 2}, {});
    // Looks along the side wall, there and back once a loop_seconds.
    Node& node = scene.nodes.back();
    node.trs = Trs{{-4.5, 2, 0.5}, glm::angleAxis(full_turn / 4, y), {1.3, 1.3, 0.5}};
    node.local = node.trs->matrix();
    AnimationSampler sampler{.times = {}, .values = {}, .interpolation = Interpolation::linear};
    constexpr int keys = 16;
    for (int key = 0; key <= keys; ++key) {
        sampler.times.push_back(static_cast<float>(loop_seconds * key / keys));
        const double angle = full_turn * key / keys;
        for (const double v : {-4.5, 2 + 0.5 * std::sin(2 * angle), 0.5 - 2 * std::sin(angle)})
            sampler.values.push_back(static_cast<float>(v));
    }
    Animation& animation = scene.animations.back();
    animation.channels.push_back({append(animation.samplers, std::move(sampler)),
                                  static_cast<uint32_t>(scene.nodes.size() - 1), AnimationPath::translation});
}

/// Goes round over the room once a loop_seconds.
void add_moving_light(Scene& scene, const Light& light, glm::dvec3 middle, double out, double begin, bool backwards) {
    AnimationSampler sampler{.times = {}, .values = {}, .interpolation = Interpolation::linear};
    constexpr int keys = 24;
    for (int key = 0; key <= keys; ++key) {
        const double angle = begin + full_turn * key / keys * (backwards ? -1 : 1);
        sampler.times.push_back(static_cast<float>(loop_seconds * key / keys));
        for (const double v : {middle.x + 1.3 * out * std::sin(angle), middle.y, middle.z + out * std::cos(angle)})
            sampler.values.push_back(static_cast<float>(v));
    }
    Node& node = add_light(scene, light, {sampler.values[0], sampler.values[1], sampler.values[2]});
    node.trs = Trs{.translation = {sampler.values[0], sampler.values[1], sampler.values[2]}};
    node.local = node.trs->matrix();
    Animation& animation = scene.animations.back();
    animation.channels.push_back({append(animation.samplers, std::move(sampler)),
                                  static_cast<uint32_t>(scene.nodes.size() - 1), AnimationPath::translation});
}

} // namespace

Scene make_decals_scene(uint32_t lights, uint64_t seed) {
    Scene scene;
    scene.name = "decals";
    scene.scenes = {{.name = "decals", .nodes = {}}};
    scene.ambient = glm::vec3(0.09f);
    scene.animations.push_back({.name = "rounds", .samplers = {}, .channels = {}});
    add_camera(scene, {.name = "front", .yfov = 0.75}, {2.3, 2.7, 6.4}, {-0.5, 1.2, -0.9});
    add_camera(scene, {.name = "close", .yfov = 0.6}, {-0.4, 2.3, -1.4}, {-1.3, 2.2, -3.5});
    add_camera(scene, {.name = "low", .yfov = 0.7}, {1.5, 0.45, 3.1}, {0.2, 0.2, 0});
    add_yard(scene);
    add_decals(scene);
    Random random(seed);
    for (uint32_t i = 0; i < lights; ++i) {
        const double out = random.uniform(1, 2.6), height = random.uniform(0.6, 3.4),
                     begin = full_turn * (i + 0.6 * random.unit()) / lights;
        const glm::vec3 colour = hue_colour(random.unit(), 0.4);
        add_moving_light(scene, {.colour = colour, .intensity = 60.0f / static_cast<float>(lights), .range = 8},
                         {0, height, -0.3}, out, begin, i % 2 == 1);
    }
    return scene;
}

} // namespace prelight
