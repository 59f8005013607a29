#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <scene/procedural/bounce.hpp>
#include <scene/procedural/builder.hpp>
#include <scene/procedural/random.hpp>
#include <scene/procedural/shapes.hpp>

namespace prelight {
namespace {

/// An axis-aligned box of one colour, world space, metres.
struct Block {
    const char* name;
    glm::vec3 colour{0}, low{0}, high{0};
};

constexpr glm::vec3 white(0.78f, 0.77f, 0.74f), red(0.75f, 0.07f, 0.05f), blue(0.08f, 0.16f, 0.62f),
    ochre(0.72f, 0.45f, 0.12f), wood(0.7f, 0.6f, 0.46f);

// The room is 6 × 3 × 5 m, its walls 0.2 m thick; the window is cut out of the wall at x = 3.
constexpr glm::vec2 window_y(1.0f, 2.5f), window_z(-1.3f, 0.9f);
constexpr Block blocks[] = {
    {"floor", wood, {-3.2f, -0.2f, -2.7f}, {3.2f, 0, 2.7f}},
    {"ceiling", white, {-3.2f, 3, -2.7f}, {3.2f, 3.2f, 2.7f}},
    {"left wall", white, {-3.2f, 0, -2.7f}, {-3, 3, 2.7f}},
    {"back wall", white, {-3, 0, -2.7f}, {3, 3, -2.5f}},
    {"front wall", white, {-3, 0, 2.5f}, {3, 3, 2.7f}},
    {"below the window", white, {3, 0, -2.7f}, {3.2f, window_y.x, 2.7f}},
    {"above the window", white, {3, window_y.y, -2.7f}, {3.2f, 3, 2.7f}},
    {"behind the window", white, {3, window_y.x, -2.7f}, {3.2f, window_y.y, window_z.x}},
    {"before the window", white, {3, window_y.x, window_z.y}, {3.2f, window_y.y, 2.7f}},
    {"carpet", red, {-1.5f, 0, -1.9f}, {0.5f, 0.02f, -0.1f}},
    {"chest", blue, {-0.5f, 0, 0.15f}, {0.6f, 0.55f, 0.75f}},
    {"shelf", ochre, {-3, 0, -1.1f}, {-2.7f, 1.9f, 0.5f}},
    {"column", white, {1.5f, 0, -2.1f}, {1.9f, 3, -1.7f}},
};
const glm::dvec3 sun = glm::normalize(glm::dvec3(-0.82, -0.52, -0.14));
constexpr float sun_lux = 24;
constexpr double inner = std::numbers::pi / 4; ///< of a virtual light's cone

struct Found {
    glm::dvec3 position{0}, normal{0};
    glm::vec3 colour{0};
};

/// The first block on a ray, by its slabs.
Found first_block(const glm::dvec3& from, const glm::dvec3& along) {
    Found found{};
    double nearest = 1e30;
    for (const Block& block : blocks) {
        const glm::dvec3 a = (glm::dvec3(block.low) - from) / along, b = (glm::dvec3(block.high) - from) / along;
        const glm::dvec3 in = glm::min(a, b), out = glm::max(a, b);
        const double entry = std::max({in.x, in.y, in.z});
        if (entry > std::min({out.x, out.y, out.z}) || entry <= 1e-6 || entry >= nearest)
            continue;
        nearest = entry;
        glm::dvec3 normal(0);
        const int axis = in.x == entry ? 0 : in.y == entry ? 1 : 2;
        normal[axis] = along[axis] > 0 ? -1 : 1;
        found = {from + entry * along, normal, block.colour};
    }
    return found;
}

Node& add_shining(Scene& scene, const Light& light, const glm::dvec3& from, const glm::dvec3& along) {
    const glm::dvec3 up = std::abs(along.y) > 0.9 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
    return add_light_towards(scene, light, from, from + along, up);
}

/// Place `i` of an even sequence over the unit square (Roberts' R2, from the plastic number).
glm::dvec2 place_in_square(uint32_t i, glm::dvec2 begin) {
    return glm::fract(begin + double(i) * glm::dvec2(0.7548776662466927, 0.5698402909980532));
}

void add_virtual_lights(Scene& scene, uint32_t count, uint64_t seed) {
    Random random(seed);
    // One by one: in which order a call's arguments are evaluated is the compiler's business.
    const double second = random.unit(), first = random.unit();
    const glm::dvec2 begin(first, second);
    const double area = double(window_y.y - window_y.x) * double(window_z.y - window_z.x);
    const double lumens = sun_lux * area * std::abs(sun.x) / count; // each share of the window's
    for (uint32_t i = 0; i < count; ++i) {
        const glm::dvec2 at = place_in_square(i, begin);
        const glm::dvec3 from(3.0, glm::mix(double(window_y.x), double(window_y.y), at.x),
                              glm::mix(double(window_z.x), double(window_z.y), at.y));
        const Found patch = first_block(from - 0.25 * sun, sun); // the wall is thick: its reveal takes some
        // A Lambert surface shines by the cosine from its normal; a spot out to 90° by min(cos / cos(inner), 1)², which
        // makes 2π (1 − ⅔ cos(inner)) times its candela. 0.96: what Fresnel leaves to the diffuse part.
        const Light light{
            .kind = LightKind::spot,
            .colour = patch.colour,
            .intensity = static_cast<float>(0.96 * lumens / (2 * std::numbers::pi * (1 - 2.0 / 3 * std::cos(inner)))),
            .range = 12,
            .inner_cone = static_cast<float>(inner),
            .outer_cone = static_cast<float>(std::numbers::pi / 2),
            .casts_shadow = false};
        add_shining(scene, light, patch.position + 0.01 * patch.normal, patch.normal);
    }
}

} // namespace

Scene make_bounce_scene(uint32_t lights, uint64_t seed) {
    Scene scene;
    scene.name = "bounce";
    scene.scenes = {{.name = "bounce", .nodes = {}}};
    add_camera(scene, {.name = "room", .yfov = 0.95}, {1.6, 1.75, 2.35}, {-1.2, 1.05, -1.4});
    add_camera(scene, {.name = "patch", .yfov = 0.8}, {-2.2, 1.9, 2.2}, {0.2, 0.1, -0.6});
    for (const Block& block : blocks) {
        const uint32_t material = append(
            scene.materials,
            Material{.name = block.name, .base_colour = glm::vec4(block.colour, 1), .metallic = 0, .roughness = 0.9f});
        add_root(scene, block.name, glm::dmat4(1)).mesh =
            add_mesh(scene, block.name, make_box(block.low, block.high), material);
    }
    const uint32_t plaster =
        append(scene.materials,
               Material{.name = "ball", .base_colour = {0.8f, 0.8f, 0.8f, 1}, .metallic = 0, .roughness = 0.6f});
    add_root(scene, "ball", translation({-1.9, 0.45, -1.5})).mesh =
        add_mesh(scene, "ball", make_sphere(0.45f, 64, 32), plaster);
    add_shining(scene,
                {.name = "sun", .kind = LightKind::directional, .colour = {1, 0.95f, 0.86f}, .intensity = sun_lux},
                {6, 4, 0.5}, sun);
    add_virtual_lights(scene, lights - 1, seed);
    return scene;
}

} // namespace prelight
