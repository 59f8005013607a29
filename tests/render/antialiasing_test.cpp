// Anti-aliasing of finished pictures, in every renderer; what the filters do to a picture is in
// tests/gpu/post_filter_test.cpp.
#include "garden.hpp"
#include <cmath>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

struct Filtered {
    Image final, linear;
    Stats stats;
};

Filtered render_filtered(Device& device, Shot shot, const std::string& word) {
    shot.settings["antialiasing"] = word;
    RenderOptions options = options_of(shot);
    options.views = {};
    const auto renderer = create_renderer(shot.renderer, &device, options);
    renderer->set_world(*shot.world);
    renderer->render(shot.camera);
    Image final = renderer->read("final");
    return {std::move(final), renderer->read("linear"), renderer->stats()};
}

size_t pixels_that_differ(const Image& a, const Image& b) {
    size_t count = 0;
    for (size_t i = 0; i < a.pixels.size(); ++i)
        count += a.pixels[i] != b.pixels[i];
    return count;
}

void expect_filtered_in_every_renderer(Device& device) {
    Garden garden;
    garden.add_lights(6, 6, 5);
    for (const std::string& renderer : device_renderers) {
        SCOPED_TRACE(renderer);
        Shot shot = garden.shot();
        shot.width = 160, shot.height = 90;
        shot.renderer = renderer;
        const Filtered plain = render_filtered(device, shot, "none");
        for (const char* word : {"edge-blur", "smaa"}) {
            const Filtered got = render_filtered(device, shot, word);
            EXPECT_EQ(got.stats.settings.at("antialiasing"), word);
            const size_t changed = pixels_that_differ(got.final, plain.final);
            EXPECT_GT(changed, 200u) << word;
            EXPECT_LT(changed, plain.final.pixels.size() / 4) << word;
            EXPECT_TRUE(got.linear.pixels == plain.linear.pixels) << word;
        }
        expect_validation_clean(device);
    }
}

TEST(Antialiasing, SmoothsThePictureAndNotTheLinearOne) { expect_filtered_in_every_renderer(test_device()); }

TEST(Antialiasing, SmoothsThePictureOnASecondDriver) {
    Device* const device = swiftshader_device();
    if (!device)
        GTEST_SKIP() << "SwiftShader is not installed (Debian's package chromium)";
    expect_filtered_in_every_renderer(*device);
}

TEST(Antialiasing, LeavesALitWallAlone) {
    TestWorld scene;
    scene.add(square(20), glm::rotate(glm::dmat4(1), 0.6, {0.6, 0.8, 0}));
    scene.add_light({.kind = LightKind::point, .intensity = 30, .range = 20}, {1, 1, 3});
    scene.world.ambient = glm::vec3(0.1f);
    for (const std::string& renderer : device_renderers)
        for (const bool parallel : {false, true}) {
            Shot shot{.world = &scene.world, .camera = front_camera(4), .width = 160, .height = 90};
            if (parallel)
                shot.camera = look_at({.kind = ProjectionKind::orthographic, .ymag = 2, .znear = 1, .zfar = 30},
                                      {0, 0, 4}, {0, 0, 0});
            shot.renderer = renderer;
            const Image plain = render_filtered(test_device(), shot, "none").final;
            for (const char* word : {"edge-blur", "smaa"})
                EXPECT_EQ(pixels_that_differ(render_filtered(test_device(), shot, word).final, plain), 0u)
                    << renderer << " " << parallel << " " << word;
        }
    expect_validation_clean(test_device());
}

// Two faces 50° apart, in two greys: depth bends by less than a pixel a pixel, normals tell.
TEST(Antialiasing, BlursCreasesWhereThereAreNormals) {
    TestWorld scene;
    for (const double side : {-1.0, 1.0}) {
        const float grey = side < 0 ? 0.2f : 0.9f;
        scene.add_material({.name = "face", .base_colour = {grey, grey, grey, 1}, .double_sided = true, .unlit = true});
        const glm::dmat4 turned = glm::rotate(glm::dmat4(1), side * glm::radians(25.0), {0, 1, 0});
        scene.add(square(4), turned * glm::translate(glm::dmat4(1), {side * 4, 0, 0}));
    }
    for (const std::string& renderer : device_renderers) {
        const bool normals = renderer == "light-prepass" || renderer == "deferred";
        Shot shot{.world = &scene.world, .camera = front_camera(5), .width = 160, .height = 90};
        shot.renderer = renderer;
        const Image plain = render_filtered(test_device(), shot, "none").final;
        const size_t blurred = pixels_that_differ(render_filtered(test_device(), shot, "edge-blur").final, plain);
        EXPECT_EQ(blurred, normals ? 2u * 90 : 0u) << renderer;
        // Every way that normals and depth may be stored finds it.
        for (const auto& [key, value] : std::map<std::string, std::string>{
                 {"normals", "oct16"}, {"normal-space", "view"}, {"depth", "r16f"}, {"g-buffer", "killzone2"}}) {
            const bool has = key == "g-buffer" ? renderer == "deferred" : renderer == "light-prepass";
            if (!has)
                continue;
            shot.settings = {{key, value}};
            EXPECT_EQ(pixels_that_differ(render_filtered(test_device(), shot, "edge-blur").final, plain), 2u * 90)
                << key << "=" << value;
        }
    }
    expect_validation_clean(test_device());
}

/// RMS error against the mean of 8×8 times as many pixels, in linear light of what is displayed: where they differ, and
/// elsewhere.
struct PictureError {
    double edges = 0, others = 0, edge_share = 0;

    PictureError(const Image& picture, const Image& large) {
        size_t edge_count = 0;
        constexpr uint32_t times = 8;
        for (uint32_t y = 0; y < picture.height; ++y)
            for (uint32_t x = 0; x < picture.width; ++x) {
                glm::vec3 mean(0), low(1), high(0);
                for (uint32_t i = 0; i < times * times; ++i) {
                    const glm::vec3 sample = large.at(times * x + i % times, times * y + i / times);
                    low = glm::min(low, sample), high = glm::max(high, sample);
                    mean += linear(sample) / float(times * times);
                }
                const glm::vec3 off = linear(picture.at(x, y)) - mean, span = high - low;
                const bool edge = std::max({span.r, span.g, span.b}) >= 0.1f;
                (edge ? edges : others) += static_cast<double>(glm::dot(off, off)) / 3;
                edge_count += edge;
            }
        const auto count = static_cast<double>(picture.pixels.size());
        edge_share = static_cast<double>(edge_count) / count;
        edges = std::sqrt(edges / (count * edge_share));
        others = std::sqrt(others / (count * (1 - edge_share)));
    }
    static glm::vec3 linear(glm::vec3 c) { return {srgb_decode(c.r), srgb_decode(c.g), srgb_decode(c.b)}; }
};

struct SceneBound {
    const char* name;
    uint32_t lights;
    double blur, smaa, samples; ///< by which they divide the error of edge pixels, at least
};

/// Each pixel the mean of four, in linear light.
Image halved(const Image& large) {
    Image out(large.width / 2, large.height / 2);
    for (uint32_t y = 0; y < out.height; ++y)
        for (uint32_t x = 0; x < out.width; ++x) {
            glm::vec3 sum(0);
            for (uint32_t i = 0; i < 4; ++i)
                sum += PictureError::linear(large.at(2 * x + i % 2, 2 * y + i / 2));
            for (int c = 0; c < 3; ++c)
                out.at(x, y)[c] = srgb_encode(sum[c] / 4);
        }
    return out;
}

TEST(Antialiasing, ComesCloserToAPictureOfManySamples) {
    for (const SceneBound& bound : {SceneBound{"city", 32, 1.3, 1.15, 1.5}, {"shadows", 4, 1.8, 1.45, 2}}) {
        const Scene scene = make_scene(bound.name, bound.lights, 1);
        const World world = resolve(scene);
        Shot shot{.world = &world, .camera = world.cameras.at(0), .width = 240, .height = 135};
        std::map<std::string, PictureError> errors;
        Shot large = shot;
        large.width *= 8, large.height *= 8;
        const Image many = view_of(large, "final");
        const auto add = [&](const std::string& word, const Image& picture) {
            const PictureError error(picture, many);
            std::printf("    %s, %s: RMS %.4f of %.1f %% edge pixels, %.4f of the others\n", bound.name, word.c_str(),
                        error.edges, 100 * error.edge_share, error.others);
            errors.emplace(word, error);
        };
        for (const char* word : {"none", "edge-blur", "smaa"}) {
            shot.settings["antialiasing"] = word;
            add(word, view_of(shot, "final"));
        }
        shot.settings.clear();
        Shot sampled = shot;
        sampled.samples = 4;
        for (const char* word : {"edges", "samples", "pixel"}) {
            sampled.settings["msaa-light"] = word;
            add(word, view_of(sampled, "final"));
        }
        sampled.settings = {{"msaa-material", "sample"}};
        add("material of samples", view_of(sampled, "final"));
        sampled.settings.clear();
        sampled.renderer = "z-prepass";
        add("z-prepass", view_of(sampled, "final"));
        Shot twice = shot;
        twice.width *= 2, twice.height *= 2;
        add("2x2 supersampled", halved(view_of(twice, "final")));
        const double without = errors.at("none").edges;
        EXPECT_GT(without, bound.blur * errors.at("edge-blur").edges) << bound.name;
        EXPECT_GT(without, bound.smaa * errors.at("smaa").edges) << bound.name;
        EXPECT_GT(without, bound.samples * errors.at("edges").edges) << bound.name;
        EXPECT_LT(errors.at("edges").edges, 1.05 * errors.at("samples").edges) << bound.name;
        // It finds edges, so that it leaves the rest alone; a blur by geometry takes what lies beside an edge along.
        EXPECT_LT(errors.at("smaa").others, 1.5 * errors.at("none").others) << bound.name;
    }
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
