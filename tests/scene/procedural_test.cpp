#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>
#include <scene/procedural/random.hpp>
#include <scene/procedural/shapes.hpp>

namespace prelight {
namespace {

/// FNV-1a over everything that a seed decides.
class Hash {
public:
    template <typename T>
    void add(const T& value) {
        std::array<unsigned char, sizeof(T)> bytes;
        std::memcpy(bytes.data(), &value, sizeof(T));
        for (const unsigned char byte : bytes)
            sum = (sum ^ byte) * 0x100000001b3u;
    }
    template <typename T>
    void add_all(const std::vector<T>& values) {
        for (const T& value : values)
            add(value);
    }
    uint64_t sum = 0xcbf29ce484222325u;
};

uint64_t hash(const Scene& scene) {
    Hash hash;
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& primitive : mesh.primitives) {
            hash.add_all(primitive.positions);
            hash.add_all(primitive.normals);
            hash.add_all(primitive.texcoords[0]);
            hash.add_all(primitive.indices);
            hash.add(primitive.material);
        }
    for (const Node& node : scene.nodes) {
        hash.add(node.local);
        hash.add(node.mesh.value_or(no_image));
        hash.add(node.light.value_or(no_image));
    }
    for (const Light& light : scene.lights) {
        hash.add(light.colour);
        hash.add(light.intensity);
        hash.add(light.range);
    }
    for (const Material& material : scene.materials) {
        hash.add(material.base_colour);
        hash.add(material.roughness);
        hash.add(material.metallic);
    }
    return hash.sum;
}

struct Counts {
    uint64_t triangles = 0, objects = 0, lights = 0;
    std::vector<glm::dvec3> light_positions;
};

Counts count(const Scene& scene) {
    Counts counts;
    for (const Node& node : scene.nodes) {
        if (node.mesh) {
            ++counts.objects;
            for (const Primitive& primitive : scene.meshes.at(*node.mesh).primitives)
                counts.triangles += primitive.indices.size() / 3;
        }
        if (node.emitter && scene.emitters.at(*node.emitter).lights)
            counts.lights += scene.emitters.at(*node.emitter).count;
        if (node.light) {
            ++counts.lights;
            counts.light_positions.emplace_back(node.local[3]);
        }
    }
    return counts;
}

/// `centre`: a point inside a convex mesh; every face with area looks away from it.
void expect_outward(const Primitive& primitive, const glm::vec3& centre) {
    for (size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        const auto at = [&](size_t corner) {
            return glm::dvec3(primitive.positions.at(primitive.indices.at(i + corner)));
        };
        const glm::dvec3 face = glm::cross(at(1) - at(0), at(2) - at(0));
        if (glm::length(face) < 1e-9)
            continue;
        ASSERT_GT(glm::dot(face, at(0) - glm::dvec3(centre)), 0) << "triangle " << i / 3;
        for (size_t corner = 0; corner < 3; ++corner)
            ASSERT_GT(glm::dot(glm::normalize(face), glm::dvec3(primitive.normals.at(primitive.indices[i + corner]))),
                      0.9);
    }
}

void expect_unit_normals(const Primitive& primitive) {
    ASSERT_EQ(primitive.normals.size(), primitive.positions.size());
    for (const glm::vec3& normal : primitive.normals)
        ASSERT_NEAR(glm::length(glm::dvec3(normal)), 1, 1e-6);
}

TEST(Procedural, LightsIsTheBaseline) {
    const Scene scene = make_scene("lights", 1024, 7);
    const Counts counts = count(scene);
    EXPECT_EQ(counts.triangles, 250284u);
    EXPECT_EQ(counts.objects, 266u);
    EXPECT_EQ(counts.lights, 1024u);
    EXPECT_EQ(scene.materials.size(), 3u);
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.cameras[0].yfov, 0.87);
    glm::dvec3 low(1e9), high(-1e9);
    for (const glm::dvec3& p : counts.light_positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    // Inside the stated box, and filling it.
    EXPECT_TRUE(low.x > -47 && low.x < -46 && high.x < 47 && high.x > 46);
    EXPECT_TRUE(low.z > -47 && low.z < -46 && high.z < 47 && high.z > 46);
    EXPECT_TRUE(low.y > 0.4 && low.y < 0.45 && high.y < 3.5 && high.y > 3.45);
    for (const Light& light : scene.lights) {
        ASSERT_EQ(light.range, 5);
        ASSERT_EQ(light.intensity, 12);
        ASSERT_EQ(std::max({light.colour.r, light.colour.g, light.colour.b}), 1);
    }
}

TEST(Procedural, LightsCameraLooksAtTheOrigin) {
    const Scene scene = make_scene("lights", 1, 1);
    for (const Node& node : scene.nodes)
        if (node.camera) {
            EXPECT_EQ(glm::dvec3(node.local[3]), glm::dvec3(0, 14, 48));
            const glm::dvec3 forward = -glm::dvec3(node.local[2]);
            EXPECT_NEAR(glm::dot(forward, glm::normalize(glm::dvec3(0, -14, -48))), 1, 1e-12);
        }
}

TEST(Procedural, SpheresCoverTheGrid) {
    const Scene scene = make_scene("spheres", 8, 1);
    EXPECT_EQ(count(scene).objects, 41u);
    EXPECT_EQ(count(scene).lights, 8u);
    float low = 1, high = 0;
    for (size_t i = 1; i < scene.materials.size(); ++i) {
        low = std::min(low, scene.materials[i].roughness);
        high = std::max(high, scene.materials[i].roughness);
    }
    EXPECT_FLOAT_EQ(low, 0.1f);
    EXPECT_FLOAT_EQ(high, 1);
}

class EveryScene : public testing::TestWithParam<std::string_view> {};

TEST_P(EveryScene, IsDeterministicAndObeysItsSeed) {
    const uint64_t first = hash(make_scene(GetParam(), 100, 5));
    EXPECT_EQ(first, hash(make_scene(GetParam(), 100, 5)));
    EXPECT_NE(first, hash(make_scene(GetParam(), 100, 6)));
}

TEST_P(EveryScene, TakesLightCountsInRangeOnly) {
    EXPECT_EQ(count(make_scene(GetParam(), 1, 1)).lights, 1u);
    EXPECT_EQ(count(make_scene(GetParam(), 65536, 1)).lights, 65536u);
    EXPECT_THROW(make_scene(GetParam(), 0, 1), UsageError);
    EXPECT_THROW(make_scene(GetParam(), 65537, 1), UsageError);
}

TEST_P(EveryScene, HasSoundMeshes) {
    const Scene scene = make_scene(GetParam(), 10, 1);
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& primitive : mesh.primitives) {
            expect_unit_normals(primitive);
            ASSERT_LT(primitive.material, scene.materials.size());
            for (const uint32_t index : primitive.indices)
                ASSERT_LT(index, primitive.positions.size());
        }
}

std::vector<std::string_view> names() {
    std::vector<std::string_view> list;
    for (const BuiltinScene& scene : builtin_scenes())
        list.push_back(scene.name);
    return list;
}
INSTANTIATE_TEST_SUITE_P(Procedural, EveryScene, testing::ValuesIn(names()), [](const auto& each) {
    std::string name(each.param);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(Procedural, UnknownNameIsAUsageErrorThatListsNames) {
    try {
        make_scene("nosuch", 1, 1);
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_NE(std::string(error.what()).find("lights"), std::string::npos);
    }
}

// The bytes that a seed stands for, everywhere: a change here changes every published figure.
TEST(Procedural, SeedsKeepTheirMeaning) {
    Random random(1);
    EXPECT_EQ(random.bits(), 0x910a2dec89025cc1u);
    EXPECT_EQ(random.bits(), 0xbeeb8da1658eec67u);
    for (int i = 0; i < 1000; ++i) {
        ASSERT_LT(random.below(7), 7u);
        const double x = random.uniform(-2, 3);
        ASSERT_TRUE(x >= -2 && x <= 3);
    }
}

TEST(Procedural, HuesGoRound) {
    EXPECT_EQ(hue_colour(0, 1), glm::vec3(1, 0, 0));
    EXPECT_EQ(hue_colour(1.0 / 6, 1), glm::vec3(1, 1, 0));
    EXPECT_NEAR(glm::distance(hue_colour(1.0 / 3, 1), glm::vec3(0, 1, 0)), 0, 1e-6);
    EXPECT_NEAR(glm::distance(hue_colour(2.0 / 3, 1), glm::vec3(0, 0, 1)), 0, 1e-6);
    EXPECT_EQ(hue_colour(0.4, 0), glm::vec3(1));
}

TEST(Procedural, ShapesFaceOutward) {
    const Primitive sphere = make_sphere(2, 40, 20);
    EXPECT_EQ(sphere.indices.size(), 3u * 1600);
    expect_unit_normals(sphere);
    expect_outward(sphere, glm::vec3(0));
    for (const glm::vec3& p : sphere.positions)
        ASSERT_NEAR(glm::length(p), 2, 1e-6);

    const Primitive box = make_box({1, 2, 3}, {2, 4, 6});
    EXPECT_EQ(box.indices.size(), 36u);
    expect_unit_normals(box);
    expect_outward(box, {1.5f, 3, 4.5f});

    const Primitive ground = make_ground({10, 20}, 4);
    EXPECT_EQ(ground.indices.size(), 96u);
    EXPECT_EQ(ground.positions.front(), glm::vec3(-5, 0, -10));
    EXPECT_EQ(ground.positions.back(), glm::vec3(5, 0, 10));
    expect_outward(ground, {0, -1, 0});

    const std::vector<glm::dvec2> roof_and_wall{{0, 3}, {1, 2}, {1, 1}, {0.9, 0}, {0, 0}};
    const Primitive turned = make_turned(roof_and_wall, 40);
    EXPECT_EQ(turned.indices.size(), 3u * 2 * 40 * 4);
    expect_unit_normals(turned);
    expect_outward(turned, {0, 1, 0});
    // The wall bends smoothly, the roof's edge is one.
    for (size_t i = 0; i < turned.positions.size(); ++i)
        if (turned.positions[i].y == 1) {
            EXPECT_NEAR(turned.normals[i].y, -0.0499, 1e-3);
        } else if (turned.positions[i].y == 2) {
            EXPECT_TRUE(turned.normals[i].y == 0 || turned.normals[i].y > 0.7f);
        }
}

} // namespace
} // namespace prelight
