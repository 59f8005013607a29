// Volumes find every pixel of their light once, wherever the camera is.
#include "found_pixels.hpp"
#include "vulkan_calls.hpp"
#include <passes/volume_meshes.hpp>
#include <resident/lights.hpp>

namespace prelight {
namespace {

struct Placement {
    const char* name;
    double distance; ///< of the light from the camera, in ranges
};

class Volumes : public testing::TestWithParam<LightCase> {};

/// The same light drawn by its volume and by a full-screen triangle: the same picture, and exactly
/// the same count of pixels that it lights.
void expect_volumes_find_as_fullscreen(Garden& garden, const PlacedCamera& camera, const std::string& where) {
    Image pictures[2];
    uint64_t contributing[2], evaluated[2];
    for (const int full : {0, 1}) {
        RenderOptions options;
        options.width = 320;
        options.height = 180;
        options.count_pairs = true;
        options.views = {"linear"};
        options.settings = {{"light-culling", full ? "fullscreen" : "volumes"}};
        const auto renderer = create_renderer("light-prepass", &test_device(), options);
        renderer->set_world(garden.world);
        renderer->render(camera);
        pictures[full] = renderer->read("linear");
        contributing[full] = renderer->stats().pairs_contributing;
        evaluated[full] = renderer->stats().pairs_evaluated;
    }
    EXPECT_EQ(contributing[0], contributing[1]) << where;
    EXPECT_LE(evaluated[0], evaluated[1]) << where;
    // Lights seen from inside are drawn after those seen from outside, and half floats round by order.
    const Comparison same = compare_pixels(pictures[0], pictures[1]);
    EXPECT_GE(same.psnr, 70) << where;
    EXPECT_LE(same.block, 0.25) << where;
}

TEST_P(Volumes, FindTheirPixelsOnceFromOutsideInsideAndCutByTheNearPlane) {
    const LightCase& c = GetParam();
    for (const double share : {2.5, 1.05, 1.0, 0.95, 0.5, 0.05}) {
        Garden garden;
        garden.camera.camera.znear = 0.25; // a large near rectangle, so that volumes are really cut
        const glm::dvec3 forward = -garden.camera.axes[2];
        const double distance = share * c.light.range;
        garden.add_light(c.light, garden.camera.position + forward * distance, c.direction);
        expect_volumes_find_as_fullscreen(garden, garden.camera, "light at " + std::to_string(share) + " ranges");
    }
    expect_validation_clean(test_device());
}

TEST_P(Volumes, AgreeWithTheReferenceFromInside) {
    Garden garden;
    Light light = GetParam().light;
    light.range *= 3; // reaches floor and camera at once
    light.intensity *= 2;
    garden.add_light(light, garden.at(0.5, 3.8, 6.5), GetParam().direction);
    Shot shot = garden.shot();
    shot.settings["light-culling"] = "volumes";
    expect_agrees(shot);
}
INSTANTIATE_TEST_SUITE_P(All, Volumes, testing::ValuesIn(light_cases()),
                         [](const auto& form) { return std::string(form.param.name); });

TEST(VolumeCulling, ManyLightsLightTheSamePixelsAsFullScreen) {
    Garden garden;
    garden.add_lights(64, 1.5f, 3);
    expect_volumes_find_as_fullscreen(garden, garden.camera, "64 lights");
    Garden orthographic;
    orthographic.add_lights(64, 1.5f, 3);
    orthographic.camera.camera.kind = ProjectionKind::orthographic;
    orthographic.camera.camera.ymag = 2;
    orthographic.camera.camera.znear = 7; // cuts through the garden
    orthographic.camera.camera.zfar = 11;
    expect_volumes_find_as_fullscreen(orthographic, orthographic.camera, "orthographic");
    Garden finite;
    finite.add_lights(64, 3, 3);
    finite.camera.camera.zfar = 11; // volumes reach past the far plane
    expect_volumes_find_as_fullscreen(finite, finite.camera, "finite far plane");
}

TEST(VolumeCulling, LightsBesideThePictureReachIntoIt) {
    Garden garden;
    Camera tele;
    tele.yfov = 0.25;
    garden.camera = look_at(tele, garden.camera.position, garden.at(0, 0.6, 0));
    for (int i = 0; i < 48; ++i) { // a ring around what is seen, near and far
        const double angle = 0.7 * i, radius = 1.0 + 0.06 * i;
        const glm::dvec3 across =
            garden.camera.axes[0] * std::cos(angle) * (1.6 * radius) + garden.camera.axes[1] * std::sin(angle) * radius;
        garden.add_light(garden.point(2.2f, 3), garden.at(0, 0.6, 0) + across);
    }
    expect_volumes_find_as_fullscreen(garden, garden.camera, "a ring of lights around the view");
}

TEST(VolumeCulling, CameraBetweenARangeAndACapsCorner) {
    // The corners of a wide cone's cap lie beyond the range: a camera there is inside the mesh.
    for (const float outer : {55 * degree, 60 * degree, 70 * degree, 79 * degree}) {
        Garden garden;
        Light light = garden.spot(outer, 6, 40);
        const double along = (1 + 1 / std::cos(outer / 2)) / 2 * light.range;
        const glm::dvec3 back = garden.camera.axes[2], down = -garden.camera.axes[1];
        const glm::dvec3 axis = back * std::cos(outer / 2.0) + down * std::sin(outer / 2.0);
        garden.add_light(light, garden.camera.position - back * along, axis);
        expect_volumes_find_as_fullscreen(garden, garden.camera, "outer cone " + std::to_string(outer));
    }
}

TEST(VolumeCulling, ARangeNearTheLargestFloatIsNone) {
    Garden garden;
    garden.add_light(garden.point(3.4e38f, 20), {0, 4, 2});
    garden.add_light(garden.spot(0.5f, 1e30f, 20), {2, 4, 2}, {-0.3, -1, -0.4});
    Shot shot = garden.shot();
    shot.settings["light-culling"] = "volumes";
    expect_agrees(shot);
}

TEST(VolumeCulling, LightsOffScreenOrDarkCostNothing) {
    Garden garden;
    garden.add_light(garden.point(3, 10), {0, 2, 60});
    garden.add_light(garden.point(3, 0), {0, 2, 0});
    garden.add_light(garden.point(3, 10, {0, 0, 0}), {0, 2, 0});
    RenderOptions options;
    options.width = 64;
    options.height = 36;
    options.count_pairs = true;
    const auto renderer = create_renderer("light-prepass", &test_device(), options);
    renderer->set_world(garden.world);
    renderer->render(garden.camera);
    EXPECT_EQ(renderer->stats().pairs_evaluated, 0u);
    garden.add_light(garden.point(3, 10), {0, 2, 0});
    renderer->set_world(garden.world);
    renderer->render(garden.camera);
    EXPECT_GT(renderer->stats().pairs_contributing, 0u);
}

/// What a frame draws under `count` lights each of spheres and cones, seen from outside and from inside.
std::pair<uint64_t, uint64_t> draws_and_instances(const char* renderer, const char* culling, uint32_t count) {
    Garden garden;
    for (uint32_t i = 0; i < count; ++i) {
        const double x = -4 + 8.0 * i / 200;
        for (const double range : {1.0, 40.0}) {
            garden.add_light(garden.point(static_cast<float>(range), 0.1f), garden.at(x, 1, 0));
            garden.add_light(garden.spot(0.5f, static_cast<float>(range), 0.1f), garden.at(x, 1, 1), {0, -1, 0.1});
        }
    }
    Shot shot = garden.shot();
    shot.renderer = renderer;
    shot.settings = {{"light-culling", culling}};
    const auto one = create_renderer(renderer, &test_device(), options_of(shot));
    one->set_world(garden.world);
    one->render(garden.camera); // with the warm-up
    const VulkanCalls calls;
    one->render(garden.camera);
    one->stats();
    return {calls.draws, calls.instances};
}

TEST(InstancedVolumes, AreOneDrawForAllLightsOfAKind) {
    for (const char* renderer : {"light-prepass", "deferred"}) {
        const auto [none, surfaces] = draws_and_instances(renderer, "volumes", 0);
        const auto [few, one_each] = draws_and_instances(renderer, "volumes", 1);
        const auto [many, all] = draws_and_instances(renderer, "volumes", 200);
        EXPECT_EQ(few, none + 4) << renderer << ": spheres and cones, from outside and from inside";
        EXPECT_EQ(one_each, surfaces + 4);
        EXPECT_EQ(many, few) << renderer;
        EXPECT_EQ(all, surfaces + 800) << renderer << ": each light is an instance";
        // What the count would be without: stencil marks light by light.
        EXPECT_EQ(draws_and_instances(renderer, "stencil", 200).first, none + 1600);
    }
}

/// Distance from the origin to the nearest triangle's plane, outward positive.
double nearest_plane(const std::vector<glm::vec3>& points, const std::vector<uint32_t>& indices) {
    double nearest = 1e9;
    for (size_t i = 0; i < indices.size(); i += 3) {
        const glm::dvec3 a = points[indices[i]], b = points[indices[i + 1]], c = points[indices[i + 2]];
        nearest = std::min(nearest, glm::dot(glm::normalize(glm::cross(b - a, c - a)), a));
    }
    return nearest;
}

TEST(VolumeMeshes, SphereCircumscribesTheUnitSphere) {
    const passes::VolumeMesh mesh = passes::sphere_volume();
    EXPECT_EQ(mesh.indices.size(), 80u * 3);
    EXPECT_GE(nearest_plane(mesh.points, mesh.indices), 1 - 1e-6);
    for (const glm::vec3& p : mesh.points)
        EXPECT_LT(glm::length(p) * 1.001f, resident::volume_reach({.kind = LightKind::point}));
}

TEST(VolumeMeshes, ConeStaysWithinItsReach) {
    const passes::VolumeMesh mesh = passes::cone_volume(resident::cone_sides);
    for (float outer = 0.05f; outer < 80 * degree; outer += 0.05f) {
        double farthest = 0;
        for (const glm::vec3& p : mesh.points) { // as light_volume.vert places them
            const double radius = p.z == 1 ? std::sin(outer) : p.z == 2 ? std::tan(outer / 2) : 0;
            const double along = p.z == 0 ? 0 : p.z == 1 ? std::cos(outer) : 1;
            farthest = std::max(farthest, std::hypot(radius * std::hypot(p.x, p.y), along) * 1.001 + 0.0005);
        }
        EXPECT_LE(farthest, resident::volume_reach({.kind = LightKind::spot, .outer_cone = outer})) << outer;
    }
}

} // namespace
} // namespace prelight
