// Textures that are larger than the device takes are drawn at a size that it takes, and a line says so.
#include "against_reference.hpp"
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(LargeTextures, AreScaledDownToTheDevicesLimit) {
    Scene scene = make_scene("spheres", 1, 1);
    TextureImage strip{"strip", 40'000, 8, std::vector<uint8_t>(40'000 * 8 * 4, 188)};
    scene.images.push_back(strip);
    strip.name = "unused";
    scene.images.push_back(strip);
    for (Material& material : scene.materials)
        material.base_colour_texture.image = material.normal_texture.image = 0;
    for (Mesh& mesh : scene.meshes)
        for (Primitive& primitive : mesh.primitives) {
            primitive.texcoords[0].assign(primitive.positions.size(), glm::vec2(0.5f));
            primitive.tangents.assign(primitive.positions.size(), glm::vec4(1, 0, 0, 1));
        }
    const World world = resolve(scene);
    RenderOptions options;
    options.width = options.height = 32;
    const auto renderer = create_renderer("light-prepass", &test_device(), options);
    renderer->set_world(world);
    renderer->render(world.cameras.at(0), 1);
    const std::vector<std::string> notes = renderer->stats().notes;
    ASSERT_THAT(notes, ElementsAre(HasSubstr("image 0 (strip): scaled down from 40000 × 8 to ")));
    // Lavapipe takes 16,384 a side: a quarter. Others say otherwise.
    EXPECT_THAT(notes[0], HasSubstr("pixels: the device takes "));
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
