// A world without triangles is an empty picture in every renderer.
#include "against_reference.hpp"
#include <reference/worlds.hpp>

namespace prelight {
namespace {

/// Lights and a camera, and nothing that they could show.
struct EmptyWorld : TestWorld {
    EmptyWorld() {
        add_material(); // as the reader gives every scene one
        add_light({.kind = LightKind::point, .intensity = 5, .range = 9}, {1, 1, 1});
        add_light({.kind = LightKind::directional}, {0, 0, 0}, {0, -1, 0});
        add_light({.kind = LightKind::spot, .intensity = 5}, {0, 2, 0}, {0, -1, 0});
    }
    Shot shot(const char* renderer) const {
        return {.world = &world, .camera = front_camera(3), .width = 64, .height = 36, .renderer = renderer};
    }
};

TEST(EmptyWorld, IsBlackInEveryRenderer) {
    const EmptyWorld empty;
    for (const RendererInfo& info : renderer_infos()) {
        SCOPED_TRACE(info.name);
        const Image picture = info.needs_device ? render_linear(test_device(), empty.shot(info.name.c_str()))
                                                : render_reference(empty.world, front_camera(3), 64, 36, 0,
                                                                   form_of(empty.shot("light-prepass")))
                                                      .linear;
        for (const glm::vec3& pixel : picture.pixels)
            ASSERT_EQ(pixel, glm::vec3(0));
    }
    expect_validation_clean(test_device());
}

TEST(EmptyWorld, InEveryWayToFindLightsAndWithShadows) {
    const EmptyWorld empty;
    for (const char* culling : {"fullscreen", "rectangles", "volumes", "stencil", "tiles", "clusters"})
        for (const char* renderer : {"light-prepass", "deferred"}) {
            SCOPED_TRACE(culling);
            Shot shot = empty.shot(renderer);
            shot.settings = {{"light-culling", culling}, {"shadows", "on"}, {"shadow-budget", "1048576"}};
            EXPECT_EQ(render_linear(test_device(), shot).at(32, 18), glm::vec3(0));
        }
    for (const char* renderer : {"z-prepass", "multipass"}) {
        Shot shot = empty.shot(renderer);
        shot.settings = {{"shadows", "on"}, {"shadow-budget", "1048576"}};
        EXPECT_EQ(render_linear(test_device(), shot).at(32, 18), glm::vec3(0));
    }
    expect_validation_clean(test_device());
}

TEST(EmptyWorld, ShowsItsEnvironment) {
    EmptyWorld empty;
    auto sky = std::make_shared<Environment>(Environment{.name = "sky", .image = Image(32, 16)});
    for (glm::vec3& pixel : sky->image.pixels)
        pixel = {0.25f, 0.5f, 1};
    empty.scene.environment = sky;
    for (const char* renderer : {"light-prepass", "deferred", "z-prepass", "multipass"}) {
        SCOPED_TRACE(renderer);
        const glm::vec3 middle = render_linear(test_device(), empty.shot(renderer)).at(32, 18);
        EXPECT_NEAR(middle.r, 0.25, 0.01);
        EXPECT_NEAR(middle.b, 1, 0.01);
    }
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
