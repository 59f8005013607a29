#include <gtest/gtest.h>
#include <prelight/scene_io.hpp>
#include <scene/oracle.hpp>
#include <scene/tangents_compare.hpp>

namespace prelight {
namespace {

// A real building, when it is there: every primitive with a normal map.
TEST(TangentsSharedScenes, Sponza) {
    const auto path = std::filesystem::path(PRELIGHT_SHARED_SCENES) / "sponza-512.glb";
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << "the shared scenes are not there";
    if (!oracle::available("mikktspace"))
        GTEST_SKIP() << oracle::missing("mikktspace");
    Primitive all; // one mesh, so that the oracle starts once
    const Scene scene = load_gltf(path);
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& primitive : mesh.primitives) {
            if (primitive.tangents.empty())
                continue;
            const auto first = static_cast<uint32_t>(all.positions.size());
            const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
            append(all.positions, primitive.positions);
            append(all.normals, primitive.normals);
            append(all.texcoords[0], primitive.texcoords[0]);
            for (const uint32_t index : primitive.indices)
                all.indices.push_back(first + index);
        }
    EXPECT_GT(all.indices.size(), 100000u);
    expect_oracle_tangents(all);
}

} // namespace
} // namespace prelight
