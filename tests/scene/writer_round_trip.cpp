#include <fstream>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>
#include <scene/oracle.hpp>
#include <scene/writer_scenes.hpp>

// save_glb → load_gltf gives the same scene: bit for bit, but for what the comments name.
namespace prelight {
namespace {

void expect_near(const glm::dmat4& a, const glm::dmat4& b, double bound) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            EXPECT_NEAR(a[column][row], b[column][row], bound) << column << ' ' << row;
}

/// The reader numbers images in the order of their first use.
void expect_same(const TextureRef& a, const Scene& scene_a, const TextureRef& b,
                 const Scene& scene_b) {
    ASSERT_EQ(bool(a), bool(b));
    if (!a)
        return;
    const TextureImage& image_a = scene_a.images.at(a.image);
    const TextureImage& image_b = scene_b.images.at(b.image);
    EXPECT_EQ(image_a.name, image_b.name);
    EXPECT_EQ(image_a.width, image_b.width);
    EXPECT_TRUE(image_a.rgba == image_b.rgba) << image_a.name;
    EXPECT_EQ(a.sampler, b.sampler);
    EXPECT_EQ(a.texcoord, b.texcoord);
    EXPECT_EQ(a.uv_offset, b.uv_offset);
    for (int column = 0; column < 2; ++column) // goes through an angle
        for (int row = 0; row < 2; ++row)
            EXPECT_NEAR(a.uv_linear[column][row], b.uv_linear[column][row], 1e-6);
}

void expect_same(const Material& a, const Scene& scene_a, const Material& b, const Scene& scene_b) {
    SCOPED_TRACE(a.name);
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.base_colour, b.base_colour);
    EXPECT_EQ(a.metallic, b.metallic);
    EXPECT_EQ(a.roughness, b.roughness);
    EXPECT_EQ(a.emissive, b.emissive);
    EXPECT_EQ(a.normal_scale, b.normal_scale);
    EXPECT_EQ(a.occlusion_strength, b.occlusion_strength);
    EXPECT_EQ(a.alpha_mode, b.alpha_mode);
    EXPECT_EQ(a.alpha_cutoff, b.alpha_cutoff);
    EXPECT_EQ(a.double_sided, b.double_sided);
    EXPECT_EQ(a.unlit, b.unlit);
    expect_same(a.base_colour_texture, scene_a, b.base_colour_texture, scene_b);
    expect_same(a.metallic_roughness_texture, scene_a, b.metallic_roughness_texture, scene_b);
    expect_same(a.normal_texture, scene_a, b.normal_texture, scene_b);
    expect_same(a.occlusion_texture, scene_a, b.occlusion_texture, scene_b);
    expect_same(a.emissive_texture, scene_a, b.emissive_texture, scene_b);
}

/// Largest difference of an attribute over all corners; infinite when one of the two lacks it.
template <int N>
float difference(const Primitive& a, const std::vector<glm::vec<N, float>>& of_a,
                 const Primitive& b, const std::vector<glm::vec<N, float>>& of_b) {
    if (of_a.empty() != of_b.empty())
        return std::numeric_limits<float>::infinity();
    float largest = 0;
    for (size_t i = 0; i < a.indices.size() && !of_a.empty(); ++i)
        largest = std::max(largest, glm::distance(of_a.at(a.indices[i]), of_b.at(b.indices.at(i))));
    return largest;
}

/// Corner by corner, since the reader drops vertices that no triangle uses. It also normalises
/// again (one step of float), keeps no tangents without a normal map, and gives zeros for texture
/// coordinates that a material reads and the primitive lacks.
void expect_same(const Primitive& a, const Primitive& b, bool tangents) {
    EXPECT_EQ(a.material, b.material);
    ASSERT_EQ(a.indices.size(), b.indices.size());
    EXPECT_EQ(difference(a, a.positions, b, b.positions), 0);
    EXPECT_EQ(difference(a, a.colours, b, b.colours), 0);
    EXPECT_LE(difference(a, a.normals, b, b.normals), 2e-7f);
    if (tangents) {
        EXPECT_LE(difference(a, a.tangents, b, b.tangents), 2e-7f);
    } else {
        EXPECT_TRUE(b.tangents.empty());
    }
    for (size_t set = 0; set < 2; ++set) {
        if (!a.texcoords[set].empty()) {
            EXPECT_EQ(difference(a, a.texcoords[set], b, b.texcoords[set]), 0);
        }
        for (const glm::vec2& uv : b.texcoords[set])
            if (a.texcoords[set].empty()) {
                ASSERT_EQ(uv, glm::vec2(0));
            }
    }
}

void expect_same(const Light& a, const Light& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.colour * a.intensity, b.colour * b.intensity);
    EXPECT_EQ(a.range, b.range);
    EXPECT_EQ(a.falloff, b.falloff);
    EXPECT_EQ(a.shininess, b.shininess);
    if (a.kind == LightKind::spot) { // equal angles come back as neighbours
        EXPECT_NEAR(a.inner_cone, b.inner_cone, 2e-7);
        EXPECT_NEAR(a.outer_cone, b.outer_cone, 2e-7);
    }
}

void expect_same(const Camera& a, const Camera& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.znear, b.znear);
    EXPECT_EQ(a.zfar, b.zfar);
    if (a.kind == ProjectionKind::perspective) {
        EXPECT_EQ(a.yfov, b.yfov);
    } else {
        EXPECT_EQ(a.ymag, b.ymag);
    }
}

/// Everything but meshes and node.mesh.
void expect_same_frame(const Scene& a, const Scene& b) {
    EXPECT_EQ(a.ambient, b.ambient);
    EXPECT_EQ(a.default_scene, b.default_scene);
    ASSERT_EQ(a.scenes.size(), b.scenes.size());
    for (size_t i = 0; i < a.scenes.size(); ++i) {
        EXPECT_EQ(a.scenes[i].name, b.scenes[i].name);
        EXPECT_EQ(a.scenes[i].nodes, b.scenes[i].nodes);
    }
    ASSERT_EQ(a.lights.size(), b.lights.size());
    for (size_t i = 0; i < a.lights.size(); ++i)
        expect_same(a.lights[i], b.lights[i]);
    ASSERT_EQ(a.cameras.size(), b.cameras.size());
    for (size_t i = 0; i < a.cameras.size(); ++i)
        expect_same(a.cameras[i], b.cameras[i]);
    ASSERT_EQ(a.materials.size(), b.materials.size());
    for (size_t i = 0; i < a.materials.size(); ++i)
        expect_same(a.materials[i], a, b.materials[i], b);
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    for (size_t i = 0; i < a.nodes.size(); ++i) {
        EXPECT_EQ(a.nodes[i].name, b.nodes[i].name);
        EXPECT_EQ(a.nodes[i].children, b.nodes[i].children);
        EXPECT_EQ(a.nodes[i].camera, b.nodes[i].camera);
        EXPECT_EQ(a.nodes[i].light, b.nodes[i].light);
        // A turned node with a scale of zero goes through a quaternion; all others are exact.
        const double bound = a.nodes[i].name == "flat" ? 1e-15 : 0;
        expect_near(a.nodes[i].local, b.nodes[i].local, bound);
        ASSERT_EQ(a.nodes[i].instances.size(), b.nodes[i].instances.size());
        for (size_t k = 0; k < a.nodes[i].instances.size(); ++k) // single precision in the file
            expect_near(a.nodes[i].instances[k], b.nodes[i].instances[k], 1e-6);
    }
}

class RoundTrip : public testing::Test {
protected:
    oracle::TemporaryFolder folder;
    const std::filesystem::path path = folder.path / "scene.glb";

    Scene back(const Scene& scene) {
        save_glb(scene, path);
        return load_gltf(path);
    }
    std::string patched(const std::string& from, const std::string& to) {
        save_glb(scene_with_everything(), path);
        std::ifstream in(path, std::ios::binary);
        std::string bytes{std::istreambuf_iterator<char>(in), {}};
        EXPECT_EQ(from.size(), to.size());
        bytes.replace(bytes.find(from), from.size(), to);
        std::ofstream(path, std::ios::binary) << bytes;
        try {
            load_gltf(path);
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    }
};

TEST_F(RoundTrip, SceneWithEverything) {
    const Scene a = scene_with_everything();
    const Scene b = back(a);
    expect_same_frame(a, b);
    // The mesh and the primitive without triangles are gone.
    ASSERT_EQ(b.meshes.size(), 2u);
    ASSERT_EQ(b.meshes[0].primitives.size(), 3u);
    expect_same(a.meshes[1].primitives[0], b.meshes[0].primitives[0], true);
    expect_same(a.meshes[1].primitives[2], b.meshes[0].primitives[1], false);
    expect_same(a.meshes[1].primitives[3], b.meshes[0].primitives[2], false);
    expect_same(a.meshes[2].primitives[0], b.meshes[1].primitives[0], false);
    EXPECT_FALSE(
        b.nodes[a.scenes[1].nodes[8]].mesh); // "nothing": three cameras, five lights before
}

TEST_F(RoundTrip, SecondFileIsTheFirst) {
    const Scene first = back(scene_with_everything());
    const Scene second = back(first);
    expect_same_frame(first, second);
    for (size_t mesh = 0; mesh < 2; ++mesh)
        for (size_t i = 0; i < first.meshes[mesh].primitives.size(); ++i)
            expect_same(first.meshes[mesh].primitives[i], second.meshes[mesh].primitives[i], true);
}

TEST_F(RoundTrip, BuiltinScenes) {
    for (const BuiltinScene& builtin : builtin_scenes()) {
        SCOPED_TRACE(builtin.name);
        const Scene a = make_scene(builtin.name, 100, 3);
        const Scene b = back(a);
        expect_same_frame(a, b);
        EXPECT_TRUE(b.warnings.empty());
        ASSERT_EQ(a.meshes.size(), b.meshes.size());
        for (size_t i = 0; i < a.meshes.size(); ++i) {
            ASSERT_EQ(a.meshes[i].primitives.size(), b.meshes[i].primitives.size());
            for (size_t k = 0; k < a.meshes[i].primitives.size(); ++k)
                expect_same(a.meshes[i].primitives[k], b.meshes[i].primitives[k], true);
        }
        EXPECT_EQ(resolve(a).triangles, resolve(b).triangles);
    }
}

TEST_F(RoundTrip, WrongExtrasOfOurOwnAreErrors) {
    EXPECT_NE(patched("\"falloff\":\"linear\"", "\"falloff\":\"lineal\"").find("lineal"),
              std::string::npos);
    EXPECT_NE(patched("\"shininess\":2.5", "\"shininess\":-25").find("shininess is not"),
              std::string::npos);
    EXPECT_NE(patched("\"ambient\":[0.1", "\"ambient\":[-11").find("ambient is negative"),
              std::string::npos);
    EXPECT_NE(patched("\"shininess\":2.5", "\"shininess\":0.0").find("shininess is not"),
              std::string::npos);
    EXPECT_EQ(patched("\"prelight\":{\"ambient\"", "\"prelude!\":{\"ambient\""), "no error");
}

// Real files, when they are there: what was read, written and read again is the same.
TEST_F(RoundTrip, SharedScenes) {
    const std::filesystem::path shared = PRELIGHT_SHARED_SCENES;
    if (!std::filesystem::exists(shared))
        GTEST_SKIP() << "the shared scenes are not there";
    for (const char* name :
         {"TextureTransformMultiTest.glb", "TextureSettingsTest.glb", "Cameras.glb",
          "LightsPunctualLamp.glb", "gdx-spotLightTest.glb", "MultiUVTest.glb",
          "NegativeScaleTest.glb", "EmissiveStrengthTest.glb"}) {
        SCOPED_TRACE(name);
        const Scene first = load_gltf(shared / name);
        const Scene second = back(first);
        expect_same_frame(first, second);
        EXPECT_EQ(resolve(first).triangles, resolve(second).triangles);
        if (oracle::available("gltf-validator")) {
            EXPECT_TRUE(oracle::run("validate.js", fmt::format("'{}'", path.string())));
        }
    }
}

} // namespace
} // namespace prelight
