// A light per particle, in pictures.
#include "against_reference.hpp"
#include <prelight/scene_io.hpp>
#include <scene/procedural/builder.hpp>
#include <scene/procedural/shapes.hpp>

namespace prelight {
namespace {

/// Two fountains over a floor with a ball on it.
struct Fountains {
    Scene scene;
    Fountains() {
        scene.name = "fountains";
        scene.scenes = {{.name = "fountains", .nodes = {}}};
        scene.ambient = glm::vec3(0.03f);
        scene.materials = {{.name = "floor", .base_colour = {0.6f, 0.6f, 0.6f, 1}, .metallic = 0, .roughness = 0.5f},
                           {.name = "spark", .unlit = true}};
        add_camera(scene, {.name = "front", .yfov = 0.8}, {0, 2.2, 5}, {0, 0.6, 0});
        add_root(scene, "floor", glm::dmat4(1)).mesh = add_mesh(scene, "floor", make_ground({8, 8}, 1), 0);
        add_root(scene, "ball", translation({0.2, 0.5, -0.6})).mesh =
            add_mesh(scene, "ball", make_sphere(0.5f, 64, 32), 0);
        Emitter e{.count = 40,
                  .seed = 2,
                  .cone = 0.6f,
                  .ground = 0,
                  .colours = {{3, 2.5f, 1.5f}, {2, 0.6f, 0.1f}, {0, 0, 0}},
                  .intensity = 0.4f,
                  .range = 2,
                  .size = 0.03f,
                  .streak = 0.03f,
                  .material = 1};
        scene.emitters.push_back(e);
        e.seed = 3;
        e.ground.reset();
        e.drag = 1;
        scene.emitters.push_back(e);
        const glm::dmat4 up = glm::rotate(glm::dmat4(1), glm::radians(90.0), glm::dvec3(1, 0, 0));
        add_root(scene, "bouncing", translation({-1.3, 0.2, 0.3}) * up).emitter = 0;
        add_root(scene, "dragged", translation({1.4, 0.3, 0.2}) * up).emitter = 1;
    }
};

TEST(Emitters, AgreeWithTheReferenceAtAnyTime) {
    const Fountains fountains;
    Image before;
    for (const double time : {0.0, 1.37}) {
        const World world = resolve(fountains.scene, {}, Moment{time});
        ASSERT_EQ(world.lights.size(), 80u);
        for (const char* renderer : {"light-prepass", "deferred", "z-prepass", "multipass"}) {
            SCOPED_TRACE(renderer);
            expect_agrees(
                {.world = &world, .camera = world.cameras[0], .width = 240, .height = 135, .renderer = renderer});
        }
        Shot shot{.world = &world, .camera = world.cameras[0], .width = 160, .height = 90};
        shot.settings = {{"shadows", "on"}};
        const Image lit = render_linear(test_device(), shot);
        shot.settings.clear();
        EXPECT_TRUE(lit.pixels == render_linear(test_device(), shot).pixels) << "lights of particles have no shadows";
        EXPECT_FALSE(lit.pixels == before.pixels) << "nothing has moved";
        before = lit;
    }
    expect_validation_clean(test_device());
}

/// A light per particle, thousands of them: each particle has its light, no light is lost, and all are in the picture.
TEST(LightPerParticle, ThousandsOfThemAllLight) {
    Fountains fountains;
    for (Emitter& emitter : fountains.scene.emitters) {
        emitter.count = 1500;
        emitter.size = 0; // lights alone: no edges beside them
        emitter.intensity = 0.02f;
        emitter.range = 0.8f;
    }
    const World world = resolve(fountains.scene, {}, Moment{1.0});
    ASSERT_EQ(world.lights.size(), 3000u);
    std::vector<Stats> stats;
    for (const char* culling : {"tiles", "volumes", "fullscreen"}) {
        RenderOptions options{.width = 96, .height = 54, .count_pairs = true, .settings = {{"light-culling", culling}}};
        const auto renderer = create_renderer("light-prepass", &test_device(), options);
        renderer->set_world(world);
        renderer->render(world.cameras[0]);
        stats.push_back(renderer->stats());
        EXPECT_EQ(stats.back().lights, 3000u);
        EXPECT_EQ(stats.back().pairs_contributing, stats[0].pairs_contributing) << culling;
    }
    EXPECT_GT(stats[0].pairs_contributing, 96u * 54 * 20); // on every pixel many
    EXPECT_LT(stats[0].pairs_evaluated, stats[2].pairs_evaluated / 4);
    expect_agrees({.world = &world, .camera = world.cameras[0], .width = 192, .height = 108});
}

} // namespace
} // namespace prelight
