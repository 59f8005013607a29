// Ambient occlusion from depth and normals: what planes, corners and edges must look like, how it lies against
// rays, and that it takes from ambient light alone.
#include "every_way.hpp"
#include "garden.hpp"
#include <cmath>
#include <prelight/error.hpp>
#include <prelight/material_shader.hpp>

namespace prelight {
namespace {

Image occlusion_of(const Shot& shot, Device& device = test_device()) {
    return view_of(shot, "ambient-occlusion", device);
}

Image rays_of(const Shot& shot, const char* radius = "1") {
    RenderOptions options{.width = shot.width, .height = shot.height};
    options.settings = {{"ambient-occlusion-radius", radius}};
    options.views = {"ambient-occlusion"};
    const auto renderer = create_renderer("reference", nullptr, options);
    renderer->set_world(*shot.world);
    renderer->render(shot.camera);
    return renderer->read("ambient-occlusion");
}

double mean_difference(const Image& a, const Image& b) {
    double sum = 0;
    for (size_t i = 0; i < a.pixels.size(); ++i)
        sum += std::abs(double(a.pixels[i].r) - b.pixels[i].r);
    return sum / double(a.pixels.size());
}

glm::dmat4 flat() { return glm::rotate(glm::dmat4(1), -1.5707963267948966, glm::dvec3(1, 0, 0)); }

/// Six squares of a box that is seen from outside.
void add_box(TestWorld& world, glm::dvec3 centre, glm::dvec3 half) {
    const glm::dvec3 turns[] = {{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {0, 3, 0}, {1, 0, 0}, {3, 0, 0}};
    for (const glm::dvec3& turn : turns) {
        glm::dmat4 m = glm::scale(glm::translate(glm::dmat4(1), centre), half);
        m = glm::rotate(m, turn.y * 1.5707963267948966, glm::dvec3(0, 1, 0));
        m = glm::rotate(m, turn.x * 1.5707963267948966, glm::dvec3(1, 0, 0));
        world.add(square(1), glm::translate(m, glm::dvec3(0, 0, 1)));
    }
}

/// A floor, two walls and a box.
struct Room : TestWorld {
    Room() {
        add_material({.name = "wall", .base_colour = {0.7f, 0.6f, 0.5f, 1}, .metallic = 0, .roughness = 0.5f});
        add(square(4), flat());
        add(square(4), glm::translate(glm::dmat4(1), {0, 0, -2}));
        add(square(4), glm::rotate(glm::translate(glm::dmat4(1), {-2, 0, 0}), 1.5707963267948966, glm::dvec3(0, 1, 0)));
        add_box(*this, {0.3, 0.4, -0.8}, {0.5, 0.4, 0.4});
        Camera lens;
        lens.yfov = 0.8;
        camera = look_at(lens, {2.5, 2.2, 3.2}, {-0.3, 0.3, -0.8});
        world.ambient = {0.5f, 0.5f, 0.5f};
    }
    PlacedCamera camera;
    Shot shot() const { return {.world = &world, .camera = camera, .settings = {{"ssao", "full"}}}; }
};

TEST(AmbientOcclusion, ALonePlaneIsOpenEverywhere) {
    TestWorld plane;
    plane.add_material({.name = "floor", .metallic = 0});
    plane.add(square(400), flat());
    Camera lens, flat_lens;
    lens.yfov = 1;
    flat_lens.kind = ProjectionKind::orthographic;
    flat_lens.ymag = 4;
    flat_lens.zfar = 100;
    const PlacedCamera cameras[] = {look_at(lens, {0, 1.7, 0}, {3, 0, -4}), look_at(lens, {0, 1.7, 0}, {3, 1.5, -4}),
                                    look_at(lens, {0, 0.2, 0}, {0.1, 0, 0.02}),
                                    look_at(flat_lens, {0, 10, 0}, {3, 0, -14})};
    for (const Way& way : std::initializer_list<Way>{
             {"light-prepass", {}},
             {"light-prepass", {{"normals", "oct32"}, {"depth", "r32f"}, {"normal-space", "view"}}},
             {"light-prepass", {{"normals", "oct16"}, {"position", "matrix"}}},
             {"deferred", {}},
             {"deferred", {{"g-buffer", "killzone2"}}}})
        for (const char* resolution : {"half", "full"})
            for (const PlacedCamera& camera : cameras) {
                Shot shot{.world = &plane.world,
                          .camera = camera,
                          .width = 161,
                          .height = 91,
                          .settings = way.settings,
                          .renderer = way.renderer};
                shot.settings["ssao"] = resolution;
                const Image view = occlusion_of(shot);
                float least = 1;
                for (const glm::vec3& pixel : view.pixels)
                    least = std::min(least, pixel.r);
                EXPECT_GE(least, 0.99f) << way.renderer << " " << resolution << " "
                                        << (way.settings.empty() ? "" : way.settings.begin()->second) << " "
                                        << &camera - cameras;
            }
    expect_validation_clean(test_device());
}

TEST(AmbientOcclusion, OfCornersAndABoxLiesNearRays) {
    const Room room;
    Shot shot = room.shot();
    const Image rays = rays_of(shot);
    for (const Way& way : std::initializer_list<Way>{{"light-prepass", {{"ssao", "full"}}},
                                                     {"light-prepass", {{"ssao", "half"}}},
                                                     {"deferred", {{"ssao", "half"}}}}) {
        shot.renderer = way.renderer;
        shot.settings = way.settings;
        const Image view = occlusion_of(shot);
        const double off = mean_difference(view, rays);
        std::printf("    %s %s: %.4f from rays\n", way.renderer, way.settings.at("ssao").c_str(), off);
        EXPECT_LT(off, 0.03);
    }
    // It is dark where it should be, and nothing like it elsewhere.
    float darkest = 1;
    for (const glm::vec3& pixel : rays.pixels)
        darkest = std::min(darkest, pixel.r);
    EXPECT_LT(darkest, 0.5f);
    expect_validation_clean(test_device());
}

TEST(AmbientOcclusion, RadiusIsInMetres) {
    const Room room;
    Shot shot = room.shot();
    const Image near = rays_of(shot, "0.3"), far = rays_of(shot, "2");
    shot.settings["ssao-radius"] = "0.3";
    const double near_off = mean_difference(occlusion_of(shot), near);
    const double near_other = mean_difference(occlusion_of(shot), far);
    shot.settings["ssao-radius"] = "2"; // much of what is so far is hidden, or outside of the picture
    const double far_off = mean_difference(occlusion_of(shot), far);
    const double far_other = mean_difference(occlusion_of(shot), near);
    std::printf("    %.4f and %.4f from rays; from those of the other radius %.4f and %.4f\n", near_off, far_off,
                near_other, far_other);
    EXPECT_LT(near_off, 0.03);
    EXPECT_LT(far_off, 0.06);
    EXPECT_GT(near_other, 2 * near_off);
    EXPECT_GT(far_other, 1.2 * far_off);
}

/// A panel far in front of a corner: neither may the corner's dark be seen on it, nor may it brighten what is beside
/// it.
TEST(AmbientOcclusion, EdgesDoNotBleed) {
    Room room;
    room.add(square(0.35), glm::rotate(glm::translate(glm::dmat4(1), {0.35, 1, 0.9}), 0.6, glm::dvec3(0, 1, 0)));
    const size_t panel = room.world.instances.size() - 1;
    Shot shot = room.shot();
    shot.settings = {{"ssao-radius", "0.4"}};
    const ReferencePicture seen = render_reference(room.world, shot.camera, shot.width, shot.height, 0, {});
    const Image rays = rays_of(shot, "0.4");
    for (const char* resolution : {"half", "full"}) {
        shot.settings["ssao"] = resolution;
        const Image view = occlusion_of(shot);
        size_t on_panel = 0, beside = 0;
        double off = 0;
        for (uint32_t y = 2; y + 2 < shot.height; ++y)
            for (uint32_t x = 2; x + 2 < shot.width; ++x) {
                const size_t at = size_t(y) * shot.width + x;
                if (seen.instance[at] == panel) {
                    EXPECT_GE(view.pixels[at].r, 0.97f) << resolution << " at " << x << ", " << y;
                    ++on_panel;
                    continue;
                }
                bool near_panel = false;
                for (int i = 0; i < 25; ++i)
                    near_panel =
                        near_panel || seen.instance[at + size_t(i % 5) - 2 + (size_t(i / 5) - 2) * shot.width] == panel;
                if (!near_panel)
                    continue;
                ++beside;
                off += std::abs(view.pixels[at].r - rays.pixels[at].r);
            }
        EXPECT_GT(on_panel, 500u);
        ASSERT_GT(beside, 100u);
        EXPECT_LT(off / double(beside), 0.05) << resolution;
    }
}

TEST(AmbientOcclusion, TakesFromAmbientLightAlone) {
    Room room;
    const glm::vec3 ambient = room.world.ambient;
    room.add_light({.kind = LightKind::point, .intensity = 6, .range = 8}, {1, 2, 1});
    const std::vector<PlacedLight> lights = room.world.lights;
    Shot shot = room.shot();
    for (const char* renderer : {"light-prepass", "deferred"})
        for (const Shading shading : {Shading::ggx, Shading::phong}) {
            SCOPED_TRACE(renderer);
            shot.renderer = renderer;
            shot.shading = shading;
            shot.settings["ssao"] = "half";
            room.world.ambient = ambient;
            room.world.lights = lights;
            const Image both = render_linear(test_device(), shot), view = occlusion_of(shot);
            room.world.ambient = {};
            const Image dark = render_linear(test_device(), shot);
            shot.settings["ssao"] = "off";
            const Image lit = render_linear(test_device(), shot);
            EXPECT_TRUE(dark.pixels == lit.pixels) << "lamps are not occluded";
            room.world.ambient = ambient;
            room.world.lights.clear();
            const Image around = render_linear(test_device(), shot);
            double worst = 0;
            for (size_t i = 0; i < both.pixels.size(); ++i) {
                const glm::vec3 expected = lit.pixels[i] + around.pixels[i] * view.pixels[i].r;
                worst = std::max(worst, double(glm::length(both.pixels[i] - expected)));
            }
            EXPECT_LT(worst, 4e-3);
        }
    expect_validation_clean(test_device());
}

/// The light pre-pass looks once more at each object, the deferred renderer lays ambient light aside: the same picture.
TEST(AmbientOcclusion, IsTheSameInBothArchitecturesForEveryMaterialAndEnvironment) {
    for (const bool environment : {false, true}) {
        Garden garden;
        const char* names[] = {"metallic-roughness", "reflection", "layered", "fresnel-rim", "detailed"};
        for (size_t m = 0; m < 5; ++m)
            garden.scene.materials[m + 1].shader = find_material_shader(names[m]);
        garden.scene.materials[3].parameters = {{"sheen_colour", {0.3f, 0.2f, 0.4f, 0}}};
        if (environment) // without, what a coat takes from ambient colour follows the lamps: docs/materials.md
            garden.scene.materials[3].parameters.insert(
                {{"clearcoat", {0.8f, 0, 0, 0}}, {"clearcoat_roughness", {0.2f, 0, 0, 0}}});
        garden.world.ambient = {0.5f, 0.6f, 0.7f};
        if (environment) {
            Environment sky{.name = "sky", .image = Image(64, 32)};
            for (uint32_t y = 0; y < 32; ++y)
                for (uint32_t x = 0; x < 64; ++x)
                    sky.image.at(x, y) = glm::vec3(1 + 0.5f * std::sin(x * 0.0981748f), 1.2f - y / 40.0f, 0.8f);
            garden.scene.environment = std::make_shared<Environment>(sky);
        }
        Shot shot = garden.shot();
        shot.width = 160, shot.height = 90;
        shot.settings = {{"ssao", "half"}, {"ssao-radius", "0.8"}};
        const Image once = render_linear(test_device(), shot);
        shot.renderer = "deferred";
        const Comparison c =
            compare_pixels(render_linear(test_device(), shot), once, std::vector<uint8_t>(once.pixels.size(), 0));
        EXPECT_GE(c.psnr, 52);
        EXPECT_LE(c.block, 1);
        // And what rays find, as far as depth and normals can know it.
        const ReferencePicture truth =
            render_reference(garden.world, shot.camera, shot.width, shot.height, 0, form_of(shot));
        const Comparison far = compare_pixels(once, truth.linear, truth.left_out());
        std::printf("    %.1f dB between them, %.1f dB from rays\n", c.psnr, far.psnr);
        EXPECT_GE(far.psnr, 28);
    }
    expect_validation_clean(test_device());
}

TEST(AmbientOcclusion, TwoRunsAndTwoFramesGiveTheSameBytes) {
    const Room room;
    Shot shot = room.shot();
    shot.settings["ssao"] = "half";
    RenderOptions options = options_of(shot);
    const auto renderer = create_renderer("light-prepass", &test_device(), options);
    renderer->set_world(room.world);
    renderer->render(shot.camera);
    const Image first = renderer->read("linear");
    renderer->render(shot.camera, 3);
    EXPECT_TRUE(renderer->read("linear").pixels == first.pixels);
    EXPECT_TRUE(render_linear(test_device(), shot).pixels == first.pixels);
}

TEST(AmbientOcclusion, ForwardRenderersSayThatTheyHaveNone) {
    const Room room;
    for (const char* renderer : {"multipass", "z-prepass"}) {
        Shot shot = room.shot();
        shot.renderer = renderer;
        EXPECT_THROW(render_linear(test_device(), shot), UsageError);
    }
    Shot shot = room.shot();
    shot.settings["ssao-radius"] = "0";
    EXPECT_THROW(render_linear(test_device(), shot), UsageError);
}

TEST(AmbientOcclusion, OnSwiftShaderLiesNearRaysToo) {
    Device* const device = swiftshader_device();
    if (!device)
        GTEST_SKIP() << "SwiftShader is not installed (Debian's package chromium)";
    const Room room;
    Shot shot = room.shot();
    shot.width = 160;
    shot.height = 90;
    shot.settings["ssao"] = "half";
    EXPECT_LT(mean_difference(occlusion_of(shot, *device), rays_of(shot)), 0.04);
    expect_validation_clean(*device);
}

} // namespace
} // namespace prelight
