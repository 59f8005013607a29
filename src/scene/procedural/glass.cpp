#include <cmath>
#include <glm/geometric.hpp>
#include <scene/procedural/builder.hpp>
#include <scene/procedural/glass.hpp>
#include <scene/procedural/glass_maps.hpp>
#include <scene/procedural/material_maps.hpp>
#include <scene/procedural/random.hpp>
#include <scene/procedural/shapes.hpp>
#include <scene/tangents.hpp>

namespace prelight {
namespace {

constexpr glm::dvec3 front_eye(0.15, 1.6, 6.3), front_target(0.1, 0.98, -0.6); // of the camera "front"
constexpr glm::dvec3 lamp_at(-2.55, 1.62, -1.3), lantern_at(-1.75, 0.3, 1.5);
constexpr glm::dvec3 y_axis(0, 1, 0);

/// Where small lamps stand: each a glowing ball and a light.
struct Glow {
    glm::vec3 colour{0};
    glm::dvec3 at{0};
};
constexpr Glow glows[] = {{{0.15f, 0.75f, 1}, {-0.75, 0.07, -2.3}},
                          {{1, 0.2f, 0.45f}, {3.5, 0.07, -2.2}},
                          {{0.3f, 1, 0.45f}, {1.05, 0.07, -2.6}},
                          {{1, 0.55f, 0.15f}, {0.45, 0.07, 1.75}}};

Material opaque(const char* name, glm::vec3 colour, float roughness, float metallic = 0) {
    return {.name = name, .base_colour = glm::vec4(colour, 1), .metallic = metallic, .roughness = roughness};
}

Material glowing(const char* name, glm::vec3 light) {
    Material material = opaque(name, glm::vec3(0.02f), 0.6f);
    material.emissive = light;
    return material;
}

/// Objects of one material, named as they are.
class Stage {
public:
    explicit Stage(Scene& scene) : scene_(scene) {}
    uint32_t material(Material material) { return append(scene_.materials, std::move(material)); }
    void add(const char* name, Primitive shape, uint32_t of, const glm::dmat4& place) {
        add_root(scene_, name, place).mesh = add_mesh(scene_, name, std::move(shape), of);
    }
    void box(const char* name, uint32_t of, glm::vec3 low, glm::vec3 high) {
        add(name, make_box(low, high), of, glm::dmat4(1));
    }
    /// An upright rectangle with its middle at `at`, which faces +z before it is turned about y.
    void pane(const char* name, uint32_t of, glm::vec2 size, const glm::dvec3& at, double turn) {
        const glm::dmat4 turned = glm::rotate(translation(at), turn, y_axis);
        add(name, make_ground(size, 1), of, upright(turned));
    }

private:
    Scene& scene_;
};

void add_glass_room(Scene& scene, Stage& stage) {
    const uint32_t floor = stage.material(opaque("floor", glm::vec3(0.06f), 0.15f, 0.3f));
    stage.add("floor", make_ground({24, 16}, 8), floor, translation({0, 0, 2}));
    Material bricks = opaque("bricks", {0.5f, 0.56f, 0.62f}, 0.7f);
    const auto tiled = [&](TextureImage image) {
        return TextureRef{
            .image = append(scene.images, std::move(image)), .sampler = {}, .uv_linear = glm::mat2(3.5f, 0, 0, 7)};
    };
    bricks.base_colour_texture = tiled(brick_colours());
    bricks.normal_texture = tiled(brick_normals());
    bricks.normal_scale = 0.3f;
    Primitive wall = make_ground({12, 12}, 1);
    generate_tangents(wall, 0);
    stage.add("wall", std::move(wall), stage.material(std::move(bricks)),
              glm::rotate(translation({0, 5, -3.2}), full_turn / 4, glm::dvec3(1, 0, 0)));
}

/// Radius and height of a bottle from its mouth down to the middle of its base.
std::vector<glm::dvec2> bottle(double radius, double height, double neck, double shoulder) {
    constexpr int steps = 10;
    std::vector<glm::dvec2> profile{
        {neck * 1.0, height}, {neck * 1.35, height}, {neck * 1.35, height - 0.03}, {neck, height - 0.045}};
    const double low = height * 0.5, high = low + shoulder; // of the shoulder
    for (int i = 0; i <= steps; ++i) {
        const double t = double(i) / steps, bend = 0.5 - 0.5 * std::cos(full_turn / 2 * t);
        profile.emplace_back(neck + (radius - neck) * bend, high - (high - low) * t);
    }
    profile.insert(profile.end(), {{radius, 0.02}, {radius - 0.02, 0}, {0, 0}});
    return profile;
}

void add_bottles(Stage& stage) {
    const uint32_t wood = stage.material(opaque("table", {0.32f, 0.2f, 0.12f}, 0.35f));
    stage.box("table", wood, {1.55f, 0.52f, -1.4f}, {3.45f, 0.58f, -0.7f});
    for (const float x : {1.62f, 3.3f})
        for (const float z : {-1.33f, -0.85f})
            stage.box("leg", wood, {x, 0, z}, {x + 0.08f, 0.52f, z + 0.08f});
    struct Bottle {
        const char* name;
        glm::vec3 colour{0};
        float alpha;
        double radius, height, neck, shoulder;
        glm::dvec3 at{0};
    };
    constexpr double table = 0.5801;
    const char* beside = "bottle beside the long pane";
    for (const Bottle& b : {Bottle{"bottle", {0, 0.4f, 0.1f}, 0.45f, 0.15, 1.0, 0.045, 0.26, {1.78, table, -1.05}},
                            Bottle{"bottle", {0.85f, 0.3f, 0}, 0.5f, 0.19, 0.72, 0.06, 0.18, {2.18, table, -1.0}},
                            Bottle{"bottle", {0.01f, 0.12f, 0.85f}, 0.45f, 0.13, 1.12, 0.04, 0.34, {2.56, table, -1.1}},
                            Bottle{"bottle", {0.8f, 0.01f, 0.08f}, 0.45f, 0.17, 0.6, 0.07, 0.14, {2.92, table, -0.98}},
                            Bottle{"bottle", {0.5f, 0.75f, 0.8f}, 0.25f, 0.13, 0.92, 0.05, 0.22, {3.28, table, -1.05}},
                            Bottle{beside, {0.9f, 0.6f, 0}, 0.5f, 0.12, 0.5, 0.04, 0.12, {0.95, 0.0001, -0.5}},
                            Bottle{beside, {0.45f, 0.02f, 0.75f}, 0.5f, 0.14, 0.58, 0.05, 0.14, {2.9, 0.0001, 0.27}}}) {
        const std::vector<glm::dvec2> profile = bottle(b.radius, b.height, b.neck, b.shoulder);
        stage.add(b.name, make_turned(profile, 48), stage.material(sheet_material(b.name, b.colour, b.alpha, 0.12f)),
                  translation(b.at));
    }
}

void add_panes(Stage& stage) {
    const uint32_t metal = stage.material(opaque("metal", {0.5f, 0.45f, 0.4f}, 0.3f, 1));
    // Three through one axis: whichever is drawn last is over the others on both sides of it.
    constexpr glm::dvec3 axis(-0.75, 1.12, -0.7);
    constexpr glm::vec3 colours[] = {{0, 0.5f, 0.7f}, {0.75f, 0.01f, 0.3f}, {0.8f, 0.5f, 0}};
    for (int i = 0; i < 3; ++i)
        stage.pane("crossing pane", stage.material(sheet_material("crossing pane", colours[i], 0.42f)), {1.5f, 1.9f},
                   axis, 0.2 + 0.9 * (i - 1));
    const std::vector<glm::dvec2> foot{{0, 0.14}, {0.85, 0.14}, {0.88, 0.11}, {0.88, 0}};
    stage.add("foot", make_turned(foot, 64), metal, translation({axis.x, 0, axis.z}));
    // Its middle is nearer than the bottle before its far end, and farther than the one behind its near end.
    constexpr glm::dvec3 far_end(0.55, 0, -1.15), near_end(3.3, 0, 0.9);
    const glm::dvec3 along = near_end - far_end, middle = 0.5 * (near_end + far_end);
    const double length = glm::length(along), turn = -std::atan2(along.z, along.x);
    const auto half = static_cast<float>(length / 2);
    stage.pane("long pane", stage.material(sheet_material("long pane", {0.25f, 0.6f, 0.5f}, 0.28f)), {2 * half, 0.66f},
               middle + 0.36 * y_axis, turn);
    stage.add("rail", make_box({-half, -0.02f, -0.02f}, {half, 0.02f, 0.02f}), metal,
              glm::rotate(translation(middle + 0.71 * y_axis), turn, y_axis));
    for (const glm::dvec3& end : {far_end, near_end})
        stage.add("post", make_box({-0.025f, 0, -0.025f}, {0.025f, 0.75f, 0.025f}), metal, translation(end));
}

void add_ball(Stage& stage) {
    const uint32_t stone = stage.material(opaque("pedestal", {0.28f, 0.27f, 0.26f}, 0.5f));
    stage.box("pedestal", stone, {0.42f, 0, -1.98f}, {0.98f, 0.95f, -1.42f});
    const glm::dmat4 middle = translation({0.7, 1.37, -1.7});
    stage.add("knot", make_knot(0.19f, 0.05f, 192, 12), stage.material(opaque("gold", {0.9f, 0.6f, 0.2f}, 0.35f, 1)),
              glm::rotate(middle, 0.4, y_axis));
    stage.add("ball", make_sphere(0.42f, 64, 32),
              stage.material(sheet_material("ball", {0.5f, 0.7f, 0.9f}, 0.22f, 0.1f)), middle);
}

void add_lamp(Stage& stage) {
    const uint32_t brass = stage.material(opaque("brass", {0.75f, 0.55f, 0.25f}, 0.3f, 1));
    const glm::dmat4 below = translation({lamp_at.x, 0, lamp_at.z});
    const std::vector<glm::dvec2> stand{{0, 1.5}, {0.02, 1.5}, {0.02, 0.06}, {0.2, 0.03}, {0.22, 0}};
    stage.add("stand", make_turned(stand, 32), brass, below);
    stage.add("bulb", make_sphere(0.07f, 32, 16), stage.material(glowing("bulb", {24, 15, 7})), translation(lamp_at));
    Material cloth = sheet_material("shade", {0.9f, 0.7f, 0.45f}, 0.62f, 0.8f);
    cloth.emissive = {0.42f, 0.24f, 0.1f}; // what the bulb sends through it
    const std::vector<glm::dvec2> shade{{0.24, 1.92}, {0.46, 1.4}};
    stage.add("shade", make_turned(shade, 64), stage.material(std::move(cloth)), below);
}

/// Puffs stand across the view of the camera "front": at different depths, they do not cut each other.
void add_smoke(Scene& scene, Stage& stage, uint64_t seed) {
    const TextureRef texture{.image = append(scene.images, smoke_puff()),
                             .sampler = {.wrap_s = Wrap::clamp_to_edge, .wrap_t = Wrap::clamp_to_edge}};
    uint32_t kinds[3];
    for (int i = 0; i < 3; ++i) { // the nearer the flame, the more of its light
        constexpr glm::vec3 lit[] = {{0.6f, 0.25f, 0.07f}, {0.2f, 0.09f, 0.04f}, {0.04f, 0.03f, 0.032f}};
        constexpr float alpha[] = {0.42f, 0.42f, 0.4f};
        Material smoke = sheet_material("smoke", glm::vec3(0.45f, 0.44f, 0.46f), alpha[i], 1);
        smoke.emissive = lit[i];
        smoke.base_colour_texture = texture;
        kinds[i] = stage.material(std::move(smoke));
    }
    const PlacedCamera front = look_at({}, front_eye, front_target);
    const glm::dmat4 across = glm::rotate(glm::dmat4(front.axes), full_turn / 4, glm::dvec3(1, 0, 0));
    Random random(seed);
    constexpr int puffs = 18;
    for (int i = 0; i < puffs; ++i) {
        const double rise = double(i) / (puffs - 1), spin = random.uniform(0, full_turn),
                     aside = random.uniform(-1, 1) * (0.18 + 0.25 * rise);
        // Every second one behind the lantern.
        const double before = (i % 2 ? 1 : -1) * (0.28 + 0.02 * i);
        const glm::dvec3 at =
            lantern_at + glm::dvec3(aside + 0.35 * rise * rise, 0.1 + 1.35 * rise, 0) + before * front.axes[2];
        const auto size = static_cast<float>(0.55 + 0.75 * rise);
        stage.add("smoke", make_ground({size, size}, 1), kinds[i * 3 / puffs],
                  glm::rotate(translation(at) * across, spin, y_axis));
    }
}

void add_lantern(Stage& stage) {
    const uint32_t iron = stage.material(opaque("iron", {0.1f, 0.1f, 0.11f}, 0.4f, 1));
    const uint32_t glass = stage.material(sheet_material("lantern", {0.9f, 0.6f, 0.3f}, 0.25f, 0.15f));
    const auto at = glm::vec3(lantern_at);
    const auto part = [&](glm::vec3 low, glm::vec3 high) { stage.box("lantern", iron, at + low, at + high); };
    part({-0.2f, -0.3f, -0.2f}, {0.2f, -0.24f, 0.2f});
    part({-0.2f, 0.24f, -0.2f}, {0.2f, 0.29f, 0.2f});
    part({-0.1f, 0.29f, -0.1f}, {0.1f, 0.35f, 0.1f});
    for (const float x : {-0.19f, 0.16f})
        for (const float z : {-0.19f, 0.16f})
            part({x, -0.24f, z}, {x + 0.03f, 0.24f, z + 0.03f});
    for (int side = 0; side < 4; ++side) {
        const double turn = full_turn / 4 * side;
        stage.pane("lantern glass", glass, {0.32f, 0.47f},
                   lantern_at + 0.175 * glm::dvec3(std::sin(turn), 0, std::cos(turn)), turn);
    }
    const std::vector<glm::dvec2> flame{{0, 0.13},     {0.02, 0.07},  {0.045, -0.02},
                                        {0.05, -0.07}, {0.03, -0.12}, {0, -0.14}};
    stage.add("flame", make_turned(flame, 24), stage.material(glowing("flame", {7, 3.4f, 1.1f})),
              translation(lantern_at));
}

/// Lights inside of something throw no shadow: blended surfaces cast those of opaque ones, and a lamp's own bulb is
/// around it.
void add_glass_lights(Scene& scene, uint32_t lights, uint64_t seed) {
    const auto inside = [](const char* name, glm::vec3 colour, float intensity, float range) {
        return Light{.name = name, .colour = colour, .intensity = intensity, .range = range, .casts_shadow = false};
    };
    uint32_t made = 0;
    const auto wanted = [&] { return made++ < lights; };
    if (wanted())
        add_light(scene, inside("lamp", {1, 0.72f, 0.42f}, 12, 9), lamp_at);
    if (wanted())
        add_light(scene, inside("lantern", {1, 0.5f, 0.18f}, 3, 6), lantern_at);
    const Light spot{.name = "spot",
                     .kind = LightKind::spot,
                     .colour = {0.85f, 0.92f, 1},
                     .intensity = 45,
                     .range = 12,
                     .inner_cone = 0.25f,
                     .outer_cone = 0.5f};
    if (wanted())
        add_light_towards(scene, spot, {1.8, 4.6, 2}, {-0.6, 0.6, -0.8});
    if (wanted())
        add_light_towards(scene, spot, {2.4, 4.6, -1.2}, {2.3, 0.6, -2.6});
    if (wanted())
        add_light(scene, inside("pendant", {1, 0.86f, 0.7f}, 7, 7), {2.3, 2.3, 0.7});
    if (wanted())
        add_light(scene, inside("window", {0.6f, 0.75f, 1}, 9, 9), {-4.2, 2.4, 2.4});
    for (const Glow& glow : glows)
        if (wanted())
            add_light(scene, inside("glow", glow.colour, 1.6f, 4), glow.at + 0.1 * y_axis);
    Random random(seed + 1); // apart from the smoke's
    for (; made < lights; ++made) {
        const double x = random.uniform(-4.5, 4.5), y = random.uniform(0.15, 2.6), z = random.uniform(-3, 3);
        const glm::vec3 colour = hue_colour(random.unit(), 0.7);
        add_light(scene, {.colour = colour, .intensity = 0.4f, .range = 1.6f}, {x, y, z});
    }
}

} // namespace

Scene make_glass_scene(uint32_t lights, uint64_t seed) {
    Scene scene;
    scene.name = "glass";
    scene.scenes = {{.name = "glass", .nodes = {}}};
    scene.ambient = {0.035f, 0.038f, 0.05f};
    add_camera(scene, {.name = "front", .yfov = 0.56}, front_eye, front_target);
    add_camera(scene, {.name = "panes", .yfov = 0.6}, {-0.2, 1.5, 3.4}, {-0.75, 1.02, -0.7});
    add_camera(scene, {.name = "bottles", .yfov = 0.6}, {1.2, 1.15, 2.4}, {1.8, 0.6, -0.8});
    Stage stage(scene);
    add_glass_room(scene, stage);
    add_panes(stage);
    add_ball(stage);
    add_bottles(stage);
    add_lamp(stage);
    add_lantern(stage);
    add_smoke(scene, stage, seed);
    for (const Glow& glow : glows)
        stage.add("glow", make_sphere(0.07f, 32, 16), stage.material(glowing("glow", 1.3f * glow.colour)),
                  translation(glow.at));
    add_glass_lights(scene, lights, seed);
    return scene;
}

} // namespace prelight
