#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <scene/oracle.hpp>
#include <scene/procedural/random.hpp>
#include <scene/procedural/shapes.hpp>
#include <scene/tangents_compare.hpp>

// The npm package mikktspace is the oracle: every corner's tangent must be its tangent.
namespace prelight {
namespace {

class TangentsOracle : public testing::Test {
protected:
    void SetUp() override {
        if (!oracle::available("mikktspace"))
            GTEST_SKIP() << oracle::missing("mikktspace");
    }
    Random random{2024};

    glm::vec3 direction() {
        glm::dvec3 v{0};
        do {
            const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
            v = {x, y, random.uniform(-1, 1)};
        } while (glm::length(v) > 1 || glm::length(v) < 0.1);
        return glm::normalize(v);
    }
    Primitive vertices(uint32_t count, uint32_t uv_steps) {
        Primitive mesh;
        for (uint32_t i = 0; i < count; ++i) {
            mesh.positions.push_back(direction() * static_cast<float>(random.uniform(0.5, 3)));
            mesh.normals.push_back(direction());
            const double u = random.below(uv_steps), v = random.below(uv_steps);
            mesh.texcoords[0].emplace_back(u / uv_steps, v / uv_steps);
        }
        return mesh;
    }
};

TEST_F(TangentsOracle, SphereWithSeamAndPoles) { expect_oracle_tangents(make_sphere(1.7f, 40, 20)); }

TEST_F(TangentsOracle, HardEdgesAndPlanes) {
    expect_oracle_tangents(make_box({-1, 0, 2}, {3, 5, 4}));
    expect_oracle_tangents(make_ground({10, 7}, 12));
}

TEST_F(TangentsOracle, MirroredCoordinates) {
    Primitive sphere = make_sphere(1, 36, 18);
    for (auto& uv : sphere.texcoords[0])
        uv = {std::abs(4 * uv.x - 2), 3 * uv.y};
    expect_oracle_tangents(sphere);
}

TEST_F(TangentsOracle, SmoothSurfaceWithRandomCoordinates) {
    Primitive sphere = make_sphere(2, 30, 20);
    for (auto& uv : sphere.texcoords[0]) {
        const double u = random.unit();
        uv = {u, random.unit()};
    }
    expect_oracle_tangents(sphere);
}

TEST_F(TangentsOracle, SoupOfSharedVertices) {
    Primitive soup = vertices(300, 1u << 20);
    for (int i = 0; i < 3 * 4000; ++i)
        soup.indices.push_back(random.below(300));
    expect_oracle_tangents(soup, 1); // one corner's angle rounds to 0: the oracle's tangent is the zero vector
}

// Few vertices and coarse coordinates: edges with many triangles, triangles whose coordinates span
// no area, triangles without area, and equal triangles.
TEST_F(TangentsOracle, SoupOfDegenerateTriangles) {
    for (const uint32_t steps : {1u, 2u, 3u, 8u}) {
        Primitive soup = vertices(40, steps);
        for (int i = 0; i < 3 * 1500; ++i)
            soup.indices.push_back(random.below(i % 2 == 0 ? 40 : 12));
        expect_oracle_tangents(soup);
    }
}

// Coordinates that go round twice as fast as the ring: tangents of faces across it are exactly
// opposed, which MikkTSpace keeps apart.
TEST_F(TangentsOracle, RingWithOpposedCoordinates) {
    Primitive ring;
    ring.positions = {{0, 0, 0},  {1, 0, 0},   {1, 1, 0},  {0, 1, 0}, {-1, 1, 0},
                      {-1, 0, 0}, {-1, -1, 0}, {0, -1, 0}, {1, -1, 0}};
    ring.normals.assign(9, {0, 0, 1});
    ring.texcoords[0] = {{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (uint32_t i = 0; i < 8; ++i)
        ring.indices.insert(ring.indices.end(), {0, i + 1, (i + 1) % 8 + 1});
    expect_oracle_tangents(ring);
}

} // namespace
} // namespace prelight
