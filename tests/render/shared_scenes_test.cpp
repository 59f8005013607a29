// The real scenes beside the repository, when they are there: every one renders without a message of
// validation, and Sponza with a thousand lights agrees with the reference.
#include "against_reference.hpp"
#include <filesystem>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

const std::filesystem::path shared_folder = PRELIGHT_SHARED_SCENES;

TEST(SharedScenes, AllRenderWithoutAValidationMessage) {
    if (!std::filesystem::exists(shared_folder))
        GTEST_SKIP() << "no shared scenes beside the repository";
    size_t rendered = 0;
    for (const auto& entry : std::filesystem::directory_iterator(shared_folder)) {
        if (entry.path().extension() != ".glb")
            continue;
        SCOPED_TRACE(entry.path().filename());
        const Scene scene = load_gltf(entry.path());
        const World world = resolve(scene);
        const auto renderer =
            create_renderer("light-prepass", &test_device(),
                            {.width = 160, .height = 90, .shading = rendered % 2 ? Shading::phong : Shading::ggx});
        renderer->set_world(world);
        for (const PlacedCamera& camera : world.cameras) {
            renderer->render(camera);
            const Image image = renderer->read("final");
            EXPECT_TRUE(std::any_of(image.pixels.begin(), image.pixels.end(),
                                    [](const glm::vec3& p) { return p.x + p.y + p.z > 0.1f; }))
                << "camera " << camera.camera.name << " sees black";
        }
        expect_validation_clean(test_device());
        ++rendered;
    }
    EXPECT_GE(rendered, 25u);
}

TEST(SharedScenes, SponzaWithAThousandLightsAgreesWithTheReference) {
    if (!std::filesystem::exists(shared_folder / "sponza-512.glb"))
        GTEST_SKIP() << "no shared scenes beside the repository";
    const Scene scene = load_gltf(shared_folder / "sponza-512.glb");
    World world = resolve(scene);
    scatter_lights(world, 1024, 1);
    Camera lens;
    lens.yfov = 0.9;
    // Two views with little fine geometry in the distance: too many pixels beside edges do not count.
    for (const auto& [eye, target] : {std::pair(glm::dvec3(-8.5, 1.7, 0), glm::dvec3(-6, 4, 4)),
                                      std::pair(glm::dvec3(-2, 2, 0), glm::dvec3(0, 0, -0.3))})
        expect_agrees(
            {.world = &world, .camera = look_at(lens, eye, target), .width = 1280, .height = 720, .exposure = -1});
}

} // namespace
} // namespace prelight
