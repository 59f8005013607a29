#include <fstream>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <scene/oracle.hpp>
#include <scene/procedural/random.hpp>
#include <scene/procedural/shapes.hpp>
#include <scene/tangents.hpp>

// The npm package mikktspace is the oracle: every corner's tangent must be its tangent.
namespace prelight {
namespace {

std::vector<glm::vec4> ask_oracle(const Primitive& mesh) {
    const oracle::TemporaryFolder folder;
    const auto in = folder.path / "corners", out = folder.path / "tangents";
    std::ofstream file(in, std::ios::binary);
    const auto put = [&](float x) { file.write(reinterpret_cast<const char*>(&x), sizeof x); };
    for (const uint32_t i : mesh.indices) {
        const auto &p = mesh.positions[i], &n = mesh.normals[i];
        for (const float x :
             {p.x, p.y, p.z, n.x, n.y, n.z, mesh.texcoords[0][i].x, mesh.texcoords[0][i].y})
            put(x);
    }
    file.close();
    if (!oracle::run("tangents.js", fmt::format("'{}' '{}'", in.string(), out.string())))
        return {};
    std::vector<glm::vec4> tangents(mesh.indices.size());
    std::ifstream answer(out, std::ios::binary);
    answer.read(reinterpret_cast<char*>(tangents.data()),
                static_cast<std::streamsize>(tangents.size() * sizeof(glm::vec4)));
    return answer ? tangents : std::vector<glm::vec4>{};
}

struct Outcome {
    double largest = 0;   ///< distance of two unit tangents
    size_t flipped = 0;   ///< corners whose sign differs
    size_t undefined = 0; ///< corners where the oracle gives no unit vector
};

Outcome compare_with_oracle(const Primitive& mesh) {
    const std::vector<glm::vec4> expected = ask_oracle(mesh);
    Outcome outcome;
    EXPECT_EQ(expected.size(), mesh.indices.size()) << "the oracle did not run";
    if (expected.size() != mesh.indices.size())
        return outcome;
    Primitive mine = mesh;
    generate_tangents(mine, 0);
    EXPECT_EQ(mine.indices.size(), mesh.indices.size());
    EXPECT_EQ(mine.tangents.size(), mine.positions.size());
    for (size_t i = 0; i < expected.size(); ++i) {
        const uint32_t index = mine.indices[i];
        EXPECT_EQ(mine.positions[index], mesh.positions[mesh.indices[i]]);
        EXPECT_EQ(mine.texcoords[0][index], mesh.texcoords[0][mesh.indices[i]]);
        const glm::vec4& tangent = mine.tangents[index];
        EXPECT_NEAR(glm::length(glm::dvec3(tangent)), 1, 1e-5);
        if (!(std::abs(glm::length(glm::dvec3(expected[i])) - 1) < 1e-3)) {
            ++outcome.undefined;
            continue;
        }
        outcome.largest =
            std::max(outcome.largest, glm::distance(glm::dvec3(tangent), glm::dvec3(expected[i])));
        outcome.flipped += tangent.w != -expected[i].w; // glTF's v runs the other way
    }
    fmt::print("  {} corners: largest distance {:.3g}, {} signs differ, {} undefined\n",
               expected.size(), outcome.largest, outcome.flipped, outcome.undefined);
    return outcome;
}

void expect_same(const Primitive& mesh, size_t undefined = 0) {
    const Outcome outcome = compare_with_oracle(mesh);
    // Measured: 0. The bound leaves room for another library's acos, one step of float.
    EXPECT_LE(outcome.largest, 1e-6);
    EXPECT_EQ(outcome.flipped, 0u);
    EXPECT_LE(outcome.undefined, undefined);
}

class TangentsOracle : public testing::Test {
protected:
    void SetUp() override {
        if (!oracle::available("mikktspace"))
            GTEST_SKIP() << oracle::missing("mikktspace");
    }
    Random random{2024};

    glm::vec3 direction() {
        glm::dvec3 v;
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

TEST_F(TangentsOracle, SphereWithSeamAndPoles) {
    expect_same(make_sphere(1.7f, 40, 20));
}

TEST_F(TangentsOracle, HardEdgesAndPlanes) {
    expect_same(make_box({-1, 0, 2}, {3, 5, 4}));
    expect_same(make_ground({10, 7}, 12));
}

TEST_F(TangentsOracle, MirroredCoordinates) {
    Primitive sphere = make_sphere(1, 36, 18);
    for (auto& uv : sphere.texcoords[0])
        uv = {std::abs(4 * uv.x - 2), 3 * uv.y};
    expect_same(sphere);
}

TEST_F(TangentsOracle, SmoothSurfaceWithRandomCoordinates) {
    Primitive sphere = make_sphere(2, 30, 20);
    for (auto& uv : sphere.texcoords[0]) {
        const double u = random.unit();
        uv = {u, random.unit()};
    }
    expect_same(sphere);
}

TEST_F(TangentsOracle, SoupOfSharedVertices) {
    Primitive soup = vertices(300, 1u << 20);
    for (int i = 0; i < 3 * 4000; ++i)
        soup.indices.push_back(random.below(300));
    expect_same(soup, 1); // one corner's angle rounds to 0: the oracle's tangent is the zero vector
}

// Few vertices and coarse coordinates: edges with many triangles, triangles whose coordinates span
// no area, triangles without area, and equal triangles.
TEST_F(TangentsOracle, SoupOfDegenerateTriangles) {
    for (const uint32_t steps : {1u, 2u, 3u, 8u}) {
        Primitive soup = vertices(40, steps);
        for (int i = 0; i < 3 * 1500; ++i)
            soup.indices.push_back(random.below(i % 2 == 0 ? 40 : 12));
        expect_same(soup);
    }
}

// Coordinates that go round twice as fast as the ring: tangents of faces across it are exactly
// opposed, which MikkTSpace keeps apart.
TEST_F(TangentsOracle, RingWithOpposedCoordinates) {
    Primitive ring;
    ring.positions = {{0, 0, 0},  {1, 0, 0},   {1, 1, 0},  {0, 1, 0}, {-1, 1, 0},
                      {-1, 0, 0}, {-1, -1, 0}, {0, -1, 0}, {1, -1, 0}};
    ring.normals.assign(9, {0, 0, 1});
    ring.texcoords[0] = {{0, 0}, {1, 0}, {0, 1},  {-1, 0}, {0, -1},
                         {1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (uint32_t i = 0; i < 8; ++i)
        ring.indices.insert(ring.indices.end(), {0, i + 1, (i + 1) % 8 + 1});
    expect_same(ring);
}

} // namespace
} // namespace prelight
