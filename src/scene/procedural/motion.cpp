#include <cmath>
#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>
#include <numbers>
#include <scene/procedural/builder.hpp>
#include <scene/procedural/motion.hpp>
#include <scene/procedural/motion_shapes.hpp>
#include <scene/procedural/random.hpp>

namespace prelight {
namespace {

constexpr double motion_seconds = 4; // seconds

/// A node under `parent` (or a root) with parts that animation can change.
uint32_t add_node(Scene& scene, std::string name, const Trs& trs, std::optional<uint32_t> parent = {}) {
    const uint32_t index = append(scene.nodes, Node{.name = std::move(name), .local = trs.matrix(), .trs = trs});
    (parent ? scene.nodes[*parent].children : scene.scenes.back().nodes).push_back(index);
    return index;
}

/// Keyframes of one channel, `count` + 1 of them over the motion_seconds; `value(t)` appends the values at t in
/// 0 … 1.
template <class Value>
void animate(Animation& animation, uint32_t node, AnimationPath path, uint32_t count, Value value,
             Interpolation interpolation = Interpolation::linear) {
    AnimationSampler sampler{.times = {}, .values = {}, .interpolation = interpolation};
    for (uint32_t i = 0; i <= count; ++i) {
        sampler.times.push_back(static_cast<float>(motion_seconds * i / count));
        value(double(i) / count, sampler.values);
    }
    animation.channels.push_back({append(animation.samplers, std::move(sampler)), node, path});
}

void put(std::vector<float>& values, const glm::dvec3& v) {
    for (int i = 0; i < 3; ++i)
        values.push_back(static_cast<float>(v[i]));
}
void put(std::vector<float>& values, const glm::dquat& q) {
    for (const double v : {q.x, q.y, q.z, q.w})
        values.push_back(static_cast<float>(v));
}

/// Whole turns about an axis in one motion_seconds.
void spin(Animation& animation, uint32_t node, const glm::dvec3& axis, int turns,
          Interpolation interpolation = Interpolation::linear, uint32_t keys_a_turn = 4) {
    animate(
        animation, node, AnimationPath::rotation, keys_a_turn * static_cast<uint32_t>(std::abs(turns)),
        [&](double t, auto& values) { put(values, glm::angleAxis(full_turn * turns * t, axis)); }, interpolation);
}

uint32_t add_material(Scene& scene, const char* name, const glm::vec3& colour, float metallic, float roughness) {
    return append(
        scene.materials,
        Material{.name = name, .base_colour = glm::vec4(colour, 1), .metallic = metallic, .roughness = roughness});
}

/// Two shades in a pattern of `columns` × `rows` cells of 8 × 8 pixels.
TextureRef add_pattern(Scene& scene, const char* name, uint32_t columns, uint32_t rows, bool stripes) {
    TextureImage image{.name = name, .width = 8 * columns, .height = 8 * rows, .rgba = {}};
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            const uint32_t cell = (stripes ? x / 8 + y / 8 * 2 : x / 8 + y / 8) % 2 + (stripes ? y / 8 % 2 : 0);
            const auto shade = static_cast<uint8_t>(cell % 2 ? 225 : 110);
            image.rgba.insert(image.rgba.end(), {shade, shade, shade, 255});
        }
    return {.image = append(scene.images, std::move(image)), .sampler = {}};
}

void add_stage(Scene& scene) {
    const uint32_t floor = add_material(scene, "floor", {0.42, 0.42, 0.46}, 0, 0.45f);
    scene.materials[floor].base_colour_texture = add_pattern(scene, "checker", 16, 16, false);
    scene.nodes[add_node(scene, "floor", {})].mesh = add_mesh(scene, "floor", make_ground({16, 16}, 16), floor);
}

/// Six boxes on a turning disc, each turning by itself.
void add_carousel(Scene& scene, Animation& animation) {
    const uint32_t carousel = add_node(scene, "carousel", {.translation = {-4, 0, -0.5}});
    spin(animation, carousel, {0, 1, 0}, 1);
    const Primitive box = make_box({-0.4, -0.4, -0.4}, {0.4, 0.4, 0.4});
    for (uint32_t i = 0; i < 6; ++i) {
        const auto name = fmt::format("box {}", i);
        const uint32_t material = add_material(scene, name.c_str(), hue_colour(i / 6.0, 0.6), i % 2 ? 0.9f : 0, 0.35f);
        const double angle = full_turn * i / 6;
        const uint32_t node =
            add_node(scene, name,
                     {.translation = {1.9 * std::cos(angle), 0.9 + 0.35 * (i % 3), -1.9 * std::sin(angle)}}, carousel);
        scene.nodes[node].mesh = add_mesh(scene, name, box, material);
        spin(animation, node, glm::normalize(glm::dvec3(1, 0.5 * i, 2)), i % 2 ? 1 : -2);
    }
}

void add_column(Scene& scene, Animation& animation) {
    constexpr uint32_t joints = 5;
    constexpr double height = 4, segment = height / joints;
    const uint32_t material = add_material(scene, "column", {0.95, 0.62, 0.28}, 0, 0.4f);
    scene.materials[material].base_colour_texture = add_pattern(scene, "stripes", 8, 10, true);
    Skin skin{.name = "column"};
    std::optional<uint32_t> parent;
    for (uint32_t i = 0; i < joints; ++i) {
        const glm::dvec3 offset = i ? glm::dvec3(0, segment, 0) : glm::dvec3(0.2, 0, -1.5);
        const uint32_t joint = add_node(scene, fmt::format("joint {}", i), {.translation = offset}, parent);
        skin.joints.push_back(joint);
        skin.inverse_bind.push_back(translation({0, -segment * i, 0}));
        parent = joint;
        if (i > 0)
            animate(animation, joint, AnimationPath::rotation, 16, [&](double t, auto& values) {
                const double angle = full_turn * t - 0.6 * i;
                put(values, glm::angleAxis(0.3 * std::sin(angle), glm::dvec3(0, 0, 1)) *
                                glm::angleAxis(0.18 * std::cos(angle), glm::dvec3(1, 0, 0)));
            });
    }
    const uint32_t node = add_node(scene, "column", {});
    scene.nodes[node].mesh =
        add_mesh(scene, "column", make_jointed_column(0.42f, static_cast<float>(height), joints), material);
    scene.nodes[node].skin = append(scene.skins, std::move(skin));
}

/// Round, star, round, egg; smooth at the keyframes.
void add_blob(Scene& scene, Animation& animation) {
    const uint32_t material = add_material(scene, "blob", {0.35, 0.6, 0.9}, 0, 0.3f);
    const uint32_t node = add_node(scene, "blob", {.translation = {4.1, 1.7, -0.3}});
    const uint32_t mesh = add_mesh(scene, "blob", make_morphing_sphere(64, 32), material);
    scene.meshes[mesh].weights = {0, 0};
    scene.nodes[node].mesh = mesh;
    animate(
        animation, node, AnimationPath::weights, 4,
        [](double t, auto& values) {
            const auto key = static_cast<int>(std::lround(4 * t));
            for (const float v : {0.f, 0.f, key == 1 ? 1.f : 0.f, key == 3 ? 1.f : 0.f, 0.f, 0.f})
                values.push_back(v);
        },
        Interpolation::cubic_spline);
}

/// A hand that jumps to its next place four times a full_turn.
void add_hand(Scene& scene, Animation& animation) {
    const uint32_t material = add_material(scene, "hand", {0.85, 0.2, 0.25}, 0, 0.5f);
    const uint32_t node = add_node(scene, "hand", {.translation = {1.2, 0.15, 3}});
    scene.nodes[node].mesh = add_mesh(scene, "hand", make_box({-0.12, -0.1, -0.12}, {1.3, 0.1, 0.12}), material);
    spin(animation, node, {0, 1, 0}, -1, Interpolation::step, 8);
}

/// Two rings that circle against each other; a small glowing ball shows where a light is.
void add_moving_lights(Scene& scene, Animation& animation, uint32_t lights, uint64_t seed) {
    constexpr uint32_t most_balls = 64;
    const uint32_t rings[] = {add_node(scene, "outer ring", {.translation = {0, 2.2, 0}}),
                              add_node(scene, "inner ring", {.translation = {0, 3.4, 0}})};
    spin(animation, rings[0], {0, 1, 0}, 1);
    spin(animation, rings[1], {0, 1, 0}, -1);
    Random random(seed);
    for (uint32_t i = 0; i < lights; ++i) {
        const double angle = full_turn * i / lights + random.uniform(-0.1, 0.1);
        const double from_axis = (i % 2 ? 3.2 : 6.2) + random.uniform(-0.7, 0.7);
        const double y = random.uniform(-0.9, 0.9);
        const glm::vec3 colour = hue_colour(random.unit(), 0.55);
        const uint32_t node =
            add_node(scene, fmt::format("light {}", i),
                     {.translation = {from_axis * std::cos(angle), y, from_axis * std::sin(angle)}}, rings[i % 2]);
        const float intensity = 170.0f / static_cast<float>(lights + 8);
        scene.nodes[node].light = append(scene.lights, Light{.colour = colour, .intensity = intensity, .range = 9});
        if (i >= most_balls)
            continue;
        const uint32_t material =
            append(scene.materials,
                   Material{.name = fmt::format("ball {}", i), .base_colour = {0, 0, 0, 1}, .emissive = 2.0f * colour});
        scene.nodes[node].mesh = add_mesh(scene, fmt::format("ball {}", i), make_sphere(0.06f, 12, 6), material);
    }
}

void add_flight(Scene& scene, Animation& animation) {
    const Camera camera{.name = "flight", .yfov = 0.75};
    const auto pose = [&](double t) {
        const double angle = 0.5 * std::sin(full_turn * t);
        const glm::dvec3 eye(11 * std::sin(angle), 3.4 + 0.9 * std::cos(full_turn * t), 11 * std::cos(angle));
        return look_at(camera, eye, {0, 1.5, 0});
    };
    const PlacedCamera start = pose(0);
    const uint32_t node = add_node(scene, "flight", {start.position, glm::quat_cast(start.axes), glm::dvec3(1)});
    scene.nodes[node].camera = append(scene.cameras, camera);
    animate(animation, node, AnimationPath::translation, 32,
            [&](double t, auto& values) { put(values, pose(t).position); });
    animate(animation, node, AnimationPath::rotation, 32,
            [&](double t, auto& values) { put(values, glm::quat_cast(pose(t).axes)); });
}

} // namespace

Scene make_motion_scene(uint32_t lights, uint64_t seed) {
    Scene scene;
    scene.name = "motion";
    scene.scenes = {{.name = "motion", .nodes = {}}};
    scene.ambient = glm::vec3(0.06f);
    for (const char* name : {"full_turn", "bend", "morph", "lights", "flight", "tick"})
        scene.animations.push_back({.name = name});
    std::vector<Animation>& animations = scene.animations;
    add_camera(scene, {.name = "front", .yfov = 0.75}, {0, 4.3, 11}, {0, 1.5, 0});
    add_stage(scene);
    add_carousel(scene, animations[0]);
    add_column(scene, animations[1]);
    add_blob(scene, animations[2]);
    add_moving_lights(scene, animations[3], lights, seed);
    add_flight(scene, animations[4]);
    add_hand(scene, animations[5]);
    return scene;
}

} // namespace prelight
