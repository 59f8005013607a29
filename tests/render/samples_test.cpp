// Several samples a pixel, against the reference in the renderer's own form: edge pixels are part of the bound.
#include "garden.hpp"
#include <prelight/error.hpp>
#include <prelight/scene.hpp>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

struct Sampled {
    const char* name;
    std::string renderer;
    std::map<std::string, std::string> settings;
    bool orthographic = false;
};
void PrintTo(const Sampled& one, std::ostream* out) { *out << one.name; }

class Samples : public testing::TestWithParam<Sampled> {};

Shot sampled(const Garden& garden, const Sampled& one) {
    Shot shot = garden.shot();
    shot.width = 384;
    shot.height = 216;
    shot.samples = 4;
    shot.renderer = one.renderer;
    shot.settings = one.settings;
    if (one.orthographic) {
        shot.camera.camera.kind = ProjectionKind::orthographic;
        shot.camera.camera.ymag = 3;
        shot.camera.camera.zfar = 40;
    }
    return shot;
}

TEST_P(Samples, AgreeWithTheReferenceOnEdgesToo) {
    Garden garden;
    garden.add_lights(24, 4, 6);
    const Shot shot = sampled(garden, GetParam());
    static References straight, parallel; // the same world for all: fewer forms than ways
    const ReferencePicture& reference = (GetParam().orthographic ? parallel : straight).of(shot);
    const Image picture = render_linear(test_device(), shot);
    save_when_wanted(picture, reference);
    expect_within_on_edges(picture, reference, half_float_bound, {.pixels = 700});
    expect_validation_clean(test_device());
}

INSTANTIATE_TEST_SUITE_P(
    All, Samples,
    testing::Values(Sampled{"Edges", "light-prepass", {}}, Sampled{"EdgesOrtho", "light-prepass", {}, true},
                    Sampled{"EdgesSample", "light-prepass", {{"msaa-material", "sample"}}},
                    Sampled{"EdgesPhongPacked", "light-prepass", {{"light-buffer", "packed-rgba16f"}}},
                    Sampled{"EdgesClusters", "light-prepass", {{"light-culling", "clusters"}}},
                    Sampled{"EdgesVolumes", "light-prepass", {{"light-culling", "volumes"}}},
                    Sampled{"EdgesStencil", "light-prepass", {{"light-culling", "stencil"}}},
                    Sampled{"EdgesRectangles", "light-prepass", {{"light-culling", "rectangles"}}},
                    Sampled{"EdgesFragmentWalk", "light-prepass", {{"list-shading", "fragment"}}},
                    Sampled{"EdgesTwoPasses", "light-prepass", {{"geometry", "two-passes"}}},
                    Sampled{"EdgesRoughnessApart", "light-prepass", {{"normals", "oct32"}}},
                    Sampled{"Everywhere", "light-prepass", {{"msaa-light", "samples"}}},
                    Sampled{
                        "EverywhereSample", "light-prepass", {{"msaa-light", "samples"}, {"msaa-material", "sample"}}},
                    Sampled{"Pixel", "light-prepass", {{"msaa-light", "pixel"}}},
                    Sampled{"PixelSample", "light-prepass", {{"msaa-light", "pixel"}, {"msaa-material", "sample"}}},
                    Sampled{"Deferred", "deferred", {}}, Sampled{"DeferredOrtho", "deferred", {}, true},
                    Sampled{"DeferredSamples", "deferred", {{"msaa-light", "samples"}}},
                    Sampled{"DeferredVolumes", "deferred", {{"light-culling", "volumes"}}},
                    Sampled{"DeferredFragmentWalk", "deferred", {{"list-shading", "fragment"}}},
                    Sampled{"ZPrepass", "z-prepass", {}}, Sampled{"ZPrepassOrtho", "z-prepass", {}, true},
                    Sampled{"ZPrepassGrid", "z-prepass", {{"lights", "grid"}}},
                    // lavapipe (Mesa 22.3) interpolates to a sample, but divides by w at the pixel's centre.
                    Sampled{"ZPrepassSampleOrtho", "z-prepass", {{"msaa-material", "sample"}}, true},
                    Sampled{"Multipass", "multipass", {}},
                    Sampled{"MultipassSampleOrtho", "multipass", {{"msaa-material", "sample"}}, true}),
    [](const auto& one) { return std::string(one.param.name); });

/// A wall that fills the picture, square to the camera: no pixel of it is an edge.
TEST(SamplesOf, AWallAreTheOneSamplePictureBitForBit) {
    TestWorld wall;
    wall.add(square(40));
    wall.add_light({.kind = LightKind::point, .intensity = 40, .range = 10}, {0.3, 0.2, 2});
    for (const RendererInfo& info : renderer_infos()) {
        if (!info.needs_device || info.name == "inferred") // which has one sample a pixel
            continue;
        Shot shot{.world = &wall.world, .camera = front_camera(5), .width = 96, .height = 54, .renderer = info.name};
        const Image one = view_of(shot, "final"), linear = view_of(shot, "linear");
        shot.samples = 4;
        EXPECT_EQ(view_of(shot, "final").pixels, one.pixels) << info.name;
        for (const SettingInfo& setting : info.settings)
            for (const std::string& value : setting.values)
                if (setting.key == "msaa-light") {
                    shot.settings = {{setting.key, value}};
                    if (value != "samples") { // those lie where samples lie, and not at the pixel's centre
                        EXPECT_EQ(view_of(shot, "final").pixels, one.pixels) << info.name << " " << value;
                        EXPECT_EQ(view_of(shot, "linear").pixels, linear.pixels) << info.name << " " << value;
                    }
                }
    }
    expect_validation_clean(test_device());
}

/// Light of headlamps ends within a pixel, on surfaces that are no edges: what is lit once there, and what is not.
TEST(SamplesOf, ACityAreLitAsTheReferenceTellsItsSurfacesApart) {
    const Scene scene = make_scene("city", 128, 1);
    const World world = resolve(scene);
    for (const char* renderer : {"light-prepass", "deferred"}) {
        const Shot shot{.world = &world,
                        .camera = world.cameras[0],
                        .width = 240,
                        .height = 136,
                        .renderer = renderer,
                        .samples = 4};
        References references;
        const Image picture = render_linear(test_device(), shot);
        save_when_wanted(picture, references.of(shot));
        // Much of a small picture is thinner than a pixel.
        expect_within_on_edges(picture, references.of(shot), {.off_share = 0.002, .left_out = 0.4});
    }
    expect_validation_clean(test_device());
}

TEST(SamplesOf, APixelAreOneTwoOrFour) {
    RenderOptions options;
    options.msaa = 3;
    EXPECT_THROW(create_renderer("z-prepass", &test_device(), options), UsageError);
    options.msaa = 8;
    EXPECT_THROW(create_renderer("z-prepass", &test_device(), options), UsageError);
}

} // namespace
} // namespace prelight
