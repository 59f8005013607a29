// Many equal lights at one place are one light of as many times the intensity: none is lost in number, however they
// find their pixels and wherever they are added up.
#include "every_way.hpp"
#include "garden.hpp"
#include "vulkan_calls.hpp"
#include <fmt/format.h>
#include <gpu/context.hpp>
#include <limits>
#include <map>
#include <passes/light_overlap.hpp>
#include <random>

namespace prelight {
namespace {

/// A wall, and lights that together send what one of 30 cd does.
struct Stack : TestWorld {
    explicit Stack(uint32_t lights, float range = 20) {
        add_material({.name = "wall", .base_colour = {0.9f, 0.8f, 0.7f, 1}, .metallic = 0.2f, .roughness = 0.6f});
        add(square(4));
        Light light{.kind = LightKind::point, .intensity = 30.0f / static_cast<float>(lights), .range = range};
        for (uint32_t i = 0; i < lights; ++i)
            add_light(light, {0.3, 0.2, 3});
    }
    Shot shot() const { return {.world = &world, .camera = front_camera(4), .width = 16, .height = 12}; }
};

/// Largest relative error of a channel of a pixel.
double largest_error(const Image& picture, const Image& right) {
    double most = 0;
    for (size_t i = 0; i < right.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            EXPECT_TRUE(std::isfinite(picture.pixels[i][c]));
            EXPECT_GT(right.pixels[i][c], 0);
            most = std::max(most, std::abs(double(picture.pixels[i][c]) / double(right.pixels[i][c]) - 1));
        }
    return most;
}

/// Of `shot`'s way, `lights` lights against one.
double stack_error(Device& device, Shot shot, uint32_t lights, float range = 20) {
    const Stack one(1, range), many(lights, range);
    Shot exact = shot;
    exact.world = &one.world;
    if (shot.settings.contains("light-buffer") && shot.settings.at("light-buffer") == "r11g11b10f")
        exact.settings["light-sums"] = "float32"; // one light alone is 0.8 % off there
    static std::map<std::string, Image> known;    // for all numbers of lights, on the device of all tests
    const std::string name = fmt::format("{} {} {}", name_of(exact), static_cast<int>(exact.shading), range);
    if (&device != &test_device() || !known.contains(name))
        known[name] = render_linear(device, exact);
    const Image right = known.at(name);
    shot.world = &many.world;
    const double error = largest_error(render_linear(device, shot), right);
    std::printf("    %6u %s: %.3f %%\n", lights, name_of(shot).c_str(), error * 100);
    std::fflush(stdout);
    return error;
}

/// What adding up may lose. Half floats: up to 16 adds, each of which cuts off a step, at most 2⁻¹⁰ of the sum so far:
/// 17/2048 = 0.8 %. Full floats: N/2 steps of 2⁻²⁴, 0.2 % for 65,536 adds. The picture is stored as half floats: 0.1 %.
constexpr double stack_bound = 0.01;

/// The way builds light lists.
bool lists(const Shot& shot) {
    const auto is = [&](const char* key, const char* value) {
        const auto found = shot.settings.find(key);
        return found != shot.settings.end() && found->second == value;
    };
    return is("light-culling", "tiles") || is("light-culling", "clusters") || is("lights", "grid");
}

struct Many : testing::TestWithParam<uint32_t> {};

/// Ways that draw light by light: as many as there is time for with validation. Half floats lose 6 % of 300 lights
/// there.
constexpr uint32_t most_drawn = 3000;

TEST_P(Many, EqualLightsAreOneLightInEveryWay) {
    for (const Shot& shot : every_way(Stack(1).shot())) {
        // Minutes, for every cell lists every light: LightsWithoutARangeAddUpToo has 40,001 of them.
        const bool grid = shot.settings.contains("lights") && shot.settings.at("lights") == "grid";
        if (GetParam() > most_drawn && (!lists(shot) || grid))
            continue;
        SCOPED_TRACE(name_of(shot));
        EXPECT_LE(stack_error(test_device(), shot, GetParam()), stack_bound);
    }
    expect_validation_clean(test_device());
}
INSTANTIATE_TEST_SUITE_P(Lights, Many, testing::Values(1, 16, 17, 64, 1000, 3000, 20000, 40001, 65536));

// One of each kind with more: a draw for all lights, a draw a light, a loop over all lights.
TEST(LightStack, TensOfThousandsOfDrawnLightsAddUpToo) {
    Shot shot = Stack(1).shot();
    for (const char* culling : {"volumes", "rectangles"}) {
        shot.settings = {{"light-culling", culling}};
        EXPECT_LE(stack_error(test_device(), shot, 65536), stack_bound);
    }
    shot.settings = {{"light-culling", "fullscreen"}, {"light-writes", "once"}};
    EXPECT_LE(stack_error(test_device(), shot, 65536), stack_bound);
    shot.renderer = "multipass";
    shot.settings = {{"order", "objects"}};
    EXPECT_LE(stack_error(test_device(), shot, 20000), stack_bound);
    expect_validation_clean(test_device());
}

/// As every_way(), but what else there is.
std::vector<Shot> other_ways() {
    std::vector<Shot> shots;
    const auto add = [&](const char* renderer, std::map<std::string, std::string> settings,
                         Shading shading = Shading::ggx) {
        Shot& shot = shots.emplace_back(Stack(1).shot());
        shot.renderer = renderer, shot.settings = std::move(settings), shot.shading = shading;
    };
    for (const char* order : {"lights", "objects"})
        for (const char* each : {"1", "3", "8"})
            add("multipass", {{"order", order}, {"ambient", "per-object"}, {"lights-per-pass", each}});
    for (const char* culling : {"volumes", "rectangles", "stencil", "fullscreen", "tiles", "clusters"})
        add("deferred", {{"g-buffer", "killzone2"}, {"light-culling", culling}});
    for (const char* buffer : {"rgba16f", "packed-rgba16f", "r11g11b10f"})
        add("light-prepass", {{"light-buffer", buffer}, {"light-culling", "volumes"}});
    add("light-prepass", {{"light-writes", "once"}, {"light-culling", "fullscreen"}});
    add("light-prepass", {{"light-lists", "perfect"}, {"light-culling", "tiles"}});
    for (const char* way : {"fifth-channel", "luminance"})
        add("light-prepass", {{"specular", way}, {"light-culling", "volumes"}}, Shading::phong);
    add("light-prepass", {{"specular", "luv"}, {"light-culling", "tiles"}}, Shading::phong);
    add("light-prepass", {{"ambient", "light"}, {"light-culling", "volumes"}});
    return shots;
}

TEST(LightStack, OtherSettingsAddUpToo) {
    for (const Shot& shot : other_ways()) {
        SCOPED_TRACE(name_of(shot));
        EXPECT_LE(stack_error(test_device(), shot, 3000), stack_bound);
    }
    expect_validation_clean(test_device());
}

// Lights without a range are in every list, before the others.
TEST(LightStack, LightsWithoutARangeAddUpToo) {
    for (const Shot& shot : every_way(Stack(1).shot())) {
        SCOPED_TRACE(name_of(shot));
        const float endless = std::numeric_limits<float>::infinity();
        EXPECT_LE(stack_error(test_device(), shot, lists(shot) ? 40001 : 3000, endless), stack_bound);
    }
    expect_validation_clean(test_device());
}

// What keeps the others right: without it lavapipe, whose blending cuts off, loses half of the light.
TEST(LightStack, HalfFloatsAloneWouldLoseHalfOfTheLight) {
    for (const char* renderer : {"multipass", "light-prepass", "deferred"}) {
        Shot shot = Stack(1).shot();
        shot.renderer = renderer;
        shot.settings = {{"light-sums", "target"}};
        if (shot.renderer != "multipass")
            shot.settings["light-culling"] = "volumes";
        EXPECT_GT(stack_error(test_device(), shot, 3000), 0.3) << renderer;
    }
}

TEST(LightStack, CodesWrittenOnceCountEveryLight) {
    for (const char* buffer : {"rgba8", "packed-rgba8", "rgb10a2"})
        for (const char* culling : {"tiles", "clusters"}) {
            Shot shot = Stack(1).shot();
            shot.settings = {{"light-buffer", buffer}, {"light-culling", culling}, {"light-scale", "8"}};
            // Each round adds codes that are rounded to the nearest: half a step of 8/255 a pixel and round, which
            // cancel.
            const Stack one(1), many(40001);
            const auto mean = [&](const Stack& stack) {
                shot.world = &stack.world;
                double sum = 0;
                for (const glm::vec3& pixel : render_linear(test_device(), shot).pixels)
                    sum += double(pixel.x + pixel.y + pixel.z);
                return sum;
            };
            EXPECT_NEAR(mean(many) / mean(one), 1, 0.02) << buffer << " " << culling;
        }
}

TEST(LightStack, StatsSayWhatLightIsAddedUpIn) {
    const auto sums = [](const char* renderer, std::map<std::string, std::string> settings, uint32_t lights) {
        const Stack stack(lights);
        const auto made =
            create_renderer(renderer, &test_device(), {.width = 16, .height = 12, .settings = std::move(settings)});
        made->set_world(stack.world);
        made->render(stack.shot().camera);
        for (const std::string& note : made->stats().notes)
            EXPECT_NE(note.rfind("light-sums", 0), 0u) << note;
        return made->stats().settings.at("light-sums");
    };
    for (const char* culling : {"volumes", "rectangles", "stencil", "fullscreen"}) {
        EXPECT_EQ(sums("light-prepass", {{"light-culling", culling}}, 16), "target") << culling;
        EXPECT_EQ(sums("light-prepass", {{"light-culling", culling}}, 17), "float32") << culling;
        EXPECT_EQ(sums("deferred", {{"light-culling", culling}}, 17), "float32") << culling;
    }
    EXPECT_EQ(sums("light-prepass", {{"light-culling", "volumes"}, {"light-sums", "target"}}, 17), "target");
    EXPECT_EQ(sums("light-prepass", {{"light-culling", "volumes"}, {"light-buffer", "rgba8"}}, 17), "target");
    for (const char* written_once : {"tiles", "clusters"})
        EXPECT_EQ(sums("light-prepass", {{"light-culling", written_once}}, 3000), "target");
    EXPECT_EQ(sums("multipass", {}, 16), "target");
    EXPECT_EQ(sums("multipass", {}, 17), "float32");
    EXPECT_EQ(sums("multipass", {{"lights-per-pass", "8"}}, 128), "target");
    EXPECT_EQ(sums("z-prepass", {}, 128), "target");
    EXPECT_EQ(sums("z-prepass", {}, 129), "float32");
    EXPECT_EQ(sums("z-prepass", {{"lights", "grid"}}, 129), "target");
}

TEST(LightStack, ADeviceThatDoesNotBlendFullFloatsSaysWhatItLoses) {
    const auto device =
        Device::create({.select = "cpu", .validate = true, .hidden_formats = {VK_FORMAT_R32G32B32A32_SFLOAT}});
    const Stack stack(300);
    for (const char* renderer : {"multipass", "deferred"}) {
        RenderOptions options{.width = 16, .height = 12};
        if (renderer == std::string("deferred"))
            options.settings["light-culling"] = "volumes";
        const auto made = create_renderer(renderer, device.get(), options);
        made->set_world(stack.world);
        made->render(stack.shot().camera);
        EXPECT_EQ(made->stats().settings.at("light-sums"), "target");
        ASSERT_EQ(made->stats().notes.size(), 1u);
        EXPECT_THAT(made->stats().notes[0], testing::HasSubstr("up to 300 lights are added up in half floats"));
    }
    expect_validation_clean(*device);
}

// More lights than half floats take build the frame anew, and so do fewer again; changes on one side of that build
// nothing.
TEST(LightStack, OnlyLightsThatCrossTheBoundBuildAnew) {
    const Stack stack(40);
    const std::vector<PlacedLight>& lights = stack.world.lights;
    for (const char* renderer : {"multipass", "deferred"}) {
        RenderOptions options{.width = 16, .height = 12, .views = {"linear"}};
        if (renderer == std::string("deferred"))
            options.settings["light-culling"] = "volumes";
        const auto made = create_renderer(renderer, &test_device(), options);
        made->set_world(stack.world);
        made->render(stack.shot().camera);
        const auto built = [&](size_t count) {
            const VulkanCalls calls;
            made->set_lights(std::span(lights).first(count));
            made->render(stack.shot().camera);
            const bool wide = made->stats().settings.at("light-sums") == "float32";
            EXPECT_EQ(wide, count > 16) << count << " lights";
            return calls.descriptor_pools > 0;
        };
        for (const size_t count : {17, 30, 40, 17})
            EXPECT_FALSE(built(count)) << count << " lights";
        EXPECT_TRUE(built(16));
        for (const size_t count : {9, 16, 8})
            EXPECT_FALSE(built(count)) << count << " lights";
        EXPECT_TRUE(built(17));
    }
}

// Where few lights meet, an object's many others take nothing away from what one of them may send.
TEST(LightStack, ManyLightsElsewhereDoNotDimABrightOne) {
    Stack one(1);
    one.world.lights[0].light.intensity = 30000;
    Stack many(1);
    many.world.lights[0].light.intensity = 30000;
    for (int i = 0; i < 3000; ++i)
        many.add_light({.kind = LightKind::point, .intensity = 1, .range = 0.01f}, {3.9 - 0.0025 * i, 3.9, 0.005});
    Shot shot = one.shot();
    shot.renderer = "multipass";
    const Image right = render_linear(test_device(), shot);
    EXPECT_GT(right.pixels[6 * 16 + 8].x, 300); // far above 32,752 / 3,001
    shot.world = &many.world;
    EXPECT_LE(largest_error(render_linear(test_device(), shot), right), stack_bound);
}

TEST(LightOverlap, IsNeverLessThanWhatMeetsAnywhere) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-6, 6), range(0.1, 3);
    resident::Draw draw;
    draw.low = glm::dvec3(-5), draw.high = glm::dvec3(5, 1, 5);
    std::vector<PlacedLight> lights;
    for (int i = 0; i < 500; ++i)
        lights.push_back({{.kind = i % 50 == 0 ? LightKind::directional : LightKind::point,
                           .range = static_cast<float>(range(random))},
                          {place(random), place(random), place(random)}});
    const uint32_t most = passes::light_overlap(std::span(&draw, 1), lights);
    uint32_t met = 0;
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 point =
            glm::clamp(glm::dvec3(place(random), place(random), place(random)), draw.low, draw.high);
        met = std::max(met,
                       static_cast<uint32_t>(std::count_if(lights.begin(), lights.end(), [&](const PlacedLight& light) {
                           return light.light.kind == LightKind::directional ||
                                  glm::distance(light.position, point) <= double(light.light.range);
                       })));
    }
    EXPECT_GE(most, met);
    EXPECT_LE(most, 3 * met);
    lights.resize(200);
    for (size_t i = 0; i < lights.size(); ++i) // apart from each other
        lights[i] = {{.kind = LightKind::point, .range = 0.1f},
                     {0.9 * double(i % 11) - 4.5, 0, 0.5 * double(i / 11) - 4.5}};
    EXPECT_LE(passes::light_overlap(std::span(&draw, 1), lights), 4u);
    lights.assign(10, {{.intensity = 0, .range = 3}, glm::dvec3(0)});
    EXPECT_EQ(passes::light_overlap(std::span(&draw, 1), lights), 0u);
}

/// A device whose driver ends loops after few turns.
std::unique_ptr<Device> impatient_device(uint32_t turns) {
    auto device = Device::create({.select = "cpu", .validate = true});
    dynamic_cast<gpu::Context&>(*device).end_loops_after(turns);
    return device;
}

// What keeps them: lavapipe, taken for a device that does not end loops, loses half of these lights.
TEST(LightRounds, AreNeededByADriverThatEndsLoops) {
    const auto device = impatient_device(0);
    Shot shot = Stack(1).shot();
    shot.settings = {{"light-culling", "tiles"}, {"list-shading", "compute"}};
    EXPECT_GT(stack_error(*device, shot, 40001), 0.3);
}

// Lights in rounds, with every kind of light and with shadows: the same picture as in one.
TEST(LightRounds, AddUpToThePictureOfOneRound) {
    Garden garden;
    garden.scene.ambient = glm::vec3(0.05f);
    garden.add_lights(150, 3, 0.5f);
    for (int i = 0; i < 40; ++i) {
        garden.add_light(garden.spot(0.6f, 5, 1), garden.at(0.2 * i - 4, 3, 0.1 * i - 2), {0, -1, 0.1});
        if (i % 10 == 0) {
            garden.add_light(garden.point(std::numeric_limits<float>::infinity(), 0.1f), garden.at(i - 20, 5, 2));
            garden.add_light({.kind = LightKind::directional, .intensity = 0.05f}, garden.at(0, 0, 0),
                             {0.1, -1, 0.1 * i});
        }
    }
    // Turns for two rounds or three: a light with PCF takes 10 more on each pixel, and an invocation of compute has 8
    // pixels.
    constexpr uint32_t plain = 230, drawn = 1050, computed = 8000;
    const std::unique_ptr<Device> device = impatient_device(plain);
    for (const bool shadows : {false, true}) {
        Shot form = garden.shot();
        form.width = 96, form.height = 54;
        if (shadows)
            form.settings = {{"shadows", "on"}, {"shadow-budget", "1048576"}};
        for (const Shot& shot : every_way(form)) {
            if (!lists(shot) || (shadows && shot.renderer != "light-prepass"))
                continue;
            SCOPED_TRACE(name_of(shot));
            const bool computes =
                shot.settings.contains("list-shading") && shot.settings.at("list-shading") == "compute";
            dynamic_cast<gpu::Context&>(*device).end_loops_after(!shadows ? plain : computes ? computed : drawn);
            const Image right = render_linear(test_device(), shot), image = render_linear(*device, shot);
            const Comparison c = compare_pixels(image, right, std::vector<uint8_t>(image.pixels.size(), 0));
            EXPECT_GE(c.psnr, 60);
            EXPECT_LE(c.block, 0.5);
            EXPECT_FALSE(image.pixels == right.pixels && shot.renderer == "light-prepass") << "there was one round";
            expect_validation_clean(*device);
        }
    }
}

} // namespace
} // namespace prelight
