#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>

using namespace prelight;

namespace {
namespace fs = std::filesystem;

/// The real scenes: beside the repository, or where the environment says.
fs::path shared_scenes() {
    const char* given = std::getenv("PRELIGHT_SHARED_SCENES");
    return given ? fs::path(given) : fs::path(PRELIGHT_SHARED_SCENES);
}

bool is_scene(const fs::path& path) { return path.extension() == ".glb" || path.extension() == ".gltf"; }

/// What every renderer relies on.
void check_sound(const Scene& scene) {
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& p : mesh.primitives) {
            ASSERT_LT(p.material, scene.materials.size());
            const size_t count = p.positions.size();
            ASSERT_EQ(p.indices.size() % 3, 0u);
            for (const uint32_t index : p.indices)
                ASSERT_LT(index, count);
            ASSERT_EQ(p.normals.size(), count);
            for (const glm::vec3& n : p.normals)
                ASSERT_NEAR(std::sqrt(double(n.x) * n.x + double(n.y) * n.y + double(n.z) * n.z), 1, 1e-5);
            const Material& m = scene.materials[p.material];
            const bool mapped = m.normal_texture || (m.shader && !p.texcoords[0].empty());
            ASSERT_EQ(p.tangents.size(), mapped ? count : 0);
            for (const glm::vec4& t : p.tangents)
                ASSERT_TRUE(std::abs(t.w) == 1);
            for (const auto& set : p.texcoords)
                ASSERT_TRUE(set.empty() || set.size() == count);
            ASSERT_TRUE(p.colours.empty() || p.colours.size() == count);
            for (const JointSet& set : p.joint_sets)
                ASSERT_TRUE(set.joints.size() == count && set.weights.size() == count);
            for (const MorphTarget& target : p.morph_targets)
                for (const auto* list : {&target.positions, &target.normals, &target.tangents})
                    ASSERT_TRUE(list->empty() || list->size() == count);
            for (const TextureRef* ref : {&m.base_colour_texture, &m.metallic_roughness_texture, &m.normal_texture,
                                          &m.occlusion_texture, &m.emissive_texture}) {
                if (!*ref)
                    continue;
                ASSERT_LT(ref->image, scene.images.size());
                ASSERT_EQ(p.texcoords[ref->texcoord].size(), count);
            }
        }
    for (const TextureImage& image : scene.images)
        ASSERT_EQ(image.rgba.size(), size_t(image.width) * image.height * 4);
}

TEST(GltfShared, EveryRealSceneLoads) {
    if (!fs::exists(shared_scenes()))
        GTEST_SKIP() << "no shared scenes here";
    size_t count = 0;
    for (const auto& entry : fs::directory_iterator(shared_scenes())) {
        if (!is_scene(entry.path()))
            continue;
        SCOPED_TRACE(entry.path().filename());
        ASSERT_NO_THROW({
            const Scene scene = load_gltf(entry.path());
            check_sound(scene);
            EXPECT_GT(resolve(scene).triangles, 0u);
            EXPECT_EQ(resolve(scene, {}, Moment{0.4}).triangles, resolve(scene).triangles);
        });
        ++count;
    }
    EXPECT_GT(count, 10u);
}

// Bounds of a walking fox and man as they stand up, not as their meshes are stored.
TEST(GltfShared, SkinnedModelsAreWhereTheirJointsAre) {
    if (!fs::exists(shared_scenes()))
        GTEST_SKIP() << "no shared scenes here";
    const Scene man = load_gltf(shared_scenes() / "CesiumMan.glb");
    const World world = resolve(man, {}, Moment{0.5});
    ASSERT_EQ(world.deformed.size(), 1u);
    const glm::dvec3 size = world.bounds_max - world.bounds_min;
    EXPECT_NEAR(size.y, 1.5, 0.1) << "he stands along y";
    EXPECT_NEAR(world.bounds_min.y, 0, 0.1) << "on the ground";
    EXPECT_FALSE(world.deformed[0].primitives[0].previous_positions.empty());
    const Scene fox = load_gltf(shared_scenes() / "Fox.glb");
    EXPECT_EQ(fox.animations.size(), 3u);
    EXPECT_EQ(find_animation(fox, "Run"), 2u);
    const World walk = resolve(fox, {}, Moment{0.3}, find_animation(fox, "Walk"));
    const World run = resolve(fox, {}, Moment{0.3}, find_animation(fox, "Run"));
    EXPECT_NE(walk.bounds_max, run.bounds_max);
}

TEST(GltfShared, DracoAndPlainSponzaAgree) {
    if (!fs::exists(shared_scenes()))
        GTEST_SKIP() << "no shared scenes here";
    const Scene plain = load_gltf(shared_scenes() / "sponza-512.glb");
    const Scene packed = load_gltf(shared_scenes() / "sponza-draco-webp.glb");
    const World a = resolve(plain), b = resolve(packed);
    EXPECT_EQ(a.triangles, 262'267u);
    EXPECT_EQ(b.triangles, a.triangles);
    EXPECT_EQ(packed.images.size(), plain.images.size());
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(a.bounds_min[i], b.bounds_min[i], 0.01);
        EXPECT_NEAR(a.bounds_max[i], b.bounds_max[i], 0.01);
    }
    ASSERT_EQ(packed.materials.size(), plain.materials.size());
    for (size_t i = 0; i < plain.materials.size(); ++i)
        EXPECT_EQ(packed.materials[i].alpha_mode, plain.materials[i].alpha_mode);
}

TEST(GltfShared, EveryDamagedFileEndsInASceneOrOneLine) {
    const fs::path folder = shared_scenes() / "damaged";
    if (!fs::exists(folder))
        GTEST_SKIP() << "no shared scenes here";
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file())
            continue;
        SCOPED_TRACE(entry.path());
        const auto start = std::chrono::steady_clock::now();
        try {
            const Scene scene = load_gltf(entry.path());
            check_sound(scene);
            resolve(scene);
            resolve(scene, {}, Moment{1});
        } catch (const Error& error) {
            const std::string line = error.what();
            EXPECT_EQ(line.rfind(entry.path().string() + ": ", 0), 0u);
            EXPECT_EQ(line.find('\n'), std::string::npos);
        }
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
    }
}

} // namespace
