#include "coplanar.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <gtest/gtest.h>
#include <scene/procedural/city.hpp>
#include <set>
#include <string>

namespace prelight {
namespace {

/// The objects do not depend on the number of lights: one city serves most tests.
const Scene& city() {
    static const Scene scene = make_city(256, 1);
    return scene;
}

/// FNV-1a (Fowler, Noll, Vo) over the bytes of plain data.
class Digest {
public:
    template <typename T>
    void add(const std::vector<T>& list) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(list.data());
        for (size_t i = 0; i < list.size() * sizeof(T); ++i)
            value = (value ^ bytes[i]) * 0x100000001b3u;
    }
    uint64_t value = 0xcbf29ce484222325u;
};

uint64_t digest(const Scene& scene) {
    Digest d;
    for (const TextureImage& image : scene.images)
        d.add(image.rgba);
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& p : mesh.primitives) {
            d.add(p.positions);
            d.add(p.normals);
            d.add(p.tangents);
            d.add(p.texcoords[0]);
            d.add(p.colours);
            d.add(p.indices);
        }
    for (const Node& node : scene.nodes)
        d.add(std::vector{node.local});
    for (const Light& light : scene.lights)
        d.add(std::vector{light.colour.r, light.colour.g, light.colour.b, light.intensity, light.range,
                          light.inner_cone, light.outer_cone});
    return d.value;
}

template <typename Check>
void for_each_primitive(const Scene& scene, Check check) {
    for (const Mesh& mesh : scene.meshes)
        for (size_t i = 0; i < mesh.primitives.size(); ++i) {
            SCOPED_TRACE(mesh.name + " primitive " + std::to_string(i));
            check(mesh.primitives[i]);
        }
}

template <typename V>
bool all_finite(const std::vector<V>& list) {
    return std::all_of(list.begin(), list.end(), [](const V& v) {
        for (int i = 0; i < v.length(); ++i)
            if (!std::isfinite(v[i]))
                return false;
        return true;
    });
}

struct Ref {
    const char* what;
    const TextureRef& ref;
};
std::vector<Ref> textures(const Material& m) {
    std::vector<Ref> used;
    for (const Ref& r :
         {Ref{"base colour", m.base_colour_texture}, Ref{"metallic-roughness", m.metallic_roughness_texture},
          Ref{"normal", m.normal_texture}, Ref{"occlusion", m.occlusion_texture}, Ref{"emissive", m.emissive_texture}})
        if (r.ref)
            used.push_back(r);
    return used;
}

class CityLights : public testing::TestWithParam<uint32_t> {};

TEST_P(CityLights, AreExactlyAsMany) {
    const Scene scene = make_city(GetParam(), 1);
    EXPECT_EQ(scene.lights.size(), GetParam());
    std::vector<uint32_t> used(scene.lights.size());
    for (const uint32_t root : scene.scenes.at(0).nodes)
        if (const auto light = scene.nodes.at(root).light)
            ++used.at(*light);
    EXPECT_EQ(std::count(used.begin(), used.end(), 1u), std::ptrdiff_t(GetParam())) << "each light hangs on one node";
    for (const Light& light : scene.lights) {
        ASSERT_TRUE(std::isfinite(light.intensity) && light.intensity > 0);
        ASSERT_TRUE(std::isfinite(light.range) && light.range > 0);
        for (int i = 0; i < 3; ++i)
            ASSERT_TRUE(std::isfinite(light.colour[i]) && light.colour[i] >= 0);
        ASSERT_LE(light.inner_cone, light.outer_cone);
    }
}

INSTANTIATE_TEST_SUITE_P(Counts, CityLights, testing::Values(1u, 16u, 500u, 1024u, 65536u));

TEST(City, TheFirstLightsAreStreetLampsAndHeadLights) {
    const Scene scene = make_city(8, 1);
    for (const Light& light : scene.lights)
        EXPECT_EQ(light.kind, LightKind::spot);
    EXPECT_GT(scene.lights[0].outer_cone, 1.0f) << "a lamp comes first";
}

/// Mean number of lights that reach points 1.5 m above the street and on the pavements.
double overlap(uint32_t lights) {
    const Scene scene = make_city(lights, 1);
    double sum = 0;
    int points = 0;
    for (double x = -8; x <= 8; x += 2)
        for (double z = -100; z <= 10; z += 2.5) {
            ++points;
            for (const Node& node : scene.nodes)
                if (node.light) {
                    const glm::dvec3 d = glm::dvec3(node.local[3]) - glm::dvec3(x, 1.5, z);
                    sum += glm::length(d) < double(scene.lights[*node.light].range) ? 1 : 0;
                }
        }
    return sum / points;
}

TEST(City, TheNumberOfLightsOnAPointStaysSensible) {
    for (const uint32_t lights : {1024u, 16384u, 65536u}) {
        const double mean = overlap(lights);
        EXPECT_GT(mean, 8) << lights;
        EXPECT_LT(mean, 40) << lights;
    }
}

TEST(City, DependsOnNothingButItsSeed) {
    const uint64_t first = digest(city());
    EXPECT_EQ(digest(make_city(256, 1)), first);
    EXPECT_NE(digest(make_city(256, 2)), first);
}

TEST(City, ObjectsDoNotDependOnTheNumberOfLights) {
    const Scene few = make_city(3, 1);
    ASSERT_EQ(few.meshes.size(), city().meshes.size());
    for (size_t i = 0; i < few.meshes.size(); ++i)
        for (size_t k = 0; k < few.meshes[i].primitives.size(); ++k)
            EXPECT_EQ(few.meshes[i].primitives[k].positions, city().meshes[i].primitives[k].positions);
}

TEST(City, HasTheSizeOfItsDescription) {
    size_t triangles = 0, objects = 0;
    for (const Node& node : city().nodes)
        if (node.mesh) {
            ++objects;
            for (const Primitive& p : city().meshes.at(*node.mesh).primitives)
                triangles += p.indices.size() / 3;
        }
    EXPECT_GT(triangles, 100'000u);
    EXPECT_LT(triangles, 400'000u);
    EXPECT_GT(objects, 200u);
    EXPECT_LT(objects, 500u);
    ASSERT_EQ(city().cameras.size(), 3u);
    EXPECT_EQ(city().cameras[0].name, "street");
    EXPECT_EQ(city().cameras[1].name, "crossing");
    EXPECT_EQ(city().cameras[2].name, "above");
}

TEST(City, AttributesAreWholeAndFinite) {
    for_each_primitive(city(), [](const Primitive& p) {
        const size_t n = p.positions.size();
        ASSERT_EQ(p.normals.size(), n);
        ASSERT_EQ(p.indices.size() % 3, 0u);
        for (const size_t other : {p.tangents.size(), p.texcoords[0].size(), p.colours.size()})
            EXPECT_TRUE(other == 0 || other == n);
        for (const uint32_t index : p.indices)
            ASSERT_LT(index, n);
        EXPECT_TRUE(all_finite(p.positions));
        EXPECT_TRUE(all_finite(p.normals));
        EXPECT_TRUE(all_finite(p.tangents));
        EXPECT_TRUE(all_finite(p.texcoords[0]));
        for (const glm::vec4& colour : p.colours)
            for (int i = 0; i < 4; ++i)
                ASSERT_TRUE(colour[i] >= 0 && colour[i] <= 1) << colour[i];
    });
    for (const Node& node : city().nodes)
        for (int i = 0; i < 4; ++i)
            for (int k = 0; k < 4; ++k)
                ASSERT_TRUE(std::isfinite(node.local[i][k]));
}

TEST(City, NormalsAndTangentsAreUnitAndPerpendicular) {
    for_each_primitive(city(), [](const Primitive& p) {
        for (const glm::vec3& n : p.normals)
            ASSERT_NEAR(glm::length(n), 1, 1e-5);
        for (size_t i = 0; i < p.tangents.size(); ++i) {
            const glm::vec3 t(p.tangents[i]);
            ASSERT_NEAR(glm::length(t), 1, 1e-5);
            ASSERT_NEAR(glm::dot(t, p.normals[i]), 0, 1e-5);
            ASSERT_EQ(std::abs(p.tangents[i].w), 1);
        }
    });
}

TEST(City, TrianglesHaveAreaAndTurnTheWayTheirNormalsFace) {
    for_each_primitive(city(), [](const Primitive& p) {
        for (size_t i = 0; i < p.indices.size(); i += 3) {
            const uint32_t a = p.indices[i], b = p.indices[i + 1], c = p.indices[i + 2];
            const glm::dvec3 origin(p.positions[a]);
            const glm::dvec3 cross =
                glm::cross(glm::dvec3(p.positions[b]) - origin, glm::dvec3(p.positions[c]) - origin);
            ASSERT_GT(glm::length(cross), 1e-9) << "triangle " << i / 3;
            for (const uint32_t v : {a, b, c})
                ASSERT_GT(glm::dot(glm::normalize(cross), glm::dvec3(p.normals[v])), 0) << "triangle " << i / 3;
        }
    });
}

/// Tangents follow the texture: +u along T, and up the picture (−v) along w · N × T.
TEST(City, TangentsFollowTheTextureCoordinates) {
    size_t checked = 0;
    for_each_primitive(city(), [&](const Primitive& p) {
        for (size_t i = 0; i < p.indices.size() && !p.tangents.empty(); i += 3) {
            const uint32_t a = p.indices[i], b = p.indices[i + 1], c = p.indices[i + 2];
            const glm::dvec3 e1(p.positions[b] - p.positions[a]), e2(p.positions[c] - p.positions[a]);
            const auto& uv = p.texcoords[0];
            const glm::dvec2 d1(uv[b] - uv[a]), d2(uv[c] - uv[a]);
            const double det = d1.x * d2.y - d2.x * d1.y;
            ASSERT_NE(det, 0);
            const glm::dvec3 along_u = (e1 * d2.y - e2 * d1.y) / det;
            const glm::dvec3 along_v = (e2 * d1.x - e1 * d2.x) / det;
            const glm::dvec3 n(p.normals[a]), t(p.tangents[a]);
            ASSERT_GT(glm::dot(glm::normalize(along_u), t), 0.999);
            ASSERT_GT(glm::dot(glm::normalize(-along_v), glm::cross(n, t) * double(p.tangents[a].w)), 0.999);
            ++checked;
        }
    });
    EXPECT_GT(checked, 10'000u);
}

TEST(City, MaterialsReferToPicturesAndPrimitivesCarryWhatTheyNeed) {
    EXPECT_LE(city().materials.size(), 30u);
    for (const Material& material : city().materials) {
        EXPECT_FALSE(material.name.empty());
        for (const Ref& r : textures(material))
            EXPECT_LT(r.ref.image, city().images.size()) << material.name << ' ' << r.what;
    }
    std::vector<bool> used(city().materials.size());
    for_each_primitive(city(), [&](const Primitive& p) {
        ASSERT_LT(p.material, city().materials.size());
        used[p.material] = true;
        const Material& material = city().materials[p.material];
        for (const Ref& r : textures(material))
            EXPECT_EQ(p.texcoords[r.ref.texcoord].size(), p.positions.size()) << material.name << ' ' << r.what;
        EXPECT_EQ(p.tangents.empty(), !material.normal_texture) << material.name;
    });
    EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
}

/// Mean difference of the texels on both sides of a line between columns (or rows) of a picture
/// that repeats; line 0 is its edge.
double step_across(const TextureImage& image, uint32_t line, bool vertical) {
    const uint32_t across = vertical ? image.width : image.height;
    const uint32_t along = vertical ? image.height : image.width;
    double sum = 0;
    for (uint32_t i = 0; i < along; ++i)
        for (uint32_t channel = 0; channel < 4; ++channel) {
            const auto at = [&](uint32_t k) {
                const size_t x = vertical ? k : i, y = vertical ? i : k;
                return int{image.rgba[4 * (y * image.width + x) + channel]};
            };
            sum += std::abs(at(line) - at((line + across - 1) % across));
        }
    return sum / along;
}

TEST(City, PicturesThatRepeatAreContinuousOverTheirEdges) {
    int checked = 0;
    for (const TextureImage& image : city().images) {
        ASSERT_EQ(image.rgba.size(), size_t{4} * image.width * image.height) << image.name;
        EXPECT_LE(image.width, 1024u);
        EXPECT_LE(image.height, 1024u);
        const bool tiles = image.name.starts_with("asphalt") || image.name.starts_with("paving") ||
                           image.name.starts_with("brick") || image.name.starts_with("plaster") ||
                           image.name == "marking" || image.name == "wood";
        if (!tiles)
            continue;
        ++checked;
        for (const bool vertical : {true, false}) {
            // The edge runs through the middle of joints and bricks, where colours change little:
            // its step is like most inside. In a normal map a joint's two slopes meet there, as
            // they do on every joint: the largest step inside is the measure.
            std::vector<double> inside;
            for (uint32_t line = 1; line < image.width; ++line)
                inside.push_back(step_across(image, line, vertical));
            std::sort(inside.begin(), inside.end());
            const bool slopes = image.name.ends_with("normal");
            const double bound = slopes ? 1.1 * inside.back() : 1.5 * inside[inside.size() / 2] + 0.5;
            EXPECT_LE(step_across(image, 0, vertical), bound) << image.name << (vertical ? " u" : " v");
        }
    }
    EXPECT_EQ(checked, 11);
}

/// "house, stone trim" for one side of a pair.
std::string name_of(const World& world, const CoplanarPair::Face& face) {
    const Mesh& mesh = world.scene->meshes[world.instances[face.instance].mesh];
    return mesh.name + ", " + world.scene->materials[mesh.primitives[face.primitive].material].name;
}

TEST(City, NoTwoFacesFightForOnePlane) {
    for (const uint64_t seed : {1u, 2u}) {
        const Scene scene = make_city(1, seed);
        const World world = resolve(scene);
        const std::vector<CoplanarPair> pairs = find_coplanar(world);
        EXPECT_EQ(pairs.size(), 0u) << "seed " << seed;
        std::set<std::string> told; // one of each kind
        for (const CoplanarPair& pair : pairs) {
            const std::string what = name_of(world, pair.a) + " | " + name_of(world, pair.b);
            if (told.insert(what).second)
                ADD_FAILURE() << what << ": " << 1e4 * pair.area << " cm² at (" << pair.point.x << ", " << pair.point.y
                              << ", " << pair.point.z << ") facing (" << pair.normal.x << ", " << pair.normal.y << ", "
                              << pair.normal.z << ')';
        }
    }
}

TEST(City, IsMadeInTime) {
#if !defined(__OPTIMIZE__) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "the bound is for optimised builds";
#endif
    // Processor time: other work on the machine does not count.
    const std::clock_t start = std::clock();
    const Scene scene = make_city(65536, 1);
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 2.0);
    EXPECT_EQ(scene.lights.size(), 65536u);
}

// What blends comes after all that is the city's, which stays as it is.
TEST(City, GlassIsAddedToTheSameStreet) {
    const Scene glass = make_city_glass(256, 1);
    ASSERT_GT(glass.meshes.size(), city().meshes.size());
    ASSERT_GT(glass.nodes.size(), city().nodes.size() + 50);
    EXPECT_EQ(glass.lights.size(), city().lights.size());
    for (size_t i = 0; i < glass.nodes.size(); ++i) {
        const Node& node = glass.nodes[i];
        const bool added = i >= city().nodes.size();
        if (!added) {
            EXPECT_EQ(node.mesh, city().nodes[i].mesh);
        }
        for (const Primitive& primitive : node.mesh ? glass.meshes.at(*node.mesh).primitives : std::vector<Primitive>())
            EXPECT_EQ(glass.materials.at(primitive.material).alpha_mode == AlphaMode::blend, added) << node.name;
    }
}

} // namespace
} // namespace prelight
