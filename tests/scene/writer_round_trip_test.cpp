#include <fstream>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>
#include <scene/oracle.hpp>
#include <scene/tangents.hpp>
#include <scene/writer_scenes.hpp>

// save_glb → load_gltf gives the same scene: bit for bit, but for what the comments name.
namespace prelight {
namespace {

void expect_matrix_near(const glm::dmat4& a, const glm::dmat4& b, double bound) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            EXPECT_NEAR(a[column][row], b[column][row], bound) << column << ' ' << row;
}

/// The reader numbers images in the order of their first use.
void expect_same(const TextureRef& a, const Scene& scene_a, const TextureRef& b, const Scene& scene_b) {
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
float difference(const Primitive& a, const std::vector<glm::vec<N, float>>& of_a, const Primitive& b,
                 const std::vector<glm::vec<N, float>>& of_b) {
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
    EXPECT_EQ(a.casts_shadow, b.casts_shadow);
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

void expect_same(const std::optional<Trs>& a, const std::optional<Trs>& b) {
    // What has no parts in memory may be written in parts.
    if (!a)
        return;
    ASSERT_TRUE(b);
    EXPECT_EQ(a->translation, b->translation);
    EXPECT_EQ(a->rotation, b->rotation);
    EXPECT_EQ(a->scale, b->scale);
}

void expect_same_motion(const Scene& a, const Scene& b) {
    ASSERT_EQ(a.skins.size(), b.skins.size());
    for (size_t i = 0; i < a.skins.size(); ++i) {
        EXPECT_EQ(a.skins[i].name, b.skins[i].name);
        EXPECT_EQ(a.skins[i].joints, b.skins[i].joints);
        ASSERT_EQ(a.skins[i].inverse_bind.size(), b.skins[i].inverse_bind.size());
        for (size_t k = 0; k < a.skins[i].inverse_bind.size(); ++k) // single precision in the file
            expect_matrix_near(a.skins[i].inverse_bind[k], b.skins[i].inverse_bind[k], 1e-6);
    }
    ASSERT_EQ(a.animations.size(), b.animations.size());
    for (size_t i = 0; i < a.animations.size(); ++i) {
        EXPECT_EQ(a.animations[i].name, b.animations[i].name);
        ASSERT_EQ(a.animations[i].channels.size(), b.animations[i].channels.size());
        for (size_t k = 0; k < a.animations[i].channels.size(); ++k) {
            const AnimationChannel &c = a.animations[i].channels[k], &d = b.animations[i].channels[k];
            EXPECT_EQ(c.node, d.node);
            EXPECT_EQ(c.path, d.path);
            const AnimationSampler& s = a.animations[i].samplers[c.sampler];
            const AnimationSampler& t = b.animations[i].samplers[d.sampler];
            EXPECT_EQ(s.times, t.times);
            EXPECT_EQ(s.values, t.values);
            EXPECT_EQ(s.interpolation, t.interpolation);
        }
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
        EXPECT_EQ(a.nodes[i].skin, b.nodes[i].skin);
        EXPECT_EQ(a.nodes[i].weights, b.nodes[i].weights);
        expect_same(a.nodes[i].trs, b.nodes[i].trs);
        // A turned node with a scale of zero goes through a quaternion; all others are exact.
        const double bound = a.nodes[i].name == "flat" ? 1e-15 : 0;
        expect_matrix_near(a.nodes[i].local, b.nodes[i].local, bound);
        ASSERT_EQ(a.nodes[i].instances.size(), b.nodes[i].instances.size());
        for (size_t k = 0; k < a.nodes[i].instances.size(); ++k) // single precision in the file
            expect_matrix_near(a.nodes[i].instances[k], b.nodes[i].instances[k], 1e-6);
    }
    expect_same_motion(a, b);
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
        std::string warnings;
        for (const std::string& warning : load_gltf(path).warnings)
            warnings += warning + "\n";
        return warnings;
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
    EXPECT_FALSE(b.nodes[a.scenes[1].nodes[8]].mesh); // "nothing": three cameras, five lights before
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
        EXPECT_EQ(a.decals.size(), b.decals.size());
        EXPECT_EQ(a.emitters.size(), b.emitters.size());
        ASSERT_EQ(a.meshes.size(), b.meshes.size());
        for (size_t i = 0; i < a.meshes.size(); ++i) {
            ASSERT_EQ(a.meshes[i].primitives.size(), b.meshes[i].primitives.size());
            EXPECT_EQ(a.meshes[i].weights, b.meshes[i].weights);
            for (size_t k = 0; k < a.meshes[i].primitives.size(); ++k) {
                const Primitive &in = a.meshes[i].primitives[k], &out = b.meshes[i].primitives[k];
                // `multipass` has tangents for materials to come.
                const bool kept = bool(a.materials[in.material].normal_texture);
                expect_same(in, out, kept || in.tangents.empty() == out.tangents.empty());
            }
        }
        EXPECT_EQ(resolve(a).triangles, resolve(b).triangles);
    }
}

// Two sets of joints, a target that moves nothing, normals of the triangles, a quaternion that is not
// quite one, and one sampler for two kinds of channels.
TEST_F(RoundTrip, WhatTheBuiltinScenesDoNotMove) {
    Scene a = make_scene("motion", 1, 1);
    const uint32_t column = static_cast<uint32_t>(a.meshes.size());
    for (const Node& node : make_scene("motion", 1, 1).nodes)
        if (node.skin) {
            a.meshes.push_back(a.meshes[*node.mesh]);
            a.nodes.push_back(node);
        }
    ASSERT_EQ(a.meshes.size(), column + 1);
    a.scenes[0].nodes.push_back(static_cast<uint32_t>(a.nodes.size()) - 1);
    a.nodes.back().mesh = column;
    a.nodes.back().weights = {0.25f};
    a.nodes.back().trs->rotation = {1, 0, 0, 1e-4};
    a.nodes.back().local = a.nodes.back().trs->matrix();
    Primitive& primitive = a.meshes[column].primitives[0];
    JointSet more = primitive.joint_sets[0]; // half of each vertex's weight to a joint far from its own
    for (size_t v = 0; v < more.joints.size(); ++v) {
        more.joints[v] = {(primitive.joint_sets[0].joints[v].x + 3) % 5, 0, 0, 0};
        more.weights[v] = {0.5f, 0, 0, 0};
        primitive.joint_sets[0].weights[v] *= 0.5f;
    }
    primitive.joint_sets.push_back(more);
    primitive.morph_targets.resize(1);
    make_flat_normals(primitive);
    Animation& animation = a.animations.emplace_back(Animation{.name = "two"});
    const auto node = static_cast<uint32_t>(a.nodes.size()) - 1;
    animation.samplers = {{{0, 1}, {1, 1, 1, 2, 2, 2}, Interpolation::linear}};
    animation.channels = {{0, node, AnimationPath::translation}, {0, node, AnimationPath::scale}};
    const Scene b = back(a);
    expect_same_frame(a, b);
    const Primitive& read = b.meshes[column].primitives[0];
    EXPECT_TRUE(read.flat_normals);
    EXPECT_EQ(read.normals, primitive.normals);
    EXPECT_EQ(read.joint_sets.size(), 2u);
    ASSERT_EQ(read.morph_targets.size(), 1u);
    EXPECT_EQ(read.morph_targets[0].positions, std::vector<glm::vec3>(read.positions.size()));
    if (oracle::available("gltf-validator")) {
        EXPECT_TRUE(oracle::run("validate.js", fmt::format("'{}'", path.string())));
    }
    const World first = resolve(a, {}, Moment{1.3}), second = resolve(b, {}, Moment{1.3});
    ASSERT_EQ(first.deformed.size(), second.deformed.size());
    for (size_t i = 0; i < first.deformed.size(); ++i)
        for (size_t v = 0; v < first.deformed[i].primitives[0].positions.size(); ++v)
            ASSERT_LT(glm::distance(first.deformed[i].primitives[0].positions[v],
                                    second.deformed[i].primitives[0].positions[v]),
                      1e-5f);
}

TEST_F(RoundTrip, WrongExtrasOfOurOwnAreWarnings) {
    EXPECT_NE(patched("\"falloff\":\"linear\"", "\"falloff\":\"lineal\"").find("lineal"), std::string::npos);
    EXPECT_NE(patched("\"shininess\":2.5", "\"shininess\":-25").find("shininess "), std::string::npos);
    EXPECT_NE(patched("\"ambient\":[0.1", "\"ambient\":[-11").find("ambient holds -11"), std::string::npos);
    EXPECT_NE(patched("\"shininess\":2.5", "\"shininess\":0.0").find("shininess "), std::string::npos);
    EXPECT_NE(patched("\"castsShadow\":false", "\"castsShadow\":12345").find("castsShadow"), std::string::npos);
    EXPECT_EQ(patched("\"prelight\":{\"ambient\"", "\"prelude!\":{\"ambient\"").find("ambient"), std::string::npos);
}

// Real files, when they are there: what was read, written and read again is the same.
TEST_F(RoundTrip, SharedScenes) {
    const std::filesystem::path shared = PRELIGHT_SHARED_SCENES;
    if (!std::filesystem::exists(shared))
        GTEST_SKIP() << "the shared scenes are not there";
    for (const char* name :
         {"TextureTransformMultiTest.glb", "TextureSettingsTest.glb", "Cameras.glb", "LightsPunctualLamp.glb",
          "gdx-spotLightTest.glb", "MultiUVTest.glb", "NegativeScaleTest.glb", "EmissiveStrengthTest.glb",
          "CesiumMan.glb", "MorphStressTest.glb", "gdx-lightCameraAnimations.glb"}) {
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
