// The G-buffer's layouts: formats, what each channel holds, and the pictures that come of them;
// presets, views, and a second driver.
#include "filled_gbuffer.hpp"
#include "garden.hpp"
#include <glm/gtc/packing.hpp>
#include <glm/gtx/component_wise.hpp>
#include <prelight/error.hpp>

namespace prelight {
namespace {

TEST(Deferred, FormatsAreExactlyValients) {
    Garden garden;
    const FilledGBuffer filled(garden.shot(), killzone2);
    const passes::GBuffer& b = filled.buffer;
    EXPECT_EQ(filled.format(b.light), VK_FORMAT_R8G8B8A8_UNORM);
    EXPECT_EQ(filled.format(b.surface.normal), VK_FORMAT_R16G16_SFLOAT);
    EXPECT_EQ(filled.format(b.motion), VK_FORMAT_R8G8B8A8_UNORM);
    EXPECT_EQ(filled.format(b.albedo), VK_FORMAT_R8G8B8A8_UNORM);
    EXPECT_EQ(filled.format(b.surface.depth), VK_FORMAT_D24_UNORM_S8_UINT); // lavapipe has it
    uint32_t bytes = 0;
    for (const graph::ImageId image : {b.light, b.surface.normal, b.motion, b.albedo, b.surface.depth})
        bytes += graph::texel_bytes(filled.format(image));
    EXPECT_EQ(bytes, 20u);
    expect_validation_clean(test_device());
}

TEST(Deferred, WithoutD24S8DepthAndStencilAreD32S8AndTheLogSaysSo) {
    const auto device =
        Device::create({.select = "cpu", .validate = true, .hidden_formats = {VK_FORMAT_D24_UNORM_S8_UINT}});
    Garden garden;
    garden.add_lights(4, 4, 6);
    RenderOptions options{.width = 64, .height = 36, .preset = "killzone2"};
    const auto renderer = create_renderer("deferred", device.get(), options);
    renderer->set_world(garden.world);
    renderer->render(garden.camera);
    ASSERT_EQ(renderer->stats().notes.size(), 1u);
    EXPECT_THAT(renderer->stats().notes[0], testing::HasSubstr("D32F_S8 is taken"));
    expect_validation_clean(*device);
}

// Each channel of one surface, decoded here from the documentation.
TEST(Deferred, ChannelsHoldWhatTheTableSays) {
    TestWorld test;
    Material& material = test.add_material({.name = "brass",
                                            .base_colour = {0.81f, 0.49f, 0.25f, 1},
                                            .metallic = 0.5f,
                                            .roughness = 0.3f,
                                            .emissive = {0.5f, 0.25f, 1}});
    material.occlusion_texture = {.image = test.add_image(1, 1, {128, 0, 0, 255})};
    test.add(square(20), glm::rotate(glm::dmat4(1), 0.4, glm::dvec3(0, 1, 0)));
    const Shot shot{.world = &test.world, .camera = front_camera(5), .width = 8, .height = 8};
    const FilledGBuffer filled(shot, killzone2);
    const auto& b = filled.buffer;
    const double step = 0.5 / 255 + 1e-6;

    const glm::dvec4 light = filled.bytes(b.light, 4, 4); // scale 2
    const glm::dvec3 emissive(0.5, 0.25, 1);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(light[c], emissive[c] / 2, step);
    EXPECT_NEAR(light.a, (0.2126 * 0.5 + 0.7152 * 0.25 + 0.0722) / 2 / 8, step);

    const glm::dvec4 albedo = filled.bytes(b.albedo, 4, 4);
    const glm::dvec3 base(0.81, 0.49, 0.25);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(albedo[c], std::sqrt(base[c] * 0.5), step);
    EXPECT_NEAR(albedo.a, 128 / 255.0, step);

    const glm::dvec4 specular = filled.bytes(b.motion, 4, 4);
    const glm::dvec3 f0 = 0.5 * base + 0.02;
    EXPECT_NEAR(specular.a, std::sqrt(0.2126 * f0.r + 0.7152 * f0.g + 0.0722 * f0.b), step);
    EXPECT_NEAR(specular.b, 1 + std::log2(0.3) / -std::log2(0.089), step);

    const auto normals = filled.graph.read_back(b.surface.normal);
    const auto* halves = reinterpret_cast<const uint16_t*>(normals.data()) + size_t(2 * (4 * 8 + 4));
    EXPECT_NEAR(glm::unpackHalf1x16(halves[0]), std::sin(0.4), 1.0 / 2048);
    EXPECT_NEAR(glm::unpackHalf1x16(halves[1]), 0, 1.0 / 2048);
}

Comparison killzone2_against(const Shot& shot, bool grey_form) {
    ReferenceForm form = form_of(shot);
    form.grey_reflectance = grey_form;
    const ReferencePicture reference =
        render_reference(*shot.world, shot.camera, shot.width, shot.height, shot.exposure, form);
    return compare_pixels(picture_of(shot), reference.linear, reference.left_out());
}

TEST(Deferred, Killzone2AgreesWithinTheBoundsOfBytes) {
    FewLights coloured;
    FewLights grey(true);
    for (const Shading shading : {Shading::ggx, Shading::phong}) {
        const auto shot_of = [&](const Garden& garden) {
            Shot shot = deferred(garden.shot(), {{"g-buffer", "killzone2"}, {"accumulation", "rgba8"}});
            shot.exposure = shading == Shading::ggx ? 0.7 : -0.5;
            shot.shading = shading;
            return shot;
        };
        // What the layout can hold: no coloured metal, or metals in grey in the reference too.
        const Comparison plain = killzone2_against(shot_of(grey), false);
        EXPECT_GE(plain.psnr, rgba8_bound.psnr);
        const Comparison form = killzone2_against(shot_of(coloured), true);
        EXPECT_GE(form.psnr, rgba8_bound.psnr);
        // What it cannot.
        const Comparison lost = killzone2_against(shot_of(coloured), false);
        EXPECT_LT(lost.psnr, form.psnr - 1);
        std::printf("    no coloured metal %.1f dB, grey metals in both %.1f dB, coloured in the reference %.1f dB\n",
                    plain.psnr, form.psnr, lost.psnr);
    }
    expect_validation_clean(test_device());
}

// The G-buffer alone: light accumulated in half floats.
TEST(Deferred, Killzone2WithHalfFloatLight) {
    FewLights garden(true);
    const Comparison c = killzone2_against(deferred(garden.shot(), {{"g-buffer", "killzone2"}}), false);
    EXPECT_GE(c.psnr, 45);
    std::printf("    %.1f dB, %.3f %% off, block %.2f/255\n", c.psnr, c.off_share * 100, c.block);
}

TEST(Deferred, Killzone2MaskedMirroredDoubleSidedUnlit) {
    MixedMaterials mixed;
    const Comparison c =
        killzone2_against(deferred(mixed.shot(), {{"g-buffer", "killzone2"}, {"accumulation", "rgba8"}}), false);
    EXPECT_GE(c.psnr, rgba8_bound.psnr);
}

// Z of the view-space normal is negative where a surface, or its normal map, turns from the view axis.
TEST(Deferred, NormalsThatTurnFromTheViewAxisKeepTheirSide) {
    TestWorld test;
    test.add_material({.name = "wall", .base_colour = {0.7f, 0.7f, 0.7f, 1}, .metallic = 0, .roughness = 0.5f});
    // A wide view along two walls that lean away from the axis.
    for (const double side : {-1.0, 1.0}) {
        glm::dmat4 m = glm::translate(glm::dmat4(1), {2.5 * side, 0, -2});
        m = glm::rotate(m, -side * (1.5707963 + 0.25), glm::dvec3(0, 1, 0));
        test.add(square(3), m);
    }
    test.add_light({.kind = LightKind::point, .intensity = 6, .range = 20}, {0, 0, 0.5});
    PlacedCamera camera = front_camera(2);
    camera.camera.yfov = 1.9;
    Shot shot = deferred({.world = &test.world, .camera = camera}, {{"g-buffer", "killzone2"}});
    const ReferencePicture reference = render_reference(test.world, camera, shot.width, shot.height, 0, form_of(shot));
    const auto away = std::count_if(reference.normal.begin(), reference.normal.end(),
                                    [&](const glm::dvec3& n) { return glm::dot(n, camera.axes[2]) < -0.1; });
    EXPECT_GT(away, 2000) << "the scene shows what it is for";
    EXPECT_GE(killzone2_against(shot, false).psnr, rgba8_bound.psnr);
}

// Where RGB is full, the intensity channel keeps the luminance.
TEST(Deferred, IntensityKeepsBrightnessBeyondBytes) {
    TestWorld test;
    for (const double x : {-2.0, 2.0}) {
        test.add_material({.name = "lamp",
                           .base_colour = {0, 0, 0, 1},
                           .emissive = x < 0 ? glm::vec3(6, 9, 3) : glm::vec3(1.5f, 1, 0.5f)});
        test.add(square(1.5f), glm::translate(glm::dmat4(1), {x, 0, 0}));
    }
    Shot shot = deferred({.world = &test.world, .camera = front_camera(5)},
                         {{"g-buffer", "killzone2"}, {"accumulation", "rgba8"}, {"light-scale", "2"}});
    const Image picture = picture_of(shot);
    const auto luminance = [](glm::vec3 c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; };
    const glm::vec3 bright = picture.at(shot.width * 3 / 10, shot.height / 2),
                    dim = picture.at(shot.width * 7 / 10, shot.height / 2);
    EXPECT_NEAR(luminance(bright), luminance({6, 9, 3}), 0.05);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(dim[c], (std::array{1.5, 1.0, 0.5})[size_t(c)], 1.01 / 255);
}

// ---- The preset, the views, what is refused.

TEST(Deferred, PresetIsTheLayoutAndSettingsGoBeforeIt) {
    RenderOptions options{.width = 16, .height = 16, .preset = "killzone2"};
    Garden garden;
    const auto settings_of = [&] {
        const auto renderer = create_renderer("deferred", &test_device(), options);
        renderer->set_world(garden.world);
        renderer->render(garden.camera);
        return renderer->stats().settings;
    };
    EXPECT_THAT(settings_of(),
                testing::IsSupersetOf({std::pair<const std::string, std::string>("g-buffer", "killzone2"),
                                       {"accumulation", "rgba8"},
                                       {"light-scale", "auto"},
                                       {"model", "full"}}));
    options.settings = {{"accumulation", "rgba16f"}};
    EXPECT_THAT(settings_of(),
                testing::IsSupersetOf(
                    {std::pair<const std::string, std::string>("g-buffer", "killzone2"), {"accumulation", "rgba16f"}}));
    options.preset = "engel";
    EXPECT_THROW(settings_of(), UsageError);
}

TEST(Deferred, EveryViewOfBothLayoutsIsDrawn) {
    Garden garden;
    garden.add_lights(12, 4, 6);
    garden.camera.previous = CameraPose{garden.camera.position + glm::dvec3(1, 0, 0), garden.camera.axes};
    std::vector<std::string> views;
    for (const RendererInfo& info : renderer_infos())
        if (info.name == "deferred")
            views = info.views;
    for (const char* layout : {"wide", "killzone2"}) {
        RenderOptions options{.width = 64, .height = 36, .settings = {{"g-buffer", layout}}, .views = views};
        const auto renderer = create_renderer("deferred", &test_device(), options);
        renderer->set_world(garden.world);
        renderer->render(garden.camera);
        for (const std::string& view : views) {
            const Image image = renderer->read(view);
            glm::vec3 low(1e9f), high(-1e9f);
            for (const glm::vec3& pixel : image.pixels) {
                low = glm::min(low, pixel);
                high = glm::max(high, pixel);
            }
            if (view == "edges" || view == "layers") // of one sample a pixel, and of opaque surfaces, there are none
                EXPECT_EQ(high, glm::vec3(0)) << layout;
            else
                EXPECT_GT(glm::compMax(high - low), 0.1f) << view << " in " << layout;
        }
    }
    expect_validation_clean(test_device());
}

TEST(DeferredOnSwiftShader, AgreeWithTheReference) {
    Device* const device = swiftshader_device();
    if (!device)
        GTEST_SKIP() << "SwiftShader is not installed (Debian's package chromium)";
    Garden garden;
    garden.add_lights(6, 4, 6);
    garden.add_light(garden.spot(0.6f, 8, 30), {1, 4, 2}, {0, -1, -0.2});
    garden.add_light({.kind = LightKind::directional, .intensity = 0.4f}, {0, 0, 0}, {-0.3, -1, -0.5});
    const Comparison c = against_reference(*device, deferred(garden.shot()));
    EXPECT_GE(c.psnr, half_float_bound.psnr);
    EXPECT_LE(c.off_share, half_float_bound.off_share);
    EXPECT_LE(c.block, half_float_bound.block);
    FewLights few(true);
    Shot bytes = deferred(few.shot(), {{"g-buffer", "killzone2"}, {"accumulation", "rgba8"}});
    bytes.exposure = 0.7;
    EXPECT_GE(against_reference(*device, bytes).psnr, rgba8_bound.psnr);
    expect_validation_clean(*device);
}

} // namespace
} // namespace prelight
