// Which pixels a picture of several samples a pixel cannot judge, and which are edges.
#include "sampled.hpp"
#include <algorithm>
#include <gmock/gmock.h>
#include <numeric>

namespace prelight {
namespace {

using Picture = ReferencePicture;

uint32_t sum(const std::vector<uint8_t>& bytes) { return std::accumulate(bytes.begin(), bytes.end(), 0u); }

uint32_t with(const Picture& picture, Picture::Doubt doubt) {
    return static_cast<uint32_t>(
        std::count_if(picture.doubts.begin(), picture.doubts.end(), [&](uint8_t all) { return all & doubt; }));
}

/// All that is right of an upright line, in pixels.
Primitive right_of(double x) { return triangle(at_pixel(x, -500), at_pixel(x, 500), at_pixel(900, 0)); }

TEST(SampleDoubts, AnEdgeIsLeftOutOnlyBesideASample) {
    // Samples lie at an eighth, three, five and seven eighths of the pixel.
    for (const ProjectionKind kind : {ProjectionKind::perspective, ProjectionKind::orthographic})
        for (const auto& [place, out] : {std::pair(0.25, false),
                                         {0.375 - 1.2 / 128, false},
                                         {0.375 - 0.8 / 128, true},
                                         {0.375 + 0.8 / 128, true},
                                         {0.375 + 1.2 / 128, false}}) {
            TestWorld test;
            test.add(right_of(6 + place));
            const auto picture = sampled(test, metre_camera(kind), {.count = 4});
            EXPECT_EQ(sum(picture.edge), rows) << place;
            EXPECT_EQ(sum(picture.left_out()), out ? rows : 0) << place;
            EXPECT_EQ(with(picture, Picture::near_edge), out ? rows : 0) << place;
        }
}

TEST(SampleDoubts, AreOfOtherInstancesNormalsAndPlanes) {
    const auto picture_of = [](const TestWorld& test) {
        return sampled(test, metre_camera(ProjectionKind::orthographic), {.count = 4});
    };
    const double at_sample = 6.375;
    {
        TestWorld test; // of one plane, but two instances
        test.add(right_of(at_sample));
        test.add(triangle(at_pixel(at_sample, -500), at_pixel(at_sample, 500), at_pixel(-900, 0)));
        EXPECT_EQ(with(picture_of(test), Picture::near_edge), rows);
        EXPECT_EQ(sum(picture_of(test).edge), rows);
    }
    // Two triangles of one primitive, the other's normals turned, or the other away from its plane.
    for (const auto& [degrees, metres, out] :
         {std::tuple(0.0, 0.0, false), {29.0, 0.0, false}, {31.0, 0.0, true}, {0.0, 0.04, false}, {0.0, 0.06, true}}) {
        Primitive both = right_of(at_sample);
        const Primitive other = triangle(at_pixel(at_sample, -500), at_pixel(at_sample, 500), at_pixel(-900, 0));
        const double angle = degrees * 3.14159265358979 / 180;
        for (const glm::vec3& corner : other.positions) {
            both.positions.push_back(corner - glm::vec3(0, 0, static_cast<float>(metres)));
            both.normals.emplace_back(std::sin(angle), 0, std::cos(angle));
        }
        for (const uint32_t index : other.indices)
            both.indices.push_back(index + 3);
        TestWorld test;
        test.add(both);
        const auto picture = picture_of(test); // 5 m away
        EXPECT_EQ(with(picture, Picture::near_edge), out ? rows : 0) << degrees << ", " << metres;
        EXPECT_EQ(sum(picture.edge), out ? rows : 0);
        EXPECT_EQ(sum(picture.left_out()), out ? rows : 0);
    }
}

TEST(SampleDoubts, SurfacesAreSharedOrNotButForWhatIsStored) {
    const auto picture_of = [](double degrees, float roughness, const ReferenceSamples& samples) {
        TestWorld test;
        test.add_material({.metallic = 0, .roughness = 0.5f});
        test.add(right_of(6.5));
        Primitive left = triangle(at_pixel(6.5, -500), at_pixel(6.5, 500), at_pixel(-900, 0));
        const double angle = degrees * 3.14159265358979 / 180;
        left.normals.assign(3, glm::vec3(std::sin(angle), 0, std::cos(angle)));
        test.add_material({.metallic = 0, .roughness = roughness});
        test.add(left);
        return sampled(test, metre_camera(ProjectionKind::orthographic), samples);
    };
    const ReferenceSamples pixel{.count = 4, .light = SampleLight::pixel};
    const ReferenceSamples edges{.count = 4, .light = SampleLight::edges};
    struct {
        double degrees; // a pixel's samples share a surface up to 8.11, an edge's share light up to 1.81
        float roughness;
        bool pixel, edges;
    } const cases[] = {{0, 0.5f, false, false},    {7.8, 0.5f, false, false}, {8.0, 0.5f, true, true},
                       {8.25, 0.5f, true, true},   {8.5, 0.5f, false, false}, {0, 0.51f, false, false},
                       {0, 0.523f, true, true},    {0, 0.54f, false, false},  {1.9, 0.54f, false, false},
                       {1.9, 0.505f, false, false}};
    for (const auto& one : cases) {
        SCOPED_TRACE(testing::Message() << one.degrees << " degrees, roughness " << one.roughness);
        EXPECT_EQ(with(picture_of(one.degrees, one.roughness, pixel), Picture::sharing), one.pixel ? rows : 0);
        EXPECT_EQ(with(picture_of(one.degrees, one.roughness, edges), Picture::sharing), one.edges ? rows : 0);
        EXPECT_EQ(with(picture_of(one.degrees, one.roughness, {.count = 4}), Picture::sharing), 0u);
    }
}

TEST(SampleDoubts, AShadowsBorderIsLeftOutAndNoEdge) {
    TestWorld test;
    test.add_material({.metallic = 0});
    test.add(wall_triangle());
    test.add(right_of(6.5), glm::translate(glm::dmat4(1), {0, 0, 20})); // behind the camera
    test.add_light({.kind = LightKind::directional}, {});
    const PlacedCamera camera = metre_camera(ProjectionKind::orthographic);
    EXPECT_EQ(sum(sampled(test, camera, {.count = 4}).left_out()), 0u);
    const ReferenceForm shadows{.shadows = true};
    for (const ReferenceSamples& samples : every_form) {
        const auto picture = sampled(test, camera, samples, shadows);
        EXPECT_EQ(sum(picture.edge), 0u);
        // The pixel that it crosses and those beside it; where a pixel has one outcome, the two at the border.
        const bool once = samples.light != SampleLight::sample || samples.shadows_per_pixel; // nothing is an edge
        EXPECT_EQ(with(picture, Picture::shadow), (once ? 2u : 3u) * rows);
        EXPECT_EQ(sum(picture.left_out()), (once ? 2u : 3u) * rows);
    }
}

TEST(SampleDoubts, OtherSurfacesMayHaveOtherShadows) {
    // A wall in shadow, and before half of it one that is not: an edge like any other.
    TestWorld test;
    test.add_material({.metallic = 0});
    test.add(wall_triangle());
    test.add(right_of(6.5), glm::translate(glm::dmat4(1), {0, 0, 1}));
    test.add(wall_triangle(), glm::translate(glm::dmat4(1), {0, 0, 0.5}));
    test.world.instances[2].visible = false;
    test.add_light({.kind = LightKind::directional}, {});
    const PlacedCamera camera = metre_camera(ProjectionKind::orthographic);
    const ReferenceForm shadows{.shadows = true};
    // The light comes from the left: the nearer wall's shadow begins beyond the picture.
    test.world.lights[0].direction = glm::normalize(glm::dvec3(-1, 0, -0.01));
    const auto picture = sampled(test, camera, {.count = 4}, shadows);
    EXPECT_EQ(with(picture, Picture::shadow), 0u);
    EXPECT_EQ(sum(picture.edge), rows);
    EXPECT_EQ(sum(picture.left_out()), 0u);
}

TEST(SampleDoubts, AMasksBorderIsLeftOut) {
    TestWorld test;
    Material masked{.alpha_mode = AlphaMode::mask, .unlit = true};
    masked.base_colour_texture.image = test.add_image(2, 1, {255, 255, 255, 255, 255, 255, 255, 0});
    masked.base_colour_texture.sampler = {.wrap_s = Wrap::clamp_to_edge};
    test.add_material(masked);
    test.add(square(12), glm::translate(glm::dmat4(1), glm::dvec3(0.25, 0, 0)));
    const PlacedCamera camera = metre_camera(ProjectionKind::orthographic);
    // Across pixel 12, whatever the rate of the geometry.
    const auto each = sampled(test, camera, {.count = 4});
    const auto once = sampled(test, camera, {.count = 4, .geometry = SampleRate::fragment});
    for (uint32_t x = 2; x < columns; ++x) { // the square begins in pixel 0
        EXPECT_EQ(each.left_out()[5 * columns + x], x >= 11 && x <= 13) << x;
        EXPECT_EQ(once.left_out()[5 * columns + x], x >= 11 && x <= 13) << x;
    }
    EXPECT_EQ(each.doubts[5 * columns + 12], Picture::mask);
}

} // namespace
} // namespace prelight
