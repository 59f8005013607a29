// What is evaluated how often, with several samples a pixel.
#include "sampled.hpp"
#include <gmock/gmock.h>
#include <reference/lens.hpp>

namespace prelight {
namespace {

/// A ball before a wall, both of one colour each, and a light near them.
struct BallBeforeWall : TestWorld {
    PlacedCamera camera = metre_camera(ProjectionKind::perspective);
    explicit BallBeforeWall(bool unlit = false) {
        add_material({.base_colour = {0.2f, 0.7f, 0.4f, 1}, .roughness = 0.6f, .unlit = unlit});
        add(wall_triangle());
        add_material({.base_colour = {0.9f, 0.3f, 0.2f, 1}, .roughness = 0.3f, .unlit = unlit});
        add(sphere(24), glm::scale(glm::translate(glm::dmat4(1), {1, 0.5, 1}), glm::dvec3(5)));
        add_light({.intensity = 300}, {-7, 5, 9});
    }
    ReferencePicture picture(const ReferenceSamples& samples, const ReferenceForm& form = {}) const {
        return sampled(*this, camera, samples, form);
    }
};

TEST(SampleForms, TheTruthIsInALargerPicture) {
    // Samples lie at odd eighths of a pixel, two of them at odd quarters: where centres do in larger pictures.
    const BallBeforeWall test;
    const ReferenceForm shadows{.shadows = true, .occlusion_radius = 3};
    for (const uint32_t count : {2u, 4u}) {
        const auto larger = render_reference(test.world, test.camera, columns * count, rows * count, 0, shadows).linear;
        const auto truth = test.picture({.count = count}, shadows);
        const auto places = reference::sample_positions(count);
        for (uint32_t y = 0; y < rows; ++y)
            for (uint32_t x = 0; x < columns; ++x) {
                glm::dvec3 sum(0);
                for (uint32_t s = 0; s < count; ++s) {
                    const glm::uvec2 at(glm::dvec2(count) * (glm::dvec2(x, y) + places[s]));
                    EXPECT_EQ(truth.sample_colours[(y * columns + x) * count + s], larger.at(at.x, at.y));
                    sum += glm::dvec3(larger.at(at.x, at.y));
                }
                EXPECT_FLOAT_EQ(truth.linear.at(x, y).g, static_cast<float>(sum.g / count));
            }
    }
}

TEST(SampleForms, AreAllEqualWhereNothingIsLit) {
    const BallBeforeWall test(true);
    const auto truth = test.picture({.count = 4});
    EXPECT_THAT(truth.edge, testing::Contains(1));
    for (const ReferenceSamples& samples : every_form)
        if (samples.count == 4) {
            EXPECT_TRUE(test.picture(samples).sample_colours == truth.sample_colours);
        }
}

TEST(SampleForms, DifferWhereLightDoes) {
    BallBeforeWall test;
    test.scene.materials[1].base_colour_texture.image = test.add_image(2, 1, {90, 90, 90, 255, 255, 255, 255, 255});
    std::vector<ReferencePicture> pictures;
    for (const ReferenceSamples& samples : every_form)
        if (samples.count == 4 && !samples.shadows_per_pixel)
            pictures.push_back(test.picture(samples));
    for (size_t a = 0; a < pictures.size(); ++a)
        for (size_t b = a + 1; b < pictures.size(); ++b)
            EXPECT_FALSE(pictures[a].linear.pixels == pictures[b].linear.pixels) << a << ", " << b;
}

TEST(SampleForms, OnceAFragmentAWallIsAsWithOneSample) {
    TestWorld test;
    test.add_material({.base_colour = {0.8f, 0.5f, 0.2f, 1}, .metallic = 0.3f, .roughness = 0.4f});
    test.add(wall_triangle());
    test.add_light({.intensity = 300}, {-7, 5, 4});
    for (const ProjectionKind kind : {ProjectionKind::perspective, ProjectionKind::orthographic}) {
        const PlacedCamera camera = metre_camera(kind);
        const auto one = render_reference(test.world, camera, columns, rows, 0, {});
        const auto all = sampled(test, camera, forward_samples);
        EXPECT_TRUE(all.linear.pixels == one.linear.pixels);
        EXPECT_TRUE(all.display(Tonemap::pbr_neutral).pixels == one.display(Tonemap::pbr_neutral).pixels);
    }
}

/// Half a wall, and before it the other half, and a light near them.
struct TwoWalls : TestWorld {
    explicit TwoWalls(double edge, bool second = true) {
        add_material({.base_colour = {0.8f, 0.5f, 0.2f, 1}, .metallic = 0.3f, .roughness = 0.4f});
        add(triangle(at_pixel(edge, -500), at_pixel(edge, 500), at_pixel(-900, 0)));
        if (second)
            add(triangle(at_pixel(edge, -500), at_pixel(edge, 500), at_pixel(900, 0)),
                glm::translate(glm::dmat4(1), {0, 0, 2}));
        add_light({.intensity = 300}, {-4, 2, 4});
    }
};

TEST(SampleForms, AnEdgesSurfacesAreLitAtTheMeanOfTheirSamples) {
    // Of pixel 6's samples 0 and 2 lie left of its middle.
    const TwoWalls walls(6.5), whole(12, false);
    const PlacedCamera camera = metre_camera(ProjectionKind::orthographic);
    for (const SampleRate material : {SampleRate::sample, SampleRate::fragment}) {
        const auto picture = sampled(walls, camera, {.count = 4, .light = SampleLight::edges, .material = material});
        const glm::dvec2 mean = (glm::dvec2(0.375, 0.125) + glm::dvec2(0.125, 0.625)) / 2.0;
        PlacedCamera moved = camera;
        moved.position += glm::dvec3(mean.x - 0.5, 0.5 - mean.y, 0);
        const auto left = render_reference(whole.world, moved, columns, rows, 0, {}).linear;
        const auto centre = render_reference(whole.world, camera, columns, rows, 0, {}).linear;
        for (uint32_t y = 0; y < rows; ++y)
            for (const uint32_t s : {0u, 2u}) {
                EXPECT_NEAR(picture.sample_colours[4 * (y * columns + 6) + s].r, left.at(6, y).r, 1e-6);
                EXPECT_GT(std::abs(left.at(6, y).r - centre.at(6, y).r), 1e-5);
                EXPECT_NEAR(picture.sample_colours[4 * (y * columns + 5) + s].r, centre.at(5, y).r, 1e-6);
            }
    }
}

TEST(SampleForms, EdgesAreThePixelOrTheSampleWithTwoOfThem) {
    for (const ProjectionKind kind : {ProjectionKind::perspective, ProjectionKind::orthographic}) {
        const TwoWalls walls(kind == ProjectionKind::perspective ? 7.08 : 6.5); // the nearer one is seen from 6.5 on
        const PlacedCamera camera = metre_camera(kind);
        const auto edges = sampled(walls, camera, {.count = 2, .light = SampleLight::edges});
        const auto pixel = sampled(walls, camera, {.count = 2, .light = SampleLight::pixel});
        const auto truth = sampled(walls, camera, {.count = 2});
        ASSERT_THAT(truth.edge, testing::Contains(1));
        for (size_t i = 0; i < edges.sample_colours.size(); ++i)
            EXPECT_EQ(edges.sample_colours[i], (truth.edge[i / 2] ? truth : pixel).sample_colours[i]) << i;
    }
}

TEST(SampleForms, LightIsAveragedBeforeTheMaterialMeetsIt) {
    // [phong] without a bent exponent is linear in the sums: one colour on a wall makes no difference.
    TestWorld test;
    Material material{.metallic = 0, .roughness = 0.5f};
    test.add_material(material);
    test.add(wall_triangle());
    test.add_light({.intensity = 60}, {-7, 5, 2});
    const PlacedCamera camera = metre_camera(ProjectionKind::orthographic);
    const ReferenceForm phong{.shading = Shading::phong};
    const ReferenceSamples fragment{.count = 4, .material = SampleRate::fragment};
    const auto truth = sampled(test, camera, {.count = 4}, phong);
    const auto once = sampled(test, camera, fragment, phong);
    for (size_t i = 0; i < truth.linear.pixels.size(); ++i) {
        EXPECT_NEAR(once.linear.pixels[i].g, truth.linear.pixels[i].g, 1e-6 + 1e-6 * truth.linear.pixels[i].g);
        for (size_t s = 1; s < 4; ++s)
            EXPECT_EQ(once.sample_colours[4 * i + s], once.sample_colours[4 * i]);
    }
    // An exponent on the sum is not linear.
    const ReferenceForm bent{
        .shading = Shading::phong, .mono_specular = true, .specular = ReferenceForm::Specular::luminance};
    EXPECT_FALSE(sampled(test, camera, {.count = 4}, bent).linear.pixels ==
                 sampled(test, camera, fragment, bent).linear.pixels);
}

TEST(SampleForms, MaterialsAreReadAtTheSampleOrAtTheCentre) {
    // A texture that changes from left to right, smoothly; no light matters. The centre's colour is that of one sample.
    TestWorld test;
    Material material{.unlit = true};
    material.base_colour_texture.image = test.add_image(2, 1, {0, 0, 0, 255, 255, 255, 255, 255});
    test.add_material(material);
    test.add(square(12));
    const PlacedCamera camera = metre_camera(ProjectionKind::orthographic);
    const auto one = render_reference(test.world, camera, columns, rows, 0, {});
    const auto truth = sampled(test, camera, {.count = 4});
    const auto once = sampled(test, camera, {.count = 4, .material = SampleRate::fragment});
    for (uint32_t y = 1; y < rows; ++y) {
        const size_t pixel = y * columns + 11, s = pixel * 4;
        EXPECT_NEAR(once.linear.pixels[pixel].r, one.linear.pixels[pixel].r, 1e-6);
        EXPECT_LT(truth.sample_colours[s + 2].r, truth.sample_colours[s + 0].r); // by where they lie
        EXPECT_LT(truth.sample_colours[s + 0].r, truth.sample_colours[s + 3].r);
        EXPECT_LT(truth.sample_colours[s + 3].r, truth.sample_colours[s + 1].r);
    }
}

TEST(SampleForms, LightOncePerPixelIsThatUnderTheCentreOfWhatItsSamplesShare) {
    const BallBeforeWall test;
    const ReferenceForm phong{.shading = Shading::phong};
    const auto one = render_reference(test.world, test.camera, columns, rows, 0, phong);
    const auto once = test.picture({.count = 4, .light = SampleLight::pixel}, phong);
    uint32_t edges = 0;
    for (size_t pixel = 0; pixel < columns * rows; ++pixel) {
        for (size_t s = 0; s < 4; ++s) {
            const float ours = once.sample_colours[4 * pixel + s].g;
            if (!once.edge[pixel] && once.instance[pixel] == 0) { // the wall, which is one triangle
                EXPECT_NEAR(ours, one.linear.pixels[pixel].g, 1e-6 + 1e-5 * ours);
            }
        }
        edges += once.edge[pixel];
    }
    EXPECT_GT(edges, 20u);
}

TEST(SampleForms, LightOncePerPixelIsThatOfTheFirstSampleWithASurface) {
    // The triangle's left edge runs between sample 0 and samples 1 and 3.
    TestWorld test;
    test.add_material({.base_colour = {1, 1, 1, 1}, .metallic = 0, .roughness = 1});
    test.add(triangle(at_pixel(6.5, -500), at_pixel(6.5, 500), at_pixel(900, 0)));
    test.add_light({.kind = LightKind::directional}, {});
    const PlacedCamera camera = metre_camera(ProjectionKind::orthographic);
    const auto truth = sampled(test, camera, {.count = 4});
    const auto once = sampled(test, camera, {.count = 4, .light = SampleLight::pixel});
    EXPECT_FLOAT_EQ(once.linear.at(6, 5).r, truth.linear.at(9, 5).r / 2);
    EXPECT_EQ(once.linear.at(9, 5), truth.linear.at(9, 5));
}

TEST(SampleForms, ShadowsOncePerPixelAreThoseOfItsOnePlace) {
    TestWorld test;
    test.add_material({.metallic = 0});
    test.add(wall_triangle());
    // Behind the camera: its shadow's left border is upright, at 6.55 pixels.
    Primitive blocker = triangle(at_pixel(6.55, -500), at_pixel(6.55, 500), at_pixel(900, 0));
    test.add(blocker, glm::translate(glm::dmat4(1), {0, 0, 20}));
    test.add_light({.kind = LightKind::directional}, {});
    const PlacedCamera camera = metre_camera(ProjectionKind::orthographic);
    const ReferenceForm shadows{.shadows = true};
    const auto each = sampled(test, camera, {.count = 4}, shadows);
    const auto zero = sampled(test, camera, {.count = 4, .shadows_per_pixel = true}, shadows);
    const float lit = each.linear.at(2, 5).r;
    EXPECT_GT(lit, 0);
    EXPECT_FLOAT_EQ(each.linear.at(6, 5).r, lit / 2);
    EXPECT_EQ(zero.linear.at(6, 5).r, lit); // the centre lies at 6.5
    EXPECT_EQ(zero.linear.at(7, 5).r, 0);
    EXPECT_THAT(zero.edge, testing::Each(0)) << "a shadow is no edge";
}

TEST(SampleForms, ALightBehindThePixelsPlaceHasNoShadowThere) {
    // Before a wall a card that ends within pixels, and between them a lamp: the card turns away from it.
    TestWorld test;
    test.add_material({.metallic = 0});
    test.add(wall_triangle());
    test.add(triangle(at_pixel(6.55, -500), at_pixel(6.55, 500), at_pixel(-900, 0)),
             glm::translate(glm::dmat4(1), {0, 0, 4}));
    test.add_light({.kind = LightKind::point, .intensity = 5}, glm::dvec3(at_pixel(6.5, 5.5)) + glm::dvec3(0, 0, 2));
    const PlacedCamera camera = metre_camera(ProjectionKind::orthographic);
    const ReferenceForm shadows{.shadows = true};
    const auto each = sampled(test, camera, {.count = 4}, shadows);
    const auto once = sampled(test, camera, {.count = 4, .shadows_per_pixel = true}, shadows);
    const size_t first = (size_t(5) * columns + 6) * 4;
    EXPECT_EQ(each.sample_colours[first].r, 0);
    EXPECT_GT(each.sample_colours[first + 1].r, 0);
    EXPECT_EQ(once.sample_colours, each.sample_colours);
}

TEST(SampleForms, AmbientOcclusionGoesWithTheLights) {
    // A wall stands on another one, beyond the picture's right border, and takes ambient light away before it.
    TestWorld test;
    test.add_material({.metallic = 0});
    test.add(wall_triangle());
    Primitive standing = square(40);
    for (glm::vec3& position : standing.positions)
        position = {13, position.y, position.x};
    test.add(standing);
    test.world.ambient = glm::vec3(1);
    const PlacedCamera camera = metre_camera(ProjectionKind::orthographic);
    const ReferenceForm occluded{.occlusion_radius = 8};
    const auto of = [&](const ReferenceSamples& samples) { return sampled(test, camera, samples, occluded); };
    const auto truth = of({.count = 4}), zero = of({.count = 4, .light = SampleLight::pixel}),
               mean = of({.count = 4, .material = SampleRate::fragment}), centre = of(forward_samples);
    const auto one = render_reference(test.world, camera, columns, rows, 0, occluded);
    bool differs = false;
    for (size_t pixel = 0; pixel < truth.linear.pixels.size(); ++pixel) {
        differs = differs || truth.sample_colours[4 * pixel + 1] != truth.sample_colours[4 * pixel];
        for (size_t s = 0; s < 4; ++s)
            EXPECT_NEAR(zero.sample_colours[4 * pixel + s].r, one.linear.pixels[pixel].r, 1e-6);
        EXPECT_NEAR(mean.linear.pixels[pixel].r, truth.linear.pixels[pixel].r, 1e-6);
        EXPECT_EQ(centre.linear.pixels[pixel], one.linear.pixels[pixel]);
    }
    EXPECT_TRUE(differs);
}

TEST(SampleForms, AlphaTestsAreEachSamplesOwnWhateverTheGeometry) {
    TestWorld test;
    Material masked{.alpha_mode = AlphaMode::mask, .unlit = true};
    masked.base_colour_texture.image = test.add_image(2, 1, {255, 255, 255, 255, 255, 255, 255, 0});
    masked.base_colour_texture.sampler = {.wrap_s = Wrap::clamp_to_edge};
    test.add_material(masked);
    // Of the square's 20 pixels the left half is there, up to 12.25 pixels.
    test.add(square(10), glm::translate(glm::dmat4(1), glm::dvec3(0.25, 0, 0)));
    const PlacedCamera camera = metre_camera(ProjectionKind::orthographic);
    const auto each = sampled(test, camera, {.count = 4});
    const auto once = sampled(test, camera, {.count = 4, .geometry = SampleRate::fragment});
    EXPECT_EQ(each.linear.at(11, 5).r, 1);
    EXPECT_EQ(each.linear.at(12, 5).r, 0.25f);
    EXPECT_EQ(once.linear.at(11, 5).r, 1);
    EXPECT_EQ(once.linear.at(12, 5).r, 0.25f);
}

TEST(SampleForms, AHorizonUnderThePixelsCentreIsSaid) {
    // The ground runs to the horizon through the centres of row 4: two of their samples see it, the centres never do.
    TestWorld test;
    test.add_material({.metallic = 0});
    Primitive ground;
    ground.positions = {{-1e6f, 0, 100}, {1e6f, 0, 100}, {0, 0, -1e7f}};
    ground.normals.assign(3, {0, 1, 0});
    ground.indices = {0, 1, 2};
    test.add(ground);
    test.add_light({.kind = LightKind::directional}, {}, {0, -1, 0});
    const PlacedCamera camera = look_at(Camera{.zfar = std::numeric_limits<float>::infinity()}, {0, 1, 0}, {0, 1, -5});
    const auto truth = sampled(test, camera, {.count = 4}, {}, 8, 9);
    const auto once = sampled(test, camera, forward_samples, {}, 8, 9);
    for (uint32_t x = 0; x < 8; ++x) {
        EXPECT_TRUE(once.doubts[4 * 8 + x] & ReferencePicture::extrapolated);
        EXPECT_FALSE(truth.doubts[4 * 8 + x] & ReferencePicture::extrapolated);
        EXPECT_NEAR(once.linear.at(x, 4).r, truth.linear.at(x, 4).r, 1e-4);
        EXPECT_FALSE(once.doubts[5 * 8 + x]);
    }
}

} // namespace
} // namespace prelight
