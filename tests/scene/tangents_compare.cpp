#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <scene/oracle.hpp>
#include <scene/tangents.hpp>
#include <scene/tangents_compare.hpp>

namespace prelight {
namespace {

std::vector<glm::vec4> ask_oracle(const Primitive& mesh) {
    const oracle::TemporaryFolder folder;
    const auto in = folder.path / "corners", out = folder.path / "tangents";
    std::ofstream file(in, std::ios::binary);
    const auto put = [&](float x) { file.write(reinterpret_cast<const char*>(&x), sizeof x); };
    for (const uint32_t i : mesh.indices) {
        const auto &p = mesh.positions[i], &n = mesh.normals[i];
        for (const float x : {p.x, p.y, p.z, n.x, n.y, n.z, mesh.texcoords[0][i].x, mesh.texcoords[0][i].y})
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
        outcome.largest = std::max(outcome.largest, glm::distance(glm::dvec3(tangent), glm::dvec3(expected[i])));
        outcome.flipped += tangent.w != -expected[i].w; // glTF's v runs the other way
    }
    fmt::print("  {} corners: largest distance {:.3g}, {} signs differ, {} undefined\n", expected.size(),
               outcome.largest, outcome.flipped, outcome.undefined);
    return outcome;
}

} // namespace

void expect_oracle_tangents(const Primitive& mesh, size_t undefined) {
    const Outcome outcome = compare_with_oracle(mesh);
    // Measured: 0. The bound leaves room for another library's acos, one step of float.
    EXPECT_LE(outcome.largest, 1e-6);
    EXPECT_EQ(outcome.flipped, 0u);
    EXPECT_LE(outcome.undefined, undefined);
}

} // namespace prelight
