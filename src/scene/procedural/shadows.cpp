#include <cmath>
#include <glm/geometric.hpp>
#include <scene/procedural/builder.hpp>
#include <scene/procedural/random.hpp>
#include <scene/procedural/shadows.hpp>
#include <scene/procedural/shapes.hpp>

namespace prelight {
namespace {

/// A picture of a grid: opaque bars, nothing between them.
TextureImage bars() {
    constexpr uint32_t size = 64, period = 16, width = 6;
    TextureImage image{.name = "bars", .width = size, .height = size, .rgba = {}};
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x) {
            const bool bar = x % period < width || y % period < width;
            image.rgba.insert(image.rgba.end(), {255, 255, 255, static_cast<uint8_t>(bar ? 255 : 0)});
        }
    return image;
}

/// Objects of one material each, named as it.
class Things {
public:
    explicit Things(Scene& scene) : scene_(scene) {}

    void box(const char* name, glm::vec3 colour, glm::vec3 low, glm::vec3 high, glm::dvec3 at, double turn = 0) {
        place(name, make_box(low, high), material(name, colour), at, turn);
    }
    void sphere(const char* name, glm::vec3 colour, float radius, glm::dvec3 at) {
        place(name, make_sphere(radius, 64, 32), material(name, colour), at, 0);
    }
    void fence(glm::dvec3 at, double turn) {
        Material bars_of{.name = "fence",
                         .base_colour = {0.5f, 0.55f, 0.6f, 1},
                         .metallic = 0,
                         .roughness = 0.6f,
                         .alpha_mode = AlphaMode::mask,
                         .alpha_cutoff = 0.5f,
                         .double_sided = true};
        bars_of.base_colour_texture = {.image = append(scene_.images, bars())};
        const uint32_t index = append(scene_.materials, std::move(bars_of));
        glm::dmat4 standing = glm::rotate(glm::dmat4(1), std::acos(0.0), glm::dvec3(1, 0, 0));
        const uint32_t mesh = add_mesh(scene_, "fence", make_ground({3, 1.6f}, 1), index);
        add_root(scene_, "fence", glm::rotate(translation(at), turn, glm::dvec3(0, 1, 0)) * standing).mesh = mesh;
    }

private:
    uint32_t material(const char* name, glm::vec3 colour) {
        return append(scene_.materials,
                      Material{.name = name, .base_colour = glm::vec4(colour, 1), .metallic = 0, .roughness = 0.7f});
    }
    void place(const char* name, Primitive primitive, uint32_t index, glm::dvec3 at, double turn) {
        const uint32_t mesh = add_mesh(scene_, name, std::move(primitive), index);
        add_root(scene_, name, glm::rotate(translation(at), turn, glm::dvec3(0, 1, 0))).mesh = mesh;
    }
    Scene& scene_;
};

void add_things(Scene& scene) {
    Things things(scene);
    things.box("thin wall", {0.8f, 0.75f, 0.65f}, {-1, 0, -0.02f}, {1, 1.2f, 0.02f}, {-2.2, 0, 0}, 0.5);
    things.box("pole", {0.75f, 0.3f, 0.25f}, {-0.03f, 0, -0.03f}, {0.03f, 2, 0.03f}, {0.3, 0, 1.2});
    things.box("crate", {0.7f, 0.55f, 0.35f}, {-0.5f, 0, -0.5f}, {0.5f, 1, 0.5f}, {1.6, 0, -0.6}, 0.3);
    things.box("shelf", {0.6f, 0.6f, 0.65f}, {-0.6f, 0.6f, -0.3f}, {0.6f, 0.64f, 0.3f}, {3.6, 0, 0.6}, -0.4);
    for (int step = 0; step < 4; ++step)
        things.box("step", {0.55f, 0.6f, 0.55f}, {-0.8f, 0, 0}, {0.8f, 0.2f * static_cast<float>(step + 1), 0.3f},
                   {-4.4, 0, -0.6 - 0.3 * step});
    things.sphere("ball", {0.3f, 0.5f, 0.75f}, 0.4f, {-0.6, 0.4, -1.4});
    things.sphere("floating", {0.75f, 0.5f, 0.3f}, 0.3f, {-0.7, 1.6, 0.4});
    things.fence({0.4, 0.8, -3.2}, 0.2);
    for (int i = 0; i < 10; ++i)
        things.box("column", {0.65f, 0.62f, 0.58f}, {-0.4f, 0, -0.4f}, {0.4f, 4, 0.4f},
                   {i % 2 ? 4.5 : -5.5, 0, -6.0 - 6.0 * i});
}

void add_shadowed_lights(Scene& scene, uint32_t lights, uint64_t seed) {
    add_light_towards(scene,
                      {.name = "sun", .kind = LightKind::directional, .colour = {1, 0.93f, 0.82f}, .intensity = 1.2f},
                      {6, 7, 9}, {0, 0, 0});
    const Light kinds[] = {
        {.name = "lamp", .kind = LightKind::point, .colour = {1, 0.6f, 0.3f}, .intensity = 9, .range = 9},
        {.name = "spot",
         .kind = LightKind::spot,
         .colour = {0.4f, 0.7f, 1},
         .intensity = 50,
         .range = 14,
         .inner_cone = 0.3f,
         .outer_cone = 0.5f},
        {.name = "wide spot",
         .kind = LightKind::spot,
         .colour = {0.6f, 1, 0.5f},
         .intensity = 12,
         .range = 10,
         .inner_cone = 0.8f,
         .outer_cone = 1.3f}};
    const std::pair<glm::dvec3, glm::dvec3> places[] = {
        {{-0.4, 1.1, 2.2}, {-0.4, 0, 2}}, {{3.4, 3.6, 3.6}, {0.6, 0, -0.8}}, {{-3.4, 2.6, 2.4}, {-2.6, 0, 0.4}}};
    Random random(seed);
    for (uint32_t i = 0; i + 1 < lights; ++i) {
        auto [from, to] = places[i % 3];
        if (i >= 3) {
            from = {random.uniform(-7, 7), random.uniform(1, 4), random.uniform(-20, 4)};
            // One by one: in which order a call's arguments are evaluated is the compiler's business.
            const double along = random.uniform(-1, 1), across = random.uniform(-1, 1);
            to = from + glm::dvec3(across, -1, along);
        }
        add_light_towards(scene, kinds[i % 3], from, to);
    }
}

} // namespace

Scene make_shadows_scene(uint32_t lights, uint64_t seed) {
    Scene scene;
    scene.name = "shadows";
    scene.scenes = {{.name = "shadows", .nodes = {}}};
    scene.ambient = glm::vec3(0.06f);
    add_camera(scene, {.name = "front", .yfov = 0.75}, {0.4, 2.6, 6.4}, {-0.2, 0.5, -1});
    add_camera(scene, {.name = "along", .yfov = 0.9}, {-1, 1.7, 4}, {-1, 1.2, -10});
    add_camera(scene, {.name = "close", .yfov = 0.6}, {-1.2, 0.7, 2.6}, {-2.2, 0.15, 0.2});
    add_camera(scene, {.name = "pole", .yfov = 0.5}, {1.9, 0.9, 2.3}, {0.75, 0.1, 0.75});
    const uint32_t ground =
        append(scene.materials,
               Material{.name = "ground", .base_colour = {0.62f, 0.6f, 0.56f, 1}, .metallic = 0, .roughness = 0.8f});
    add_root(scene, "ground", translation({0, 0, -26})).mesh =
        add_mesh(scene, "ground", make_ground({40, 80}, 20), ground);
    add_things(scene);
    add_shadowed_lights(scene, lights, seed);
    return scene;
}

} // namespace prelight
