#include <cmath>
#include <prelight/light_distribution.hpp>
#include <scene/procedural/builder.hpp>
#include <scene/procedural/cookie_maps.hpp>
#include <scene/procedural/cookies.hpp>
#include <scene/procedural/random.hpp>
#include <scene/procedural/shapes.hpp>

namespace prelight {
namespace {

void add_box(Scene& scene, const char* name, glm::vec3 colour, glm::vec3 low, glm::vec3 high, float roughness = 0.8f) {
    const uint32_t material =
        append(scene.materials,
               Material{.name = name, .base_colour = glm::vec4(colour, 1), .metallic = 0, .roughness = roughness});
    add_root(scene, name, glm::dmat4(1)).mesh = add_mesh(scene, name, make_box(low, high), material);
}

void add_room(Scene& scene) {
    const glm::vec3 plaster(0.75f, 0.72f, 0.66f);
    add_box(scene, "floor", {0.55f, 0.5f, 0.45f}, {-6, -0.1f, -4}, {6, 0, 6}, 0.55f);
    add_box(scene, "back wall", plaster, {-6, 0, -4.1f}, {6, 4.2f, -4});
    add_box(scene, "left wall", plaster, {-6.1f, 0, -4}, {-6, 4.2f, 6});
    add_box(scene, "right wall", plaster, {6, 0, -4}, {6.1f, 4.2f, 6});
    add_box(scene, "ceiling", plaster, {-6, 4.2f, -4}, {6, 4.3f, 6});
    add_box(scene, "pillar", {0.65f, 0.62f, 0.6f}, {-5.2f, 0, -2.4f}, {-4.7f, 4.2f, -1.9f});
    add_box(scene, "table", {0.5f, 0.35f, 0.25f}, {2, 0.66f, -1.4f}, {3.6f, 0.72f, -0.2f}, 0.45f);
    for (const float x : {2.05f, 3.45f})
        for (const float z : {-1.35f, -0.35f})
            add_box(scene, "leg", {0.5f, 0.35f, 0.25f}, {x, 0, z}, {x + 0.1f, 0.66f, z + 0.1f}, 0.45f);
    add_box(scene, "chest", {0.45f, 0.5f, 0.6f}, {-1.2f, 0, -3.3f}, {0.4f, 0.7f, -2.5f});
    const uint32_t ball =
        append(scene.materials,
               Material{.name = "ball", .base_colour = {0.8f, 0.8f, 0.8f, 1}, .metallic = 0, .roughness = 0.35f});
    add_root(scene, "ball", translation({-0.9, 0.45, 0.4})).mesh =
        add_mesh(scene, "ball", make_sphere(0.45f, 48, 24), ball);
}

/// A light that looks from one place to another, +Y up as far as that goes.
Node& add_aimed(Scene& scene, const Light& light, glm::dvec3 from, glm::dvec3 to) {
    Node& node = add_light(scene, light, from);
    node.local = glm::dmat4(light_axes({{}, from, to - from}));
    node.local[3] = {from, 1};
    return node;
}

/// Turns the scene's last node once around +Y in 12 s.
void turn_last(Scene& scene, glm::dvec3 at) {
    const auto index = static_cast<uint32_t>(scene.nodes.size() - 1);
    scene.nodes[index].trs = Trs{.translation = at};
    AnimationSampler sampler{.times = {}, .values = {}};
    for (int key = 0; key <= 8; ++key) {
        const double half = key * 3.14159265358979323846 / 8;
        sampler.times.push_back(1.5f * static_cast<float>(key));
        sampler.values.insert(sampler.values.end(),
                              {0, static_cast<float>(std::sin(half)), 0, static_cast<float>(std::cos(half))});
    }
    scene.animations.push_back(
        {.name = "lantern", .samplers = {std::move(sampler)}, .channels = {{0, index, AnimationPath::rotation}}});
}

void add_lights(Scene& scene, uint32_t lights, uint64_t seed) {
    const uint32_t window = append(scene.images, window_cookie()), lantern = append(scene.images, lantern_cookie()),
                   dice = append(scene.images, dice_cookie());
    const auto profile = std::make_shared<const LightProfile>(parse_profile(wall_lamp_profile(), "wall lamp"));
    const Light through_window{.name = "window",
                               .kind = LightKind::spot,
                               .colour = {1, 0.95f, 0.85f},
                               .intensity = 150,
                               .range = 16,
                               .inner_cone = 0.38f,
                               .outer_cone = 0.4f,
                               .cookie = window};
    const Light pierced{.name = "lantern",
                        .kind = LightKind::point,
                        .colour = {1, 0.85f, 0.6f},
                        .intensity = 12,
                        .range = 9,
                        .cookie = lantern};
    const Light pips{.name = "dice", .kind = LightKind::point, .intensity = 7, .range = 6, .cookie = dice};
    Light wall{.name = "wall lamp",
               .kind = LightKind::point,
               .colour = {1, 0.9f, 0.75f},
               .intensity = 9,
               .range = 7,
               .profile = profile};
    const Light both{.name = "stage",
                     .kind = LightKind::spot,
                     .colour = {0.8f, 0.9f, 1},
                     .intensity = 0.05f,
                     .range = 10,
                     .inner_cone = 0.7f,
                     .outer_cone = 0.8f,
                     .cookie = window,
                     .profile = profile,
                     .profile_candela = true};
    uint32_t made = 0;
    const auto wanted = [&] { return made++ < lights; };
    if (wanted())
        add_aimed(scene, through_window, {5.4, 3.7, 3.6}, {0.4, 0, 0.2});
    if (wanted()) {
        const glm::dvec3 at(-3, 1.7, -0.4);
        add_light(scene, pierced, at);
        turn_last(scene, at);
    }
    if (wanted())
        add_light(scene, pips, {2.8, 1.15, -0.8});
    for (const double x : {-2.6, 0.6, 3.8})
        if (wanted())
            add_aimed(scene, wall, {x, 2.7, -3.75}, {x, 0, -3.75});
    if (wanted())
        add_aimed(scene, both, {-3.6, 4, 3}, {-3.2, 0, 2.2});
    Random random(seed);
    for (; made < lights; ++made) {
        Light small = made % 3 == 0 ? through_window : made % 3 == 1 ? pierced : wall;
        small.range = 3;
        small.intensity *= 0.1f;
        // One by one: in which order a call's arguments are evaluated is the compiler's business.
        const double z = random.uniform(-3.5, 5), y = random.uniform(0.6, 3.8), x = random.uniform(-5.5, 5.5);
        const double along = random.uniform(-1, 1), across = random.uniform(-1, 1);
        add_aimed(scene, small, {x, y, z}, glm::dvec3(x, y, z) + glm::dvec3(across, -1, along));
    }
}

} // namespace

Scene make_cookies_scene(uint32_t lights, uint64_t seed) {
    Scene scene;
    scene.name = "cookies";
    scene.scenes = {{.name = "cookies", .nodes = {}}};
    scene.ambient = glm::vec3(0.02f);
    add_camera(scene, {.name = "front", .yfov = 0.8}, {0, 2, 6.6}, {0, 1.5, -1});
    add_camera(scene, {.name = "wall", .yfov = 0.7}, {1, 1.8, 1.5}, {1, 1.7, -4});
    add_camera(scene, {.name = "lantern", .yfov = 0.9}, {-1, 1.9, 2.8}, {-4, 1.2, -2.5});
    add_room(scene);
    add_lights(scene, lights, seed);
    return scene;
}

} // namespace prelight
