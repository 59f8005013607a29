#include "thin_scenes.hpp"
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

using namespace prelight;

namespace {

using Random = std::minstd_rand;

float uniform(Random& random, float low, float high) {
    return low + (high - low) * static_cast<float>(random() % 65536) / 65535.0f;
}

/// Corners go round counter-clockwise as seen from where `normal` points.
void add_quad(Primitive& to, const glm::vec3 (&corners)[4], glm::vec3 normal) {
    const auto first = static_cast<uint32_t>(to.positions.size());
    constexpr glm::vec2 places[4] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    for (int i = 0; i < 4; ++i) {
        to.positions.push_back(corners[i]);
        to.normals.push_back(normal);
        to.texcoords[0].push_back(places[i]);
    }
    for (const uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
        to.indices.push_back(first + corner);
}

/// A square rod without ends.
void add_rod(Primitive& to, glm::vec3 from, glm::vec3 until, float thickness) {
    const glm::vec3 along = glm::normalize(until - from);
    const glm::vec3 up = std::abs(along.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1);
    glm::vec3 right = glm::normalize(glm::cross(along, up)), away = glm::cross(right, along);
    for (int side = 0; side < 4; ++side) {
        const glm::vec3 a = (away - right) * (thickness / 2), b = (away + right) * (thickness / 2);
        const glm::vec3 corners[4] = {from + a, from + b, until + b, until + a};
        const bool outwards = glm::dot(glm::cross(corners[1] - corners[0], corners[2] - corners[0]), away) > 0;
        const glm::vec3 turned[4] = {corners[3], corners[2], corners[1], corners[0]};
        add_quad(to, outwards ? corners : turned, away);
        const glm::vec3 next = right;
        right = -away;
        away = next;
    }
}

void add_floor(Primitive& to, float half) {
    add_quad(to, {{-half, 0, half}, {half, 0, half}, {half, 0, -half}, {-half, 0, -half}}, {0, 1, 0});
}

uint32_t add_material(Scene& scene, const char* name, glm::vec3 colour, float roughness) {
    scene.materials.push_back(
        {.name = name, .base_colour = glm::vec4(colour, 1), .metallic = 0, .roughness = roughness});
    return static_cast<uint32_t>(scene.materials.size() - 1);
}

void add_node(Scene& scene, Node node) {
    scene.nodes.push_back(std::move(node));
    scene.scenes[0].nodes.push_back(static_cast<uint32_t>(scene.nodes.size() - 1));
}

void add_light(Scene& scene, const Light& light, glm::dvec3 position, glm::dvec3 target) {
    const PlacedCamera from = look_at({}, position, target);
    Node node{.name = "light", .light = static_cast<uint32_t>(scene.lights.size())};
    node.local = glm::dmat4(from.axes);
    node.local[3] = glm::dvec4(position, 1);
    scene.lights.push_back(light);
    add_node(scene, std::move(node));
}

/// The mesh of all primitives, a camera, and the light of a day with `lamps` in it.
void finish(Scene& scene, std::vector<Primitive> primitives, glm::dvec3 eye, glm::dvec3 target) {
    scene.meshes.push_back({scene.name, std::move(primitives)});
    Node mesh{.name = scene.name};
    mesh.mesh = 0;
    add_node(scene, std::move(mesh));
    const PlacedCamera camera = look_at({}, eye, target);
    scene.cameras.push_back({.name = "front", .yfov = 0.7});
    Node seen{.name = "front"};
    seen.camera = 0;
    seen.local = glm::dmat4(camera.axes);
    seen.local[3] = glm::dvec4(eye, 1);
    add_node(scene, std::move(seen));
    add_light(scene, {.kind = LightKind::directional, .colour = {1, 0.95f, 0.85f}, .intensity = 2.2f}, {3, 5, 4},
              {0, 0, 0});
    for (int i = 0; i < 6; ++i)
        add_light(scene, {.kind = LightKind::point, .colour = {1, 0.7f, 0.4f}, .intensity = 3, .range = 3},
                  {-3.0 + 1.2 * i, 0.6, i % 2 ? 0.8 : -0.9}, {0, 0, 0});
    scene.ambient = glm::vec3(0.12f, 0.14f, 0.18f);
}

/// Leaves on a twig, as alpha.
TextureImage leaf_image() {
    constexpr uint32_t size = 128;
    TextureImage image{"leaves", size, size, std::vector<uint8_t>(size_t(size) * size * 4, 0)};
    Random random(7);
    const auto paint = [&](glm::vec2 middle, float angle, float length, float green) {
        const glm::vec2 along(std::cos(angle), std::sin(angle));
        for (uint32_t y = 0; y < size; ++y)
            for (uint32_t x = 0; x < size; ++x) {
                const glm::vec2 to = glm::vec2(x, y) - middle;
                const float u = glm::dot(to, along) / length, v = (to.x * along.y - to.y * along.x) / (length * 0.42f);
                if (u * u + std::abs(v) > 1 - 0.2f * u)
                    continue;
                uint8_t* texel = &image.rgba[(size_t(y) * size + x) * 4];
                texel[0] = static_cast<uint8_t>(70 * green), texel[1] = static_cast<uint8_t>(150 * green);
                texel[2] = static_cast<uint8_t>(50 * green), texel[3] = 255;
            }
    };
    for (int i = 0; i < 26; ++i) { // in an order of their own: that of arguments is the compiler's business
        const float green = uniform(random, 0.6f, 1.4f), length = uniform(random, 9, 16);
        const float angle = uniform(random, 0, 6.28f), x = uniform(random, 18, 110), y = uniform(random, 18, 110);
        paint({x, y}, angle, length, green);
    }
    return image;
}

} // namespace

Scene make_leaves() {
    Scene scene;
    scene.name = "leaves";
    scene.scenes.push_back({"leaves", {}});
    scene.images.push_back(leaf_image());
    const uint32_t lawn = add_material(scene, "lawn", {0.16f, 0.22f, 0.09f}, 0.9f);
    const uint32_t bark = add_material(scene, "bark", {0.2f, 0.13f, 0.08f}, 0.8f);
    const uint32_t leaf = add_material(scene, "leaves", {1, 1, 1}, 0.6f);
    scene.materials[leaf].alpha_mode = AlphaMode::mask;
    scene.materials[leaf].double_sided = true;
    scene.materials[leaf].base_colour_texture.image = 0;
    Primitive floor, trunk, cards;
    floor.material = lawn, trunk.material = bark, cards.material = leaf;
    add_floor(floor, 12);
    Random random(3);
    for (const float x : {-1.7f, 0.1f, 1.9f}) {
        const float z = -0.4f * std::abs(x);
        add_rod(trunk, {x, 0, z}, {x, 1.7f, z}, 0.12f);
        for (int i = 0; i < 90; ++i) {
            glm::vec3 out{0};
            out.z = uniform(random, -1, 1), out.y = uniform(random, -0.8f, 1), out.x = uniform(random, -1, 1);
            out = glm::normalize(out + glm::vec3(0, 0, 0.01f)) * uniform(random, 0.3f, 0.85f);
            const glm::vec3 middle = glm::vec3(x, 1.9f, z) + out, n = glm::normalize(out + glm::vec3(0, 0.3f, 0));
            const glm::vec3 right = glm::normalize(glm::cross(n, glm::vec3(0.3f, 0.9f, 0.2f))) * 0.28f;
            const glm::vec3 up = glm::cross(n, right);
            add_quad(cards, {middle - right - up, middle + right - up, middle + right + up, middle - right + up}, n);
        }
    }
    finish(scene, {floor, trunk, cards}, {0, 1.7, 6.5}, {0, 1.35, 0});
    return scene;
}

Scene make_wires() {
    Scene scene;
    scene.name = "wires";
    scene.scenes.push_back({"wires", {}});
    const uint32_t ground = add_material(scene, "ground", {0.3f, 0.29f, 0.27f}, 0.7f);
    const uint32_t wall = add_material(scene, "wall", {0.12f, 0.15f, 0.2f}, 0.8f);
    const uint32_t wire = add_material(scene, "wire", {0.85f, 0.82f, 0.75f}, 0.5f);
    Primitive floor, back, wires;
    floor.material = ground, back.material = wall, wires.material = wire;
    add_floor(floor, 12);
    add_quad(back, {{-12, 0, -4}, {12, 0, -4}, {12, 9, -4}, {-12, 9, -4}}, {0, 0, 1});
    for (int i = -22; i <= 22; ++i) { // leaning a little more from bar to bar
        const float x = 0.14f * static_cast<float>(i), lean = 0.01f * static_cast<float>(i);
        add_rod(wires, {x, 0, 0}, {x + lean, 0.9f, 0}, 0.012f);
    }
    for (const float y : {0.12f, 0.86f})
        add_rod(wires, {-3.2f, y, 0}, {3.2f, y, 0}, 0.024f);
    for (int cable = 0; cable < 9; ++cable) {
        const float thickness = 0.008f + 0.002f * static_cast<float>(cable),
                    y = 1.3f + 0.2f * static_cast<float>(cable);
        const float z = -0.35f * static_cast<float>(cable);
        const auto at = [&](int i) {
            const float t = static_cast<float>(i) / 12;
            return glm::vec3(-4 + 8 * t, y - 1.2f * t * (1 - t) + 0.3f * t, z);
        };
        for (int i = 0; i < 12; ++i)
            add_rod(wires, at(i), at(i + 1), thickness);
    }
    finish(scene, {floor, back, wires}, {0, 1.5, 6.5}, {0, 1.35, 0});
    return scene;
}
