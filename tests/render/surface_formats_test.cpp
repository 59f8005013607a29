// Every way to store depth and normals and to fill them, against the reference.
#include "sensitivity.hpp"

namespace prelight {
namespace {

struct LitGarden : Garden {
    LitGarden() { add_lights(12, 4, 6); }
};

std::vector<const char*> encodings() {
    std::vector<const char*> names;
    for (const passes::NormalEncodingInfo& info : passes::normal_encodings())
        names.push_back(info.name);
    return names;
}

/// Encodings whose largest error is below 0.1° keep the half-float bound; the others what their error
/// allows.
class NormalEncodings : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(NormalEncodings, AgreeWithTheReference) {
    const auto& [normals, space] = GetParam();
    LitGarden garden;
    Shot shot = garden.shot();
    shot.settings = {{"normals", normals}, {"normal-space", space}};
    const double degrees = largest_angle(passes::find_normal_encoding(normals));
    Bound bound;
    if (degrees > 0.1)
        bound = bound_for_normals(garden, shot, degrees);
    std::printf("    largest error %.4f°, bound %.1f dB\n", degrees, bound.psnr);
    EXPECT_GT(bound.psnr, 30) << "a bound that says nothing";
    expect_agrees(shot, bound);
}
INSTANTIATE_TEST_SUITE_P(All, NormalEncodings,
                         testing::Combine(testing::ValuesIn(encodings()), testing::Values("world", "view")));

// What the light pass reads, at every pixel, from behind the spheres and with a wide lens: normals with
// negative Z are visible in world space, and at the picture's edges in view space too. None may be
// flipped, at poles, seams and silhouettes.
TEST_P(NormalEncodings, ViewShowsTheReferencesNormals) {
    const auto& [normals, space] = GetParam();
    LitGarden garden;
    garden.camera.camera.yfov = 1.7;
    garden.camera = look_at(garden.camera.camera, {0, 1.2, -3.2}, {0, 0.8, 0});
    const ReferencePicture reference = render_reference(garden.world, garden.camera, 320, 180, 0, {});
    const std::vector<uint8_t> left_out = reference.left_out();
    RenderOptions options{
        .width = 320, .height = 180, .settings = {{"normals", normals}, {"normal-space", space}}, .views = {"normal"}};
    const auto renderer = create_renderer("light-prepass", &test_device(), options);
    renderer->set_world(garden.world);
    renderer->render(garden.camera);
    const Image view = renderer->read("normal");
    double worst = 0;
    int behind = 0;
    for (size_t i = 0; i < view.pixels.size(); ++i) {
        if (left_out[i] || reference.instance[i] == 0xffffffffu)
            continue;
        const glm::dvec3 n = reference.normal[i];
        worst = std::max(worst, glm::length(glm::dvec3(view.pixels[i]) * 2.0 - 1.0 - n));
        behind += (std::string_view(space) == "view" ? glm::dot(n, garden.camera.axes[2]) : n.z) < -0.1;
    }
    EXPECT_GT(behind, 100);
    const double degrees = largest_angle(passes::find_normal_encoding(normals));
    ASSERT_LT(degrees, 1) << "no bound at all";
    EXPECT_LT(worst, 2.0 / 127 + glm::radians(degrees)); // the view itself has eight bits
    expect_validation_clean(test_device());
}

enum class Lens { perspective, infinite_far, orthographic };
void PrintTo(Lens lens, std::ostream* out) {
    *out << (lens == Lens::perspective ? "perspective" : lens == Lens::infinite_far ? "infinite_far" : "orthographic");
}

struct LensGarden : LitGarden {
    explicit LensGarden(Lens lens) {
        Camera& c = camera.camera;
        if (lens != Lens::infinite_far)
            c.zfar = 30;
        if (lens == Lens::orthographic) {
            c.kind = ProjectionKind::orthographic;
            c.ymag = 3.5;
        }
    }
};

class DepthForms : public testing::TestWithParam<std::tuple<const char*, const char*, Lens>> {};

TEST_P(DepthForms, AgreesWithTheReference) {
    const auto& [depth, position, lens] = GetParam();
    LensGarden garden(lens);
    Shot shot = garden.shot();
    shot.settings = {{"depth", depth}, {"position", position}};
    Bound bound;
    // A half float has 11 bits: cut off, a depth is short by 2⁻¹⁰ of itself at most.
    if (std::string_view(depth) == "r16f") {
        bound = bound_for_depth(garden, shot, std::exp2(-10));
        std::printf("    bound %.1f dB\n", bound.psnr);
        EXPECT_GT(bound.psnr, 30) << "a bound that says nothing";
    }
    expect_agrees(shot, bound);
}
INSTANTIATE_TEST_SUITE_P(All, DepthForms,
                         testing::Combine(testing::Values("attachment", "r32f", "r16f", "rgba8"),
                                          testing::Values("ray", "matrix"),
                                          testing::Values(Lens::perspective, Lens::infinite_far, Lens::orthographic)));

TEST(PackedDepth, LosesNothingAgainstR32F) {
    for (const Lens lens : {Lens::perspective, Lens::infinite_far, Lens::orthographic}) {
        LensGarden garden(lens);
        Shot shot = garden.shot();
        shot.settings = {{"depth", "r32f"}};
        const Image r32f = render_linear(test_device(), shot);
        shot.settings = {{"depth", "rgba8"}};
        EXPECT_TRUE(render_linear(test_device(), shot).pixels == r32f.pixels) << testing::PrintToString(lens);
        shot.settings = {{"depth", "r16f"}};
        EXPECT_FALSE(render_linear(test_device(), shot).pixels == r32f.pixels) << "the settings do nothing";
    }
}

TEST(HalfFloatDepth, BeyondTheLargestHalfIsStillFinite) {
    Garden garden(glm::dvec3(0));
    garden.add_light({.kind = LightKind::directional, .intensity = 2}, {0, 0, 0}, {0.4, -1, -0.6});
    // A floor of 1,200 km seen from 100 km above it.
    garden.world.instances[0].transform = glm::scale(garden.world.instances[0].transform, glm::dvec3(1e5));
    garden.camera = look_at(garden.camera.camera, {0, 1e5, 1e5}, {0, 0, 0});
    Shot shot = garden.shot();
    shot.settings = {{"depth", "r16f"}};
    expect_agrees(shot, {.psnr = 40, .off_share = 1, .block = 255});
}

// The same bytes, whatever is stored, with alpha masks and without.
TEST(TwoGeometryPasses, EqualMrtByteForByte) {
    const LitGarden garden;
    const MixedMaterials mixed;
    for (const Shot& whole : {garden.shot(), mixed.shot()})
        for (const auto& [normals, depth] :
             {std::pair("oct24", "attachment"), {"spherical", "r32f"}, {"oct32", "attachment"}, {"xy16f", "rgba8"}}) {
            SCOPED_TRACE(testing::Message() << normals << ", " << depth);
            Shot shot = whole;
            shot.width = 160;
            shot.height = 90;
            shot.settings = {{"normals", normals}, {"depth", depth}, {"light-culling", "volumes"}};
            std::vector<Image> images[2];
            for (const bool two : {false, true}) {
                shot.settings["geometry"] = two ? "two-passes" : "mrt";
                RenderOptions options = options_of(shot);
                options.views = {"depth", "normal", "roughness", "linear"};
                const auto renderer = create_renderer("light-prepass", &test_device(), options);
                renderer->set_world(*shot.world);
                renderer->render(shot.camera);
                for (const char* view : {"linear", "depth", "normal", "roughness"})
                    images[two].push_back(renderer->read(view));
                std::vector<std::string> passes;
                for (const PassStats& pass : renderer->stats().passes)
                    passes.push_back(pass.name);
                EXPECT_EQ(passes[0], two ? "depth" : "depth-normal");
                EXPECT_EQ(passes[1], two ? "normal" : "light");
            }
            for (size_t i = 0; i < images[0].size(); ++i)
                EXPECT_TRUE(images[0][i].pixels == images[1][i].pixels) << "image " << i;
        }
    expect_validation_clean(test_device());
}

TEST(TwoGeometryPasses, AgreeWithTheReference) {
    const LitGarden garden;
    Shot shot = garden.shot();
    shot.settings = {{"geometry", "two-passes"}, {"depth", "r32f"}, {"normals", "oct32"}};
    expect_agrees(shot);
}

} // namespace
} // namespace prelight
