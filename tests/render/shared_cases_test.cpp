// The small files beside the repository that were wrong once: each gives its right value, which is the same scene
// written plainly or a number that can be worked out. Samplers, masks and normal maps among them have tests of their
// own.
#include "against_reference.hpp"
#include <filesystem>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

class SharedCases : public testing::Test {
protected:
    const std::filesystem::path folder = std::filesystem::path(PRELIGHT_SHARED_SCENES) / ".." / "cases";
    void SetUp() override {
        if (!std::filesystem::exists(folder))
            GTEST_SKIP() << "no cases beside the repository";
    }
    Image draw(const std::string& name, const std::string& renderer,
               const std::map<std::string, std::string>& settings = {}, uint32_t size = 160) const {
        const Scene scene = load_gltf(folder / name);
        const World world = resolve(scene);
        Shot shot{.world = &world, .camera = world.cameras.at(0), .width = size, .height = size, .renderer = renderer};
        shot.settings = settings;
        return render_linear(test_device(), shot);
    }
};

TEST_F(SharedCases, AreTheirPlainForms) {
    size_t pairs = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string right = entry.path().filename().string();
        if (!right.ends_with("_right.glb"))
            continue;
        const std::string given = right.substr(0, right.size() - 10) + ".glb";
        // A JPEG's colours are near those of the plain picture, most of all beside their edges.
        const double least = given.starts_with("jpeg") ? 45 : 60;
        for (const std::string& renderer : device_renderers) {
            SCOPED_TRACE(given + ", " + renderer);
            const Image a = draw(given, renderer), b = draw(right, renderer);
            EXPECT_GE(compare_pixels(a, b, std::vector<uint8_t>(a.pixels.size())).psnr, least);
        }
        ++pairs;
    }
    EXPECT_GE(pairs, 8u);
    expect_validation_clean(test_device());
}

TEST_F(SharedCases, ThousandsOfLightsAddUpInEveryWay) {
    for (const auto& [renderer, culling] :
         std::initializer_list<std::pair<const char*, const char*>>{{"light-prepass", "volumes"},
                                                                    {"light-prepass", "clusters"},
                                                                    {"deferred", "volumes"},
                                                                    {"deferred", "tiles"}}) {
        SCOPED_TRACE(std::string(renderer) + " " + culling);
        const Image many = draw("stack_3000.glb", renderer, {{"light-culling", culling}}, 64);
        const Image one = draw("stack_3000_right.glb", renderer, {{"light-culling", culling}}, 64);
        EXPECT_GE(compare_pixels(many, one, std::vector<uint8_t>(many.pixels.size())).psnr, 60);
    }
}

TEST_F(SharedCases, InksAreTurnedIntoColours) {
    const Image image = draw("jpeg_cmyk_no_adobe.glb", "light-prepass");
    const Image right = draw("jpeg_cmyk_no_adobe_right.glb", "light-prepass");
    for (const glm::uvec2& at : {glm::uvec2(50, 50), glm::uvec2(110, 50), glm::uvec2(50, 110), glm::uvec2(110, 110)})
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(image.at(at.x, at.y)[c], right.at(at.x, at.y)[c], 0.02) << at.x << ", " << at.y;
}

TEST_F(SharedCases, AHardEdgedSpotIsAsBrightAsItSays) {
    const Image image = draw("spot_equal_cones.glb", "light-prepass");
    EXPECT_NEAR(image.at(80, 80).r, 1.10059, 0.01);
    EXPECT_EQ(image.at(2, 2), glm::vec3(0));
}

struct Fault {
    const char* file;
    const char* object; ///< that the warning names
};

TEST_F(SharedCases, OneFaultCostsOneWarningAndNotThePicture) {
    for (const Fault& fault : std::initializer_list<Fault>{{"anim_duplicate_times.glb", "animation 0 sampler 0"},
                                                           {"colour_u16_unnormalised.glb", "COLOR_0"},
                                                           {"light_type_ambient.glb", "light 0"},
                                                           {"missing_texture.gltf", "image 0"},
                                                           {"nan_normal.glb", "NORMAL"},
                                                           {"percent/encoded_on_disk.gltf", "image 0"},
                                                           {"percent/percent_raw_buffer.gltf", "buffer 0"},
                                                           {"range_zero.glb", "light 0"},
                                                           {"spot_equal_cones.glb", "light 0"}}) {
        SCOPED_TRACE(fault.file);
        const Scene scene = load_gltf(folder / fault.file);
        ASSERT_EQ(scene.warnings.size(), 1u);
        EXPECT_THAT(scene.warnings[0], testing::HasSubstr(fault.object));
        EXPECT_THROW(load_gltf(folder / fault.file, {.strict = true}), Error);
        const Image image = draw(fault.file, "light-prepass");
        EXPECT_TRUE(
            std::any_of(image.pixels.begin(), image.pixels.end(), [](const glm::vec3& p) { return p.g > 0.02f; }));
    }
    EXPECT_THROW(load_gltf(folder / "fuzz_find.glb"), Error);
}

TEST_F(SharedCases, TwoKeysAtOneTimeAreAJump) {
    const Scene scene = load_gltf(folder / "anim_duplicate_times.glb");
    const auto box_at = [&](double time) {
        return resolve(scene, {}, Moment{.time = time}).instances.at(1).transform[3].x;
    };
    EXPECT_NEAR(box_at(0.5), -0.5, 1e-6);
    EXPECT_NEAR(box_at(1.5), 1, 1e-6);
}

TEST_F(SharedCases, SpecularGlossinessAndNodeVisibilityAreRead) {
    const glm::vec3 red = draw("specgloss.glb", "light-prepass").at(80, 80);
    EXPECT_GT(red.r, 4 * red.g) << "diffuse colour 0.8, 0.1, 0.1";
    const glm::vec3 grey = draw("visibility.glb", "light-prepass").at(80, 80);
    EXPECT_GT(grey.g, 0.1f);
    EXPECT_NEAR(grey.r, grey.g, 0.01) << "the red square above it is not visible";
}

} // namespace
} // namespace prelight
