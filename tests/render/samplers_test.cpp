// Samplers do what they say with the default settings: each of glTF's filters and wrap modes, magnified and minified,
// against the reference.
#include "against_reference.hpp"
#include <cmath>
#include <filesystem>
#include <prelight/scene_io.hpp>
#include <reference/worlds.hpp>

namespace prelight {
namespace {

/// lavapipe compiles a shader for each state of a sampler: the others draw every third tile, all filters and all wraps.
bool drawn(const std::string& renderer, size_t i) {
    return renderer == device_renderers[0] || (i / 9 + i % 9 / 3 + i) % 3 == 0;
}
constexpr uint32_t columns = 12, rows = 9, tile = 32; ///< pixels

/// A tile for each of 2 magnification filters, 6 minification filters, 3 × 3 wrap modes, a pixel a unit.
struct Tiles : TestWorld {
    /// `texels`: under a pixel.
    Tiles(uint32_t size, float texels, const std::string& renderer = device_renderers[0]) {
        std::vector<uint8_t> rgba;
        uint32_t random = 1;
        for (uint32_t i = 0; i < size * size; ++i) {
            random = random * 1664525u + 1013904223u;
            rgba.insert(rgba.end(),
                        {uint8_t(random >> 24), uint8_t(random >> 16), uint8_t(i * 255 / (size * size)), 255});
        }
        const uint32_t image = add_image(size, size, std::move(rgba));
        Mesh mesh{"tiles", {}};
        uint32_t i = 0;
        for (const Filter mag : {Filter::nearest, Filter::linear})
            for (const Filter min : {Filter::nearest, Filter::linear})
                for (const MipFilter mip : {MipFilter::none, MipFilter::nearest, MipFilter::linear})
                    for (const Wrap s : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge})
                        for (const Wrap t : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge}) {
                            Material& material = add_material({.name = "tile", .unlit = true});
                            material.base_colour_texture = {.image = image, .sampler = {s, t, mag, min, mip}};
                            if (drawn(renderer, i)) {
                                mesh.primitives.push_back(
                                    one(i % columns, i / columns, texels / static_cast<float>(size)));
                                mesh.primitives.back().material = i;
                            }
                            ++i;
                        }
        scene.meshes.push_back(std::move(mesh));
        place(0, glm::dmat4(1));
    }
    /// `step`: of texture coordinates, from pixel to pixel.
    static Primitive one(uint32_t x, uint32_t y, float step) {
        Primitive p = square(1);
        for (size_t v = 0; v < 4; ++v) {
            const glm::vec2 corner = p.texcoords[0][v]; // in the middle of a wrap, off texels' edges
            p.texcoords[0][v] = step * float(tile) * (corner - 0.47f) + 0.51f;
            p.positions[v] = {float(tile) * (float(x) + corner.x - columns / 2.0f),
                              float(tile) * (rows / 2.0f - float(y) - corner.y), 0};
        }
        return p;
    }
    Shot shot(const std::string& renderer) const {
        Camera lens;
        lens.kind = ProjectionKind::orthographic;
        lens.ymag = tile * rows / 2.0;
        lens.znear = 1;
        lens.zfar = 100;
        return {.world = &world,
                .camera = look_at(lens, {0, 0, 10}, {0, 0, 0}),
                .width = tile * columns,
                .height = tile * rows,
                .settings = {{"texture-filter", "auto"}},
                .renderer = renderer};
    }
};

void expect_each_tile(uint32_t size, float texels, double bound) {
    const Tiles all(size, texels);
    const Shot first = all.shot(device_renderers[0]);
    const Image right = render_reference(all.world, first.camera, first.width, first.height, 0, form_of(first)).linear;
    for (const std::string& renderer : device_renderers) {
        const Tiles tiles(size, texels, renderer);
        const Image picture = render_linear(test_device(), tiles.shot(renderer));
        std::vector<double> most(columns * rows, 0);
        for (uint32_t y = 0; y < picture.height; ++y)
            for (uint32_t x = 0; x < picture.width; ++x)
                for (int c = 0; c < 3; ++c) {
                    double& worst = most[y / tile * columns + x / tile];
                    worst = std::max(worst, std::abs(static_cast<double>(picture.at(x, y)[c]) -
                                                     static_cast<double>(right.at(x, y)[c])));
                }
        for (size_t i = 0; i < most.size(); ++i) {
            if (!drawn(renderer, i))
                continue;
            EXPECT_LT(most[i], bound) << renderer << ": magFilter " << i / 54 << ", minFilter " << i / 9 % 6
                                      << ", wrap " << i % 9;
        }
    }
    expect_validation_clean(test_device());
}

TEST(Samplers, MagnifyAsTheySay) { expect_each_tile(8, 0.5f, 0.006); }

TEST(Samplers, MinifyAsTheySay) {
    expect_each_tile(64, 4, 0.012); // λ = 2
    expect_each_tile(64, 2, 0.012); // λ = 1
}

TEST(Samplers, OfCasesThatOthersReported) {
    const std::filesystem::path folder = std::filesystem::path(PRELIGHT_SHARED_SCENES) / ".." / "cases";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << "no cases beside the repository";
    for (const std::string& renderer : device_renderers) {
        const auto picture_of = [&](const char* name, const char* filter) {
            const Scene scene = load_gltf(folder / name);
            const World world = resolve(scene);
            return render_linear(test_device(), {.world = &world,
                                                 .camera = world.cameras.at(0),
                                                 .width = 256,
                                                 .height = 256,
                                                 .settings = {{"texture-filter", filter}},
                                                 .renderer = renderer});
        };
        const auto same = [&](const Image& a, const Image& b) {
            return compare_pixels(a, b, std::vector<uint8_t>(a.pixels.size())).psnr;
        };
        EXPECT_GE(same(picture_of("mag_nearest.glb", "auto"), picture_of("mag_nearest_right.glb", "auto")), 60)
            << renderer;
        EXPECT_GE(same(picture_of("mag_linear.glb", "auto"), picture_of("mag_linear.glb", "bilinear")), 60) << renderer;
    }
}

TEST(Samplers, AreTrilinearOnACpuUnlessAskedFor) {
    TestWorld plain;
    plain.add(square(1));
    for (const RendererInfo& info : renderer_infos()) {
        if (!info.needs_device)
            continue;
        const auto filter_of = [&](const std::map<std::string, std::string>& settings) {
            RenderOptions options{.width = 8, .height = 8};
            options.settings = settings;
            const auto renderer = create_renderer(info.name, &test_device(), options);
            renderer->set_world(plain.world);
            renderer->render(front_camera(3));
            return renderer->stats().settings.at("texture-filter");
        };
        EXPECT_EQ(filter_of({}), "trilinear") << info.name;
        EXPECT_EQ(filter_of({{"texture-filter", "anisotropic"}}), "anisotropic") << info.name;
        EXPECT_EQ(filter_of({{"texture-filter", "bilinear"}}), "bilinear") << info.name;
    }
}

} // namespace
} // namespace prelight
