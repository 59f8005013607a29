// Maps whose coordinates have a transform, or a set of their own, against the same coordinates written plainly: the
// reference shares the reader and the tangents with the renderers, so that it cannot be the only judge.
#include "against_reference.hpp"
#include <cmath>
#include <filesystem>
#include <prelight/material_shader.hpp>
#include <prelight/scene_io.hpp>
#include <reference/worlds.hpp>
#include <scene/tangents.hpp>

namespace prelight {
namespace {

const std::vector<std::string> renderers_with_reference{"light-prepass", "deferred", "z-prepass", "multipass",
                                                        "reference"};

Image picture_by(const World& world, const PlacedCamera& camera, const std::string& renderer, uint32_t width = 192,
                 uint32_t height = 144) {
    RenderOptions options{.width = width, .height = height};
    options.settings = {{"texture-filter", "bilinear"}};
    options.views = {"linear"};
    const auto made = create_renderer(renderer, renderer == "reference" ? nullptr : &test_device(), options);
    made->set_world(world);
    made->render(camera);
    return made->read("linear");
}

double largest_difference(const Image& a, const Image& b) {
    double most = 0;
    for (size_t i = 0; i < a.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            most = std::max(most, std::abs(static_cast<double>(a.pixels[i][c]) - static_cast<double>(b.pixels[i][c])));
    return most;
}

void expect_same_picture(const World& given, const World& right, const PlacedCamera& camera) {
    for (const std::string& renderer : renderers_with_reference) {
        const Image a = picture_by(given, camera, renderer), b = picture_by(right, camera, renderer);
        EXPECT_LT(largest_difference(a, b), 0.002) << renderer;
    }
    expect_validation_clean(test_device());
}

TextureRef turned(uint32_t image, float rotation, glm::vec2 scale, glm::vec2 offset = glm::vec2(0)) {
    TextureRef ref{.image = image};
    const float c = std::cos(rotation), s = std::sin(rotation);
    ref.uv_linear = glm::mat2(glm::vec2(c, -s) * scale.x, glm::vec2(s, c) * scale.y);
    ref.uv_offset = offset;
    return ref;
}

std::vector<glm::vec2> baked(const std::vector<glm::vec2>& uvs, const TextureRef& ref) {
    std::vector<glm::vec2> out;
    for (const glm::vec2& uv : uvs)
        out.push_back(ref.uv_linear * uv + ref.uv_offset);
    return out;
}

/// A bumpy patch around `middle` with smooth normals, texture coordinates not square to it.
Primitive patch(glm::vec2 middle, float half) {
    constexpr int n = 8;
    Primitive p;
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x) {
            const float u = static_cast<float>(x) / n, v = static_cast<float>(y) / n;
            const glm::vec2 at = middle + half * glm::vec2(2 * u - 1, 1 - 2 * v);
            p.positions.emplace_back(at.x, at.y, 0.1f * std::sin(4 * u) * std::cos(3 * v));
            p.normals.push_back(glm::normalize(glm::vec3(-0.4f * std::cos(4 * u) * std::cos(3 * v),
                                                         -0.3f * std::sin(4 * u) * std::sin(3 * v), 2 * half)));
            p.texcoords[0].emplace_back(u + 0.3f * v, v);
        }
    for (uint32_t y = 0; y < n; ++y)
        for (uint32_t x = 0; x < n; ++x) {
            const uint32_t a = y * (n + 1) + x, b = a + n + 1;
            for (const uint32_t i : {a, b, b + 1, a, b + 1, a + 1})
                p.indices.push_back(i);
        }
    return p;
}

/// Waves that differ in both directions.
uint32_t add_waves(TestWorld& world, bool heights = false) {
    constexpr uint32_t size = 64;
    std::vector<uint8_t> rgba;
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x) {
            const float u = (x + 0.5f) / size * 6.2831853f, v = (y + 0.5f) / size * 6.2831853f;
            const glm::vec3 n = glm::normalize(glm::vec3(0.5f * std::sin(u), 0.25f * std::cos(2 * v), 1));
            for (int c = 0; c < 3; ++c)
                rgba.push_back(static_cast<uint8_t>(std::lround(
                    255 * (heights ? 0.5f + 0.2f * std::sin(u) + 0.2f * std::sin(2 * v) : 0.5f + 0.5f * n[c]))));
            rgba.push_back(255);
        }
    return world.add_image(size, size, std::move(rgba));
}

void light_up(TestWorld& world) {
    world.add_light({.kind = LightKind::directional, .colour = {1, 0.9f, 0.7f}, .intensity = 2}, {},
                    {-0.7, -0.4, -0.6});
    world.world.ambient = {0.05f, 0.05f, 0.05f};
}

/// Twelve ways to read a texture.
std::vector<TextureRef> twelve_ways(uint32_t image) {
    return {turned(image, 0, {1, 1}, {0.3f, 0.1f}),
            turned(image, 0.5236f, {1, 1}),
            turned(image, 1.5708f, {1, 1}, {0, 1}),
            turned(image, 3.1416f, {1, 1}),
            turned(image, -0.7f, {2, 2}),
            turned(image, 0, {-1, 1}, {1, 0}),
            turned(image, 0, {1, -1}, {0, 1}),
            turned(image, 0, {3, 0.5f}),
            turned(image, 0.9f, {0.5f, 2}),
            turned(image, 2.2f, {-1, 0.7f}),
            turned(image, 1, {-1, -1}),
            turned(image, -1.5708f, {1, -2}, {0.5f, 0.5f})};
}

/// A wall of twelve patches, each with a material that reads its maps in another way: by transform or from `set`, in
/// which the coordinates are baked. `first`: 1 leaves out the one with a mere offset, for which a map beside the normal
/// map shares its smooth frame in set 0, and has its triangles' in set 1.
enum class CoordinatesBy { transform, set_0, set_1 };
template <class Dress>
std::unique_ptr<TestWorld> wall(CoordinatesBy way, bool heights, Dress dress, uint32_t first = 0) {
    auto world = std::make_unique<TestWorld>();
    const uint32_t image = add_waves(*world, heights);
    Mesh mesh{"wall", {}};
    uint32_t i = 0;
    for (TextureRef ref : twelve_ways(image)) {
        if (first > 0) {
            --first;
            continue;
        }
        Primitive p = patch({-1.5f + static_cast<float>(i % 4), 1.0f - static_cast<float>(i / 4)}, 0.48f);
        p.material = i++;
        if (way != CoordinatesBy::transform) {
            p.texcoords[way == CoordinatesBy::set_0 ? 0 : 1] = baked(p.texcoords[0], ref);
            ref = {.image = image, .texcoord = way == CoordinatesBy::set_0 ? 0u : 1u};
        }
        Material& material = world->add_material({.name = "patch", .metallic = 0, .roughness = 0.6f});
        dress(material, ref);
        generate_tangents(p, material.normal_texture);
        mesh.primitives.push_back(std::move(p));
    }
    world->scene.meshes.push_back(std::move(mesh));
    world->place(0, glm::dmat4(1));
    light_up(*world);
    return world;
}

const PlacedCamera wall_camera = front_camera(4);

TEST(NormalMapCoordinates, ATransformIsTheSameBakedIn) {
    const auto dress = [](Material& material, const TextureRef& ref) { material.normal_texture = ref; };
    const auto given = wall(CoordinatesBy::transform, false, dress), right = wall(CoordinatesBy::set_0, false, dress);
    expect_same_picture(given->world, right->world, wall_camera);
}

TEST(NormalMapCoordinates, AnotherSetIsTheSameAsTheFirst) {
    const auto dress = [](Material& material, const TextureRef& ref) { material.normal_texture = ref; };
    const auto given = wall(CoordinatesBy::set_1, false, dress), right = wall(CoordinatesBy::set_0, false, dress);
    expect_same_picture(given->world, right->world, wall_camera);
}

void with_details(Material& material, const TextureRef& ref) {
    material.shader = find_material_shader("detailed");
    material.textures["detail_normal_map"] = ref;
    material.normal_texture = {.image = ref.image}; // on the plain coordinates
}

void with_relief(Material& material, const TextureRef& ref) {
    material.shader = find_material_shader("detailed");
    material.textures["height_map"] = ref;
    material.parameters["depth"] = glm::vec4(0.05f);
}

TEST(DetailMapCoordinates, AreTheirOwn) {
    const auto given = wall(CoordinatesBy::transform, false, with_details, 1);
    const auto right = wall(CoordinatesBy::set_1, false, with_details, 1);
    expect_same_picture(given->world, right->world, wall_camera);
}

TEST(DetailMapCoordinates, AgreeWithTheReference) {
    for (const auto& dress : {with_details, with_relief}) {
        const auto world = wall(CoordinatesBy::transform, dress == with_relief, dress);
        for (const char* renderer : {"light-prepass", "deferred"})
            expect_agrees({.world = &world->world, .camera = wall_camera, .renderer = renderer});
    }
}

/// Flat, square coordinates: vertex tangents of the normal map's own coordinates are exact there, and so must be the
/// frames that details make for themselves.
TEST(DetailMapCoordinates, TurnSlopesAsTheNormalMapItselfWould) {
    const auto flat = [](bool as_detail) {
        auto world = std::make_unique<TestWorld>();
        const uint32_t image = add_waves(*world);
        Material& material = world->add_material({.name = "flat", .metallic = 0, .roughness = 0.6f});
        const TextureRef ref = turned(image, 0.6f, {2, -2});
        Primitive p = square(1.6f);
        if (as_detail) {
            material.shader = find_material_shader("detailed");
            material.textures["detail_normal_map"] = ref;
            material.parameters["detail"] = glm::vec4(0.2f);
        } else {
            material.normal_texture = ref;
            material.normal_scale = 0.2f;
        }
        generate_tangents(p, material.normal_texture);
        world->add(std::move(p), glm::rotate(glm::dmat4(1), 0.5, glm::dvec3(0, 1, 0)));
        light_up(*world);
        return world;
    };
    const auto detail = flat(true), normal = flat(false);
    // UDN takes slopes from the texel's own length: a little off where z of the map is not 1.
    for (const std::string& renderer : renderers_with_reference)
        EXPECT_LT(largest_difference(picture_by(detail->world, wall_camera, renderer),
                                     picture_by(normal->world, wall_camera, renderer)),
                  0.05)
            << renderer;
}

TEST(ReliefCoordinates, MoveEveryMapWithThem) {
    const auto dress = [](Material& material, const TextureRef& ref) {
        with_relief(material, ref);
        material.base_colour_texture = ref;
    };
    const auto given = wall(CoordinatesBy::transform, true, dress, 1);
    const auto right = wall(CoordinatesBy::set_1, true, dress, 1);
    expect_same_picture(given->world, right->world, wall_camera);
}

TEST(NormalMapCoordinates, CasesAreTheirPlainForms) {
    const std::filesystem::path folder = std::filesystem::path(PRELIGHT_SHARED_SCENES) / ".." / "cases";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << "no cases beside the repository";
    for (const char* name : {"normal_transform_rot30", "normal_transform_rot90"}) {
        const Scene given = load_gltf(folder / (std::string(name) + ".glb")),
                    right = load_gltf(folder / (std::string(name) + "_right.glb"));
        const World a = resolve(given), b = resolve(right);
        expect_same_picture(a, b, a.cameras.at(0));
    }
}

} // namespace
} // namespace prelight
