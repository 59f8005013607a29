// Several samples a pixel, against the reference in the renderer's own form: edge pixels are part of the bound.
#include "garden.hpp"
#include <fmt/format.h>
#include <prelight/error.hpp>

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
    shot.width = 640;
    shot.height = 360;
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

size_t edges_of(const ReferencePicture& reference) {
    const std::vector<uint8_t> out = reference.left_out();
    size_t edges = 0;
    for (size_t i = 0; i < out.size(); ++i)
        edges += reference.edge[i] && !out[i];
    return edges;
}

TEST_P(Samples, AgreeWithTheReferenceOnEdgesToo) {
    Garden garden;
    garden.add_lights(24, 4, 6);
    const Shot shot = sampled(garden, GetParam());
    const ReferencePicture reference =
        render_reference(*shot.world, shot.camera, shot.width, shot.height, shot.exposure, form_of(shot));
    const Image picture = render_linear(test_device(), shot);
    save_when_wanted(picture, reference);
    expect_within(compare(picture, reference.linear, reference.left_out()), half_float_bound);
    // Edge pixels by themselves, which a picture has few of.
    std::vector<uint8_t> others = reference.left_out();
    for (size_t i = 0; i < others.size(); ++i)
        others[i] = others[i] || !reference.edge[i];
    const Comparison edges = compare(picture, reference.linear, others);
    fmt::print("    {} edge pixels, {:.1f} dB there\n", edges_of(reference), edges.psnr);
    EXPECT_GE(edges_of(reference), 1000u);
    EXPECT_GE(edges.psnr, 50);
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

TEST(SamplesOf, AWallAreTheOneSamplePictureBitForBit) {
    TestWorld wall;
    wall.add(square(40));
    wall.add_light({.kind = LightKind::point, .intensity = 40, .range = 10}, {0.3, 0.2, 2});
    for (const std::string& renderer : device_renderers) {
        Shot shot{.world = &wall.world, .camera = front_camera(5), .renderer = renderer};
        const Image one = view_of(shot, "final");
        shot.samples = 4;
        EXPECT_EQ(view_of(shot, "final").pixels, one.pixels) << renderer;
    }
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
