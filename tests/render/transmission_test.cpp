// Transmissive surfaces against the reference, which has the documented rule written another time.
#include "panes.hpp"
#include <prelight/material_shader.hpp>
#include <shared/behind.h>

namespace prelight {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using Parameters = std::map<std::string, glm::vec4>;

Material see_through(const char* name, glm::vec3 colour, float roughness, Parameters parameters = {}) {
    Material material{.name = name, .base_colour = {colour, 1}, .metallic = 0, .roughness = roughness};
    material.double_sided = true;
    material.shader = find_material_shader("layered");
    material.parameters = std::move(parameters);
    material.parameters.emplace("transmission", glm::vec4(1));
    return material;
}

/// The garden behind transmissive things of every kind, with blended ones before and behind them.
struct Showcase : Garden {
    Showcase() {
        add_lights(10, 5, 4);
        add_light(spot(0.7f, 9, 20), {1, 4, 3}, {0, -1, -0.2});
        add_light(point(3, 0.5f), {-1.7, 0.7, 1.6}); // behind the frosted pane
        world.ambient = glm::vec3(0.05f);
        const auto turned = [](double x, double y, double z, double angle) {
            return glm::rotate(placed_at(x, y, z), angle, glm::dvec3(0, 1, 0));
        };
        add_material(see_through("tinted", {0.9f, 0.5f, 0.3f}, 0));
        add(square(0.7f), turned(-3.1, 1.2, 2, 0.3));
        add_material(see_through("frosted", {0.9f, 0.95f, 1}, 0.45f));
        add(square(0.7f), turned(-1.6, 1, 2.6, -0.2));
        add_material(see_through("ball", {1, 1, 1}, 0.05f,
                                 {{"thickness", glm::vec4(1.6f)},
                                  {"attenuation_distance", glm::vec4(1)},
                                  {"attenuation_colour", {0.3f, 0.8f, 0.6f, 0}}}));
        scene.materials.back().double_sided = false;
        add(sphere(64), glm::scale(placed_at(0.1, 1, 2.6), glm::dvec3(0.6)));
        add_material(unlit_material("film", {0.3f, 0.5f, 0.2f, 0.3f}));
        add(square(0.3f), placed_at(0.1, 1.3, 3.6));
        add(square(0.5f), placed_at(-1.6, 1, 1.9)); // behind frosted glass: it does not show
        Material net = see_through("net", {0.5f, 0.6f, 1}, 0.2f, {{"ior", glm::vec4(1.33f)}});
        net.alpha_mode = AlphaMode::mask;
        net.base_colour_texture = net.textures["transmission_map"] = {.image = add_image(4, 4, dots())};
        add_material(net);
        add(square(0.6f), turned(1.5, 1.1, 2.4, 0.2));
        Material print = see_through("print", {0.8f, 0.6f, 0.9f}, 0.7f,
                                     {{"clearcoat", glm::vec4(0.7f)},
                                      {"thickness", glm::vec4(0.3f)},
                                      {"ior", glm::vec4(1.2f)},
                                      {"transmission", glm::vec4(0.6f)}});
        print.base_colour.a = 0.6f;
        print.alpha_mode = AlphaMode::blend;
        print.textures["thickness_map"] = {.image = 0};
        add_material(print);
        add(square(0.6f), glm::scale(turned(2.7, 1, 2.2, -0.3), {-1, 1.4, 1}));
        add(square(0.4f), turned(2.9, 1.2, 1.8, 0.1)); // behind it: the nearest one counts
    }
    static std::vector<uint8_t> dots() {
        std::vector<uint8_t> rgba;
        for (uint32_t i = 0; i < 16; ++i)
            rgba.insert(rgba.end(), {static_cast<uint8_t>(120 + 9 * i), static_cast<uint8_t>(250 - 8 * i), 200,
                                     static_cast<uint8_t>((i / 4 + i) % 3 ? 255 : 20)});
        return rgba;
    }
};

struct TransmissionOf : testing::TestWithParam<Shot> {};

std::vector<Shot> ways() {
    std::vector<Shot> shots;
    for (const std::string& name : device_renderers)
        for (const char* how : {"lists", "sorted"}) {
            Shot& shot = shots.emplace_back();
            shot.renderer = name;
            shot.settings = {{"transparency", how}, {"model", "nv"}};
        }
    return shots;
}

INSTANTIATE_TEST_SUITE_P(All, TransmissionOf, testing::ValuesIn(ways()), way_name);

TEST_P(TransmissionOf, AShowcaseAgreesWithTheReference) {
    static const Showcase showcase;
    static References references;
    const Shot shot = in_way(showcase.shot(), GetParam());
    const ReferencePicture& reference = references.of(shot);
    const Image picture = render_linear(test_device(), shot);
    save_when_wanted(picture, reference);
    expect_within(compare_pixels(picture, reference.linear, reference.left_out()), half_float_bound);
    expect_validation_clean(test_device());
}

TEST(TransmissionForms, AgreeWithTheReference) {
    Showcase showcase;
    Shot shot = showcase.shot();
    expect_agrees(shot); // with the light pre-pass' own form of Fresnel
    shot.shading = Shading::phong;
    shot.exposure = -2;
    expect_agrees(shot);
    shot = showcase.shot();
    auto sky = std::make_shared<Environment>();
    sky->name = "sky";
    sky->image = Image(32, 16);
    for (size_t i = 0; i < sky->image.pixels.size(); ++i)
        sky->image.pixels[i] = {0.3f + 0.2f * std::sin(static_cast<float>(i % 32) * 0.19635f),
                                0.25f + 0.01f * static_cast<float>(i / 32), 0.4f};
    showcase.scene.environment = sky;
    shot.width = 160; // higher than wide: levels stand beside the picture
    shot.height = 200;
    expect_agrees(shot, {.left_out = 0.2});
    showcase.scene.environment = nullptr;
    showcase.camera.camera.kind = ProjectionKind::orthographic;
    showcase.camera.camera.ymag = 3;
    showcase.camera.camera.zfar = 30;
    expect_agrees(showcase.shot());
}

TEST(TransmissionForms, ShadowsFallOnItAndNoneFromIt) {
    Showcase showcase;
    for (PlacedLight& light : showcase.world.lights)
        light.light.casts_shadow = light.light.kind == LightKind::spot || &light == &showcase.world.lights.back();
    Shot shot = showcase.shot();
    shot.settings = {
        {"shadows", "on"}, {"shadow-filter", "hard"}, {"shadow-detail", "8"}, {"shadow-budget", "67108864"}};
    expect_agrees(shot, {.left_out = 0.15});
}

TEST(TransmissionForms, SamplesAgree) {
    const Showcase showcase;
    for (const char* name : {"light-prepass", "z-prepass"}) {
        SCOPED_TRACE(name);
        Shot shot = with_samples(showcase.shot(), 480);
        shot.renderer = name;
        const ReferencePicture reference =
            render_reference(showcase.world, shot.camera, shot.width, shot.height, 0, form_of(shot));
        const Image picture = render_linear(test_device(), shot);
        save_when_wanted(picture, reference);
        expect_within_on_edges(picture, reference);
    }
    expect_validation_clean(test_device());
}

TEST(Transmission, AThinSmoothPaneShowsEachPixelTinted) {
    TestWorld test;
    test.add_material(unlit_material("wall", {0.25f, 0.5f, 0.75f, 1}, AlphaMode::opaque));
    test.add(square(20), placed_at(0, 0, -3));
    test.add_material(unlit_material("stripe", {1, 1, 1, 1}, AlphaMode::opaque));
    test.add(square(0.5f), placed_at(0.3, 0.1, -2));
    test.add_material(see_through("pane", {0.5f, 0.25f, 1}, 0, {{"specular", glm::vec4(0)}}));
    test.add(square(6), glm::rotate(placed_at(0, 0, 0), 0.2, {0, 1, 0}));
    const Shot shot{.world = &test.world, .camera = front_camera(5), .width = 96, .height = 54};
    const Image through = render_linear(test_device(), shot);
    test.world.instances.back().visible = false;
    const Image behind = render_linear(test_device(), shot);
    const glm::vec3 tint(0.5f, 0.25f, 1);
    for (size_t i = 0; i < behind.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) // to a step of a half float, for the target cuts off
            ASSERT_NEAR(through.pixels[i][c], tint[c] * behind.pixels[i][c], behind.pixels[i][c] / 1024) << i;
    expect_validation_clean(test_device());
}

// A wall of hard contrasts behind panes of growing roughness, unlit: nothing but the levels of blur decides.
TEST(Transmission, BlursAsTheReferenceDoes) {
    TestWorld test;
    std::vector<uint8_t> noise;
    for (uint32_t i = 0; i < 32 * 32; ++i) {
        const uint32_t bits = (i * 2654435761u) >> 24;
        noise.insert(noise.end(), {static_cast<uint8_t>(bits & 1 ? 255 : 0), static_cast<uint8_t>(bits & 2 ? 200 : 20),
                                   static_cast<uint8_t>(bits), 255});
    }
    Material wall = unlit_material("wall", {1, 1, 1, 1}, AlphaMode::opaque);
    wall.base_colour_texture = {.image = test.add_image(32, 32, noise)};
    test.add_material(wall);
    test.add(square(8), placed_at(0, 0, -2));
    const float roughnesses[] = {0.1f, 0.25f, 0.4f, 0.6f, 0.8f};
    for (int i = 0; i < 5; ++i) {
        test.add_material(see_through("pane", {1, 1, 1}, roughnesses[i], {{"specular", glm::vec4(0)}}));
        test.add(square(0.62f), glm::scale(placed_at(1.3 * (i - 2), 0, 0), {1, 3, 1}));
    }
    Shot shot{.world = &test.world, .camera = front_camera(5), .width = 192, .height = 108};
    expect_agrees(shot, {.psnr = 60, .left_out = 0.2});
    // Were the blur another, that would be seen.
    const ReferencePicture reference = render_reference(test.world, shot.camera, 192, 108, 0, form_of(shot));
    for (Material& material : test.scene.materials)
        material.roughness *= 1.04f;
    EXPECT_LT(compare_pixels(render_linear(test_device(), shot), reference.linear, reference.left_out()).psnr, 50);
}

TEST(Transmission, LessGeometryMakesNoDifference) {
    const Showcase showcase;
    expect_same_with_less_geometry(showcase.shot());
}

std::vector<std::string> pass_names(const Stats& stats) {
    std::vector<std::string> names;
    for (const PassStats& pass : stats.passes)
        names.push_back(pass.name);
    return names;
}

TEST(Transmission, CostsNothingWhereThereIsNone) {
    Showcase showcase;
    const Shot shot = showcase.shot();
    EXPECT_THAT(pass_names(render_with(showcase.world, showcase.camera, options_of(shot)).stats),
                Contains("transmission"));
    for (Material& material : showcase.scene.materials)
        material.parameters.erase("transmission");
    const Stats none = render_with(showcase.world, showcase.camera, options_of(shot)).stats;
    EXPECT_THAT(pass_names(none), Not(Contains(testing::AnyOf(HasSubstr("transmission"), HasSubstr("behind")))));
}

TEST(Transmission, IsDrawnOpaqueWhereThatIsWanted) {
    Showcase showcase;
    const Shot shot = with(showcase.shot(), {{"transparency", "opaque"}});
    const Rendered opaque = render_with(showcase.world, showcase.camera, options_of(shot));
    EXPECT_THAT(opaque.stats.notes, Contains(HasSubstr("nothing is seen through")));
    for (Material& material : showcase.scene.materials)
        material.parameters.erase("transmission");
    EXPECT_EQ(opaque.linear.pixels, render_linear(test_device(), shot).pixels);
    expect_agrees(shot);
}

TEST(Transmission, InferredSaysThatItIsDrawnOpaque) {
    const Showcase showcase;
    EXPECT_THAT(render_with(showcase.world, showcase.camera, options_of(showcase.shot()), "inferred").stats.notes,
                Contains(HasSubstr("inferred: nothing is seen through")));
}

TEST(Transmission, ChangesFromFrameToFrame) {
    Showcase showcase;
    const Shot shot = showcase.shot();
    const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
    renderer->set_world(showcase.world);
    const auto frosted = static_cast<uint32_t>(6 + 1);
    ASSERT_EQ(showcase.scene.materials.at(frosted).name, "frosted");
    for (const float transmission : {0.5f, 0.0f, 0.8f}) { // another look; opaque; and back again
        showcase.scene.materials[frosted].parameters["transmission"] = glm::vec4(transmission);
        WorldChanges changes;
        changes.materials = {frosted};
        renderer->update_world(changes);
        renderer->render(shot.camera);
        EXPECT_EQ(renderer->read("linear").pixels, render_linear(test_device(), shot).pixels) << transmission;
    }
    for (int frame = 0; frame < 6; ++frame) {
        PlacedCamera camera = shot.camera;
        camera.position.x += 0.02 * frame;
        renderer->render(camera);
        if (frame >= 3) { // lists find out how much room they need
            EXPECT_EQ(renderer->stats().created, CreatedObjects{}) << frame;
        }
    }
    expect_validation_clean(test_device());
}

TEST(Transmission, LooksAlikeOnSwiftShader) {
    Device* const device = swiftshader_device();
    if (!device)
        GTEST_SKIP() << "SwiftShader is not installed (Debian's package chromium)";
    const Showcase showcase;
    Shot shot = showcase.shot();
    shot.width = 160;
    shot.height = 90;
    const ReferencePicture reference = render_reference(showcase.world, shot.camera, 160, 90, 0, form_of(shot));
    const Image picture = render_linear(*device, shot);
    save_when_wanted(picture, reference);
    // It moves corners by up to a thirty-second of a pixel, and a ball of glass magnifies that.
    expect_within(compare_pixels(picture, reference.linear, reference.left_out()),
                  {.psnr = 45, .off_share = 0.01, .left_out = 0.2});
    expect_validation_clean(*device);
}

TEST(BehindLevels, LieBesideEachOther) {
    for (const glm::ivec2& size : {glm::ivec2(1, 1), {2, 1}, {3, 7}, {64, 64}, {1280, 720}, {719, 1281}, {4097, 5}}) {
        struct Area {
            glm::ivec2 low{0}, high{0};
        };
        std::vector<Area> areas;
        const int last = shared::behind_last_level(size);
        EXPECT_EQ(shared::behind_size(size, last), glm::ivec2(1));
        for (int level = 0; level <= last; ++level) {
            const glm::ivec2 low = shared::behind_corner(size, level), high = low + shared::behind_size(size, level);
            for (const Area& other : areas)
                EXPECT_TRUE(low.x >= other.high.x || high.x <= other.low.x || low.y >= other.high.y ||
                            high.y <= other.low.y)
                    << size.x << "x" << size.y << ": level " << level;
            areas.push_back({low, high});
        }
    }
}

} // namespace
} // namespace prelight
