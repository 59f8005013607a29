// Squares that face the camera, and surfaces that fade before what is opaque.
#include "panes.hpp"
#include <scene/procedural/glass_maps.hpp>

namespace prelight {
namespace {

/// Smoke in layers before and behind a ball, lit, whose squares reach into the floor and into the ball.
struct Smoke : TestWorld {
    explicit Smoke(float softness = 0.3f) {
        Material& floor = add_material({.name = "floor", .base_colour = {0.5f, 0.4f, 0.3f, 1}, .metallic = 0});
        floor.double_sided = true;
        add(square(12), glm::rotate(glm::dmat4(1), -1.5707963267948966, {1, 0, 0}));
        add(sphere(24), placed_at(0, 0.6, 0));
        scene.images = {smoke_puff(), puff_slopes()};
        Material smoke{.name = "smoke", .base_colour = {0.8f, 0.85f, 0.9f, 0.7f}, .metallic = 0, .roughness = 0.9f};
        smoke.alpha_mode = AlphaMode::blend;
        smoke.softness = softness;
        smoke.base_colour_texture.image = 0;
        smoke.normal_texture.image = 1;
        add_material(smoke);
        add(puffs(), glm::rotate(placed_at(0.1, 0.5, 0), 0.4, glm::dvec3(0.3, 1, 0)));
        world.instances.back().receives_decals = false;
        for (int i = 0; i < 6; ++i)
            add_light({.kind = LightKind::point,
                       .colour = {1, 0.8f, 0.2f * static_cast<float>(i)},
                       .intensity = 3,
                       .range = 5,
                       .casts_shadow = false},
                      {2.5 * std::sin(1.05 * i), 0.5 + 0.3 * i, 2.5 * std::cos(1.05 * i)});
        add_light({.kind = LightKind::spot, .intensity = 30, .range = 9}, {1, 4, 3}, {-0.2, -1, -0.7});
        world.ambient = glm::vec3(0.1f);
    }

    static Primitive puffs() {
        Primitive out;
        for (uint32_t i = 0; i < 4; ++i) {
            const auto t = static_cast<float>(i);
            const glm::vec3 place(1.6f * std::sin(2.4f * t), 0.25f * std::cos(1.7f * t), 1.5f * std::cos(2.4f * t));
            const float angle = 0.7f * t, size = 0.4f + 0.08f * t;
            const glm::vec2 along = size * glm::vec2(std::cos(angle), std::sin(angle));
            for (uint32_t c = 0; c < 4; ++c) {
                const float x = c == 1 || c == 2 ? 1 : -1, y = c >= 2 ? 1 : -1;
                out.positions.push_back(place);
                out.facing.push_back(x * along + y * glm::vec2(-along.y, along.x));
                out.normals.emplace_back(0, 0, 1);
                out.tangents.emplace_back(std::cos(angle), std::sin(angle), 0, 1);
                out.texcoords[0].emplace_back(0.5f + 0.5f * x, 0.5f - 0.5f * y);
                out.colours.emplace_back(1, 1 - 0.02f * t, 1, 0.4f + 0.05f * t);
            }
            for (const uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
                out.indices.push_back(4 * i + corner);
        }
        return out;
    }

    /// The same squares as plain triangles where `camera` sees them, the farthest first.
    Primitive as_triangles(const PlacedCamera& camera) const {
        const glm::dmat4& place = world.instances.back().transform;
        const Primitive from = puffs();
        Primitive out = from;
        out.facing.clear();
        std::vector<std::pair<double, uint32_t>> order;
        for (size_t v = 0; v < from.positions.size(); ++v) {
            const glm::dvec3 middle(place * glm::dvec4(from.positions[v], 1));
            out.positions[v] = glm::vec3(middle + camera.axes * glm::dvec3(from.facing[v], 0));
            out.normals[v] = glm::vec3(camera.axes[2]);
            out.tangents[v] = glm::vec4(camera.axes * glm::dvec3(from.tangents[v]), 1);
            if (v % 4 == 0)
                order.emplace_back(glm::dot(camera.axes[2], middle), static_cast<uint32_t>(v / 4));
        }
        std::sort(order.begin(), order.end());
        out.indices.clear();
        for (const auto& [depth, i] : order)
            for (const uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
                out.indices.push_back(4 * i + corner);
        return out;
    }

    static PlacedCamera from(double angle, Camera camera = {.yfov = 0.7}) {
        return look_at(camera, glm::dvec3(4 * std::sin(angle), 1.4, 4 * std::cos(angle)), {0, 0.5, 0});
    }
    Shot shot(double angle = 0.3) const {
        return {.world = &world, .camera = from(angle), .width = 320, .height = 180};
    }
};

void expect_close(const Shot& shot) {
    SCOPED_TRACE(shot.renderer);
    SCOPED_TRACE(testing::PrintToString(shot.settings));
    expect_within(against_reference(test_device(), shot), half_float_bound);
    expect_validation_clean(test_device());
}

TEST(Billboards, AgreeWithTheReferenceInEveryArchitecture) {
    const Smoke smoke;
    for (const std::string& renderer : device_renderers) {
        Shot shot = smoke.shot();
        shot.renderer = renderer;
        expect_close(shot);
    }
    for (const char* scale : {"1", "1/2"}) {
        Shot shot = with(smoke.shot(), {{"inferred-scale", scale}});
        shot.renderer = "inferred";
        expect_close(shot);
    }
    for (const char* transparency : {"sorted", "peeled"})
        expect_close(with(smoke.shot(2), {{"transparency", transparency}}));
    expect_close(with(smoke.shot(1), {{"index-trimming", "off"}}));
    expect_close(with(smoke.shot(1), {{"index-trimming", "device"}}));
    Shot parallel = smoke.shot();
    parallel.camera = Smoke::from(4, {.kind = ProjectionKind::orthographic, .ymag = 1.6, .znear = 0, .zfar = 20});
    expect_close(parallel);
    Shot four = smoke.shot();
    four.samples = 4;
    expect_close(four);
}

TEST(Billboards, OpaqueOnesFaceTheCameraToo) {
    Smoke smoke;
    smoke.scene.materials.back().alpha_mode = AlphaMode::opaque;
    for (const std::string& renderer : device_renderers) {
        Shot shot = smoke.shot();
        shot.renderer = renderer;
        expect_close(shot);
    }
}

// Neither the reference nor this vertex shader has a part in it. Shadows fall on them, and they cast them as they
// stand.
TEST(Billboards, ArePlainSquaresWhereTheCameraSeesThem) {
    Smoke smoke;
    for (const double angle : {0.3, 2.0, 4.4}) {
        const Shot shot = with(smoke.shot(angle), {{"shadows", "on"}});
        const Image faced = render_linear(test_device(), shot);
        Primitive& shown = smoke.scene.meshes.back().primitives[0];
        const Primitive facing = shown;
        const Instance turned = smoke.world.instances.back();
        shown = smoke.as_triangles(shot.camera);
        shown.material = facing.material;
        smoke.world.instances.back().transform = glm::dmat4(1);
        const Image plain = render_linear(test_device(), shot);
        expect_within(compare_pixels(plain, faced), half_float_bound);
        shown = facing;
        smoke.world.instances.back() = turned;
    }
}

/// Filtered, the smoke itself is unlit: layers among layers get too little (docs/shadows.md).
TEST(Billboards, CastShadowsAsTheReferenceHasThem) {
    Smoke smoke;
    for (PlacedLight& light : smoke.world.lights)
        light.light.casts_shadow = light.light.kind == LightKind::spot;
    for (const char* shadows : {"filtered", "opaque"}) {
        Shot shot = with(smoke.shot(), {{"shadows", "on"}, {"shadow-filter", "hard"}, {"shadow-detail", "8"}});
        shot.settings["transparent-shadows"] = shadows;
        shot.width = 480, shot.height = 270; // fewer of the pixels are edges
        smoke.scene.materials.back().unlit = shadows == std::string("filtered");
        expect_close(shot);
    }
    Shot with_shadows = with(smoke.shot(0.3), {{"shadows", "on"}});
    Shot without = with(with_shadows, {{"transparent-shadows", "none"}});
    EXPECT_LT(compare(render_linear(test_device(), with_shadows), render_linear(test_device(), without)).psnr, 50);
}

TEST(Billboards, TurnTheirShadowsWithTheCamera) {
    const Smoke smoke;
    const auto shot = [&](double angle) { return with(smoke.shot(angle), {{"shadows", "on"}}); };
    const auto renderer = create_renderer("light-prepass", &test_device(), options_of(shot(0)));
    renderer->set_world(smoke.world);
    for (const double angle : {0.0, 2.0, 2.0})
        renderer->render(Smoke::from(angle));
    EXPECT_GT(renderer->stats().shadows.value().tiles_reused, 0u) << "the last one is the one before";
    EXPECT_TRUE(renderer->read("linear").pixels == render_linear(test_device(), shot(2)).pixels);
}

TEST(Billboards, ACameraThatMovesUploadsNothing) {
    const Smoke smoke;
    const auto renderer = create_renderer("light-prepass", &test_device(), options_of(smoke.shot()));
    renderer->set_world(smoke.world);
    renderer->render(Smoke::from(0));
    renderer->render(Smoke::from(2));
    const Image moved = renderer->read("linear");
    EXPECT_TRUE(moved.pixels == render_linear(test_device(), smoke.shot(2)).pixels);
}

// α · min(d / softness, 1) of a pane that stands d metres before a wall.
TEST(Billboards, SoftSurfacesFadeBeforeWhatIsOpaque) {
    for (const double distance : {0.05, 0.1, 0.5})
        for (const char* renderer : {"light-prepass", "multipass"}) {
            TestWorld scene;
            scene.add_material(unlit_material("wall", {0.1f, 0.3f, 0.2f, 1}, AlphaMode::opaque));
            scene.add(square(20), placed_at(0, 0, -distance));
            Material& pane = scene.add_material(unlit_material("pane", {0.9f, 0.1f, 0.4f, 0.6f}));
            pane.softness = 0.2f;
            scene.add(square(2), placed_at(0, 0, 0));
            Shot shot{.world = &scene.world, .camera = front_camera(5), .width = 64, .height = 36};
            shot.renderer = renderer;
            const double left = std::min(distance / 0.2, 1.0);
            const glm::vec3 pixel = middle_of(render_linear(test_device(), shot));
            expect_layers(pixel, laid_over({0.1, 0.3, 0.2}, {{0.9, 0.1, 0.4, 0.6 * left}}), 2);
        }
    expect_validation_clean(test_device());
}

TEST(Billboards, WhatCannotBeSoftSaysSo) {
    const Smoke smoke;
    const auto notes = [&](const std::string& renderer, std::map<std::string, std::string> settings, uint32_t samples) {
        Shot shot = smoke.shot();
        shot.renderer = renderer;
        shot.settings = std::move(settings);
        shot.samples = samples;
        const Rendered drawn = render_with(smoke.world, shot.camera, options_of(shot), renderer);
        return drawn.stats.notes;
    };
    using testing::Contains;
    using testing::HasSubstr;
    EXPECT_THAT(notes("deferred", {{"transparency", "half-samples"}}, 4), Contains(HasSubstr("soft surfaces end")));
    EXPECT_THAT(notes("light-prepass", {{"transparency", "peeled"}, {"layer-light", "light-buffer"}}, 1),
                Contains(HasSubstr("lists are taken")));
    EXPECT_THAT(notes("light-prepass", {}, 1), testing::IsEmpty());
}

} // namespace
} // namespace prelight
