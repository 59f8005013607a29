// Which surfaces inferred lighting tells apart, and which layers share its texels.
#include "random_scene.hpp"
#include <resident/smooth_groups.hpp>
#include <set>

namespace prelight {
namespace {

size_t groups_in(const Primitive& primitive) {
    const std::vector<uint32_t> groups = resident::smooth_groups(primitive);
    EXPECT_EQ(groups.size(), primitive.positions.size());
    for (size_t i = 0; i + 2 < primitive.indices.size(); i += 3)
        for (size_t k = 1; k < 3; ++k)
            EXPECT_EQ(groups[primitive.indices[i]], groups[primitive.indices[i + k]]);
    return std::set<uint32_t>(groups.begin(), groups.end()).size();
}

TEST(SmoothGroups, ABoxHasSixAndABallOne) {
    EXPECT_EQ(groups_in(cube()), 6u);
    EXPECT_EQ(groups_in(sphere(16)), 1u);
    EXPECT_EQ(groups_in(square(1)), 1u);
}

TEST(SmoothGroups, TrianglesThatShareNoVertexAreJoinedByPlaceAndNormal) {
    const Primitive whole = sphere(16);
    Primitive soup;
    for (const uint32_t index : whole.indices) {
        soup.indices.push_back(static_cast<uint32_t>(soup.positions.size()));
        soup.positions.push_back(whole.positions[index]);
        soup.normals.push_back(whole.normals[index]);
    }
    EXPECT_EQ(groups_in(soup), 1u);
    for (glm::vec3& normal : soup.normals) // as flat as can be
        normal = glm::vec3(static_cast<float>((&normal - soup.normals.data()) / 3), 0, 0);
    EXPECT_EQ(groups_in(soup), soup.indices.size() / 3);
}

} // namespace
} // namespace prelight
