// Rectangles around the projected volumes find every pixel of their light once.
#include "found_pixels.hpp"
#include <cmath>
#include <numbers>
#include <random>
#include <resident/light_bounds.hpp>
#include <resident/lights.hpp>

namespace prelight {
namespace {

using resident::Interval, resident::ScreenBounds;
using std::numbers::pi;

const SettingMap rectangles{{"light-culling", "rectangles"}};

class Rectangles : public testing::TestWithParam<LightCase> {};

TEST_P(Rectangles, FindTheirPixelsOnceFromOutsideInsideAndCutByTheNearPlane) {
    const LightFromEverywhere scene(GetParam().light, GetParam().direction);
    expect_same_as_fullscreen(scene.garden.world, scene.cameras, {{rectangles}});
}

TEST_P(Rectangles, AgreeWithTheReferenceFromInside) {
    Garden garden;
    Light light = GetParam().light;
    light.range *= 3; // reaches floor and camera at once
    light.intensity *= 2;
    garden.add_light(light, garden.at(0.5, 3.8, 6.5), GetParam().direction);
    Shot shot = garden.shot();
    shot.settings = rectangles;
    expect_agrees(shot);
}
INSTANTIATE_TEST_SUITE_P(All, Rectangles, testing::ValuesIn(light_cases()),
                         [](const auto& form) { return std::string(form.param.name); });

TEST(RectangleCulling, LightsEverywhereAndEveryProjection) {
    const LightsEverywhere scene;
    expect_same_as_fullscreen(scene.garden.world, scene.cameras, {{rectangles}});
}

TEST(RectangleCulling, ManyLightsAgreeWithTheReference) {
    LightsEverywhere scene;
    scene.garden.add_light({.kind = LightKind::directional, .intensity = 0.3f}, {0, 0, 0}, {-0.3, -1, -0.5});
    Shot shot = scene.garden.shot();
    shot.settings = rectangles;
    expect_agrees(shot);
}

TEST(RectangleCulling, AConeThatPointsOutOfThePictureCostsNothing) {
    Garden garden; // its sphere reaches into the picture
    garden.add_light(garden.spot(0.3f, 6, 10), garden.camera.position + garden.camera.axes[0] * 3.0,
                     garden.camera.axes[0]);
    const std::vector<PlacedCamera> cameras{garden.camera};
    EXPECT_EQ(find_pixels(garden.world, cameras, rectangles)[0].evaluated, 0u);
}

TEST(DepthBounds, TestNearAndFarSideWhereTheDeviceHasThem) {
    Device* const device = swiftshader_device();
    if (!device)
        GTEST_SKIP() << "SwiftShader is not installed (Debian's package chromium)";
    LightsEverywhere scene;
    scene.cameras.resize(3);
    std::vector<PlacedLight>& lights = scene.garden.world.lights; // few: the driver compiles for each
    for (size_t i = 0; i < lights.size(); ++i)
        lights[i / 4] = lights[i];
    lights.resize(lights.size() / 4);
    const SettingMap on{{"light-culling", "rectangles"}, {"depth-bounds", "on"}};
    const SettingMap off{{"light-culling", "rectangles"}, {"depth-bounds", "off"}};
    const auto found = expect_same_as_fullscreen(scene.garden.world, scene.cameras, {{on, off}}, *device);
    for (size_t i = 0; i < scene.cameras.size(); ++i)
        EXPECT_LT(found[0][i].evaluated, found[1][i].evaluated) << "camera " << i;
}

TEST(DepthBounds, ADeviceWithoutThemSaysSo) {
    Garden garden;
    garden.add_lights(4, 2, 3);
    for (const char* value : {"on", "auto"}) {
        SettingMap settings = rectangles;
        settings["depth-bounds"] = value;
        const auto renderer =
            create_renderer("light-prepass", &test_device(), {.width = 16, .height = 16, .settings = settings});
        renderer->set_world(garden.world);
        renderer->render(garden.camera);
        const std::vector<std::string> notes = renderer->stats().notes;
        if (value == std::string("on"))
            EXPECT_THAT(notes, testing::ElementsAre(testing::HasSubstr("has no depth bounds test")));
        else
            EXPECT_TRUE(notes.empty());
    }
}

/// The extent of a light's volume by many points of its surface and of its edges at the near and far
/// planes; `larger` scales its range and its cone.
ScreenBounds brute_force(const PlacedLight& placed, const PlacedCamera& camera, double aspect, double larger) {
    const Camera& lens = camera.camera;
    const bool perspective = lens.kind == ProjectionKind::perspective, cone = resident::is_cone(placed.light);
    const double half = perspective ? std::tan(lens.yfov / 2) : lens.ymag, range = placed.light.range * larger;
    const double angle = cone ? std::min(placed.light.outer_cone * larger, pi / 2) : pi;
    const glm::dvec3 axis = placed.direction;
    const glm::dvec3 side =
        glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1)));
    const glm::dvec3 up = glm::cross(axis, side);
    const glm::dvec3 apex = placed.position - axis * (cone ? (larger - 1) * range : 0) - camera.position;
    constexpr int along = 120, around = 72;
    const auto point = [&](int i, int j) { // view space, z forward; first up the cone, then over the cap
        const double s = double(i) / along, turn = 2 * pi * j / around;
        const double length = cone ? std::min(1.0, 2 * s) : 1, a = cone ? angle * std::min(1.0, 2 - 2 * s) : pi * s;
        const glm::dvec3 p = apex + (axis * std::cos(a) + (side * std::cos(turn) + up * std::sin(turn)) * std::sin(a)) *
                                        (range * length);
        return glm::dvec3(glm::dot(p, camera.axes[0]), glm::dot(p, camera.axes[1]), -glm::dot(p, camera.axes[2]));
    };
    ScreenBounds out;
    const auto add = [&](glm::dvec3 p) {
        const double w = half * (perspective ? p.z : 1);
        out.x.add(p.x / (w * aspect));
        out.y.add(-p.y / w);
        out.depth.add(p.z);
    };
    for (int i = 0; i <= along; ++i)
        for (int j = 0; j < around; ++j) {
            const glm::dvec3 p = point(i, j);
            if (p.z >= lens.znear && p.z <= lens.zfar)
                add(p);
            for (const glm::dvec3& q : {point(std::min(i + 1, along), j), point(i, j + 1)})
                for (const double plane : {lens.znear, lens.zfar})
                    if ((p.z < plane) != (q.z < plane)) {
                        glm::dvec3 cut = p + (q - p) * ((plane - p.z) / (q.z - p.z));
                        cut.z = plane;
                        add(cut);
                    }
        }
    return out;
}

/// `inner` lies in `outer`, within the picture and a little more, but for `slack`.
bool holds(const Interval& outer, const Interval& inner, double slack) {
    if (inner.empty() || inner.low > 1 || inner.high < -1)
        return true;
    return outer.low <= std::max(inner.low, -1.0) + slack && outer.high >= std::min(inner.high, 1.0) - slack;
}

TEST(ScreenBounds, AreNeverTooSmallAndAtMostAPixelTooLarge) {
    std::mt19937 random(7);
    const auto number = [&](double low, double high) { return low + (high - low) * random() / 4294967296.0; };
    const double pixel = 2.0 / 320;
    int seen[2][2] = {}, missed = 0;
    for (int n = 0; n < 400; ++n) {
        PlacedLight light;
        const bool spot = n % 2, cut = n % 4 >= 2;
        light.light.kind = spot ? LightKind::spot : LightKind::point;
        light.light.outer_cone = static_cast<float>(number(0.05, 1.39));
        light.light.range = static_cast<float>(number(0.3, 6));
        const double away = cut ? number(-1, 1) : number(1.1, 6);
        light.position = {number(-2, 2) * away, number(-1, 1) * away, -away * light.light.range};
        light.direction = glm::normalize(glm::dvec3(number(-1, 1), number(-1, 1), number(-1, 1)));
        PlacedCamera camera = look_at({}, {0, 0, 0}, {number(-0.3, 0.3), number(-0.3, 0.3), -1});
        camera.camera.yfov = number(0.4, 2);
        if (n % 5 == 0) {
            camera.camera.kind = ProjectionKind::orthographic;
            camera.camera.ymag = number(1, 5);
            camera.camera.zfar = 40;
        } else if (n % 5 == 1) {
            camera.camera.zfar = number(2, 12);
        }
        const double aspect = 320.0 / 180;
        const ScreenBounds exact = brute_force(light, camera, aspect, 1),
                           bounds = resident::screen_bounds(light, camera, aspect);
        if (exact.empty()) {
            missed += bounds.empty();
            continue;
        }
        ++seen[spot][cut];
        EXPECT_TRUE(holds(bounds.x, exact.x, 0) && holds(bounds.y, exact.y, 0)) << "too small: light " << n;
        EXPECT_TRUE(bounds.depth.low <= exact.depth.low && bounds.depth.high >= exact.depth.high)
            << "depth of light " << n;
        if (spot && n % 5 == 1)
            continue; // what the far plane cuts of a cone is not worth computing
        // A cut cone is a polyhedron of 24 sides; the rest is exact, for a range 1.001 times as large.
        const bool polyhedron = spot && bounds.depth.low <= camera.camera.znear;
        const ScreenBounds larger = brute_force(light, camera, aspect, polyhedron ? 1.03 : 1.002);
        EXPECT_TRUE(holds(larger.x, bounds.x, pixel) && holds(larger.y, bounds.y, pixel * aspect))
            << "too large: light " << n << ": x " << bounds.x.low << " … " << bounds.x.high << " in " << larger.x.low
            << " … " << larger.x.high << ", y " << bounds.y.low << " … " << bounds.y.high << " in " << larger.y.low
            << " … " << larger.y.high;
        EXPECT_NEAR(bounds.depth.low, exact.depth.low, 0.01 * light.light.range) << "depth of light " << n;
        EXPECT_NEAR(bounds.depth.high, exact.depth.high, 0.01 * light.light.range) << "depth of light " << n;
    }
    for (const auto& kind : seen)
        for (const int count : kind)
            EXPECT_GT(count, 30);
    EXPECT_GT(missed, 20);
}

} // namespace
} // namespace prelight
