#pragma once
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <prelight/camera.hpp>
#include <prelight/reference.hpp>
#include <prelight/scene.hpp>

namespace prelight {

/// A small world built by hand: a scene with one mesh per call, and its resolved world.
struct TestWorld {
    Scene scene;
    World world;

    TestWorld() {
        scene.name = "test";
        world.scene = &scene;
    }
    TestWorld(const TestWorld&) = delete;
    TestWorld& operator=(const TestWorld&) = delete;

    Material& add_material(Material material = {}) {
        scene.materials.push_back(material);
        return scene.materials.back();
    }
    /// Adds a mesh of one primitive with the last material, and one instance of it.
    void add(Primitive primitive, const glm::dmat4& transform = glm::dmat4(1)) {
        if (scene.materials.empty())
            add_material();
        primitive.material = static_cast<uint32_t>(scene.materials.size() - 1);
        scene.meshes.push_back({"mesh", {std::move(primitive)}});
        place(static_cast<uint32_t>(scene.meshes.size() - 1), transform);
    }
    void place(uint32_t mesh, const glm::dmat4& transform) {
        world.instances.push_back(
            {.mesh = mesh, .transform = transform, .mirrored = glm::determinant(glm::dmat3(transform)) < 0});
    }
    PlacedLight& add_light(const Light& light, glm::dvec3 position, glm::dvec3 direction = {0, 0, -1}) {
        world.lights.push_back({light, position, glm::normalize(direction)});
        return world.lights.back();
    }
    uint32_t add_image(uint32_t width, uint32_t height, std::vector<uint8_t> rgba) {
        scene.images.push_back({"image", width, height, std::move(rgba)});
        return static_cast<uint32_t>(scene.images.size() - 1);
    }
};

/// A square in z = 0 that faces +Z, −half … half, texture coordinates 0 … 1 with (0, 0) top left.
inline Primitive square(float half) {
    Primitive primitive;
    primitive.positions = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
    primitive.normals.assign(4, {0, 0, 1});
    primitive.tangents.assign(4, {1, 0, 0, 1});
    primitive.texcoords[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    primitive.indices = {0, 1, 2, 0, 2, 3};
    return primitive;
}

/// A unit sphere with smooth normals.
inline Primitive sphere(uint32_t segments = 64) {
    Primitive primitive;
    const uint32_t rings = segments / 2;
    for (uint32_t r = 0; r <= rings; ++r)
        for (uint32_t s = 0; s <= segments; ++s) {
            const float theta = 3.14159265f * static_cast<float>(r) / static_cast<float>(rings);
            const float phi = 6.2831853f * static_cast<float>(s) / static_cast<float>(segments);
            const glm::vec3 point(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
            primitive.positions.push_back(point);
            primitive.normals.push_back(point);
            primitive.tangents.push_back({std::cos(phi), 0, -std::sin(phi), 1});
            primitive.texcoords[0].push_back({static_cast<float>(s) / static_cast<float>(segments),
                                              static_cast<float>(r) / static_cast<float>(rings)});
        }
    for (uint32_t r = 0; r < rings; ++r)
        for (uint32_t s = 0; s < segments; ++s) {
            const uint32_t a = r * (segments + 1) + s, b = a + segments + 1;
            for (const uint32_t index : {a, b, b + 1, a, b + 1, a + 1})
                primitive.indices.push_back(index);
        }
    return primitive;
}

/// On the +Z axis at `distance`, towards the origin.
inline PlacedCamera front_camera(double distance, double yfov = 0.8) {
    Camera camera;
    camera.yfov = yfov;
    return look_at(camera, {0, 0, distance}, {0, 0, 0});
}

/// World position of a pixel's centre on the plane z = 0 for `front_camera`.
inline glm::dvec3 on_plane(double distance, double yfov, uint32_t x, uint32_t y, uint32_t width, uint32_t height) {
    const double half = std::tan(yfov / 2) * distance;
    return {(2 * (x + 0.5) / width - 1) * half * width / height, (1 - 2 * (y + 0.5) / height) * half, 0};
}

} // namespace prelight
