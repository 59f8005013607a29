// What glTF materials and nodes can be, seen by the light pre-pass and by the reference.
#include "garden.hpp"
#include <cmath>

namespace prelight {
namespace {

/// 64 × 64 texels from a function of u, v in 0 … 1.
template <class F>
uint32_t add_picture(TestWorld& world, F texel) {
    constexpr uint32_t size = 64;
    std::vector<uint8_t> rgba;
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x) {
            const glm::vec4 v = texel((x + 0.5f) / size, (y + 0.5f) / size);
            for (int c = 0; c < 4; ++c)
                rgba.push_back(static_cast<uint8_t>(std::lround(255 * glm::clamp(v[c], 0.0f, 1.0f))));
        }
    return world.add_image(size, size, std::move(rgba));
}

constexpr float tau = 6.2831853f;

/// A wall of four by two squares whose materials use all five textures.
struct TexturedWall : TestWorld {
    explicit TexturedWall(Sampler sampler = {}) {
        const uint32_t colour = add_picture(*this, [](float u, float v) {
            return glm::vec4(0.5f + 0.4f * std::sin(tau * u), 0.5f + 0.4f * std::sin(tau * v), 0.6f, 1);
        });
        const uint32_t surface = add_picture(*this, [](float u, float v) {
            return glm::vec4(0, 0.5f + 0.2f * std::cos(tau * v), 0.5f + 0.5f * std::cos(tau * u), 1);
        });
        const uint32_t bumps = add_picture(*this, [](float u, float v) {
            const glm::vec3 n = glm::normalize(glm::vec3(0.35f * std::sin(2 * tau * u), 0.35f * std::sin(tau * v), 1));
            return glm::vec4(n * 0.5f + 0.5f, 1);
        });
        const uint32_t shade = add_picture(*this, [](float u, float) { return glm::vec4(u, 0, 0, 1); });
        const uint32_t glow = add_picture(*this, [](float u, float v) { return glm::vec4(u * v, 0.2f * u, 0.1f, 1); });
        Material material{.name = "wall", .base_colour = {0.9f, 0.9f, 0.9f, 1}, .emissive = {0.4f, 0.4f, 0.4f}};
        material.normal_scale = 0.8f;
        material.occlusion_strength = 0.7f;
        material.base_colour_texture = {.image = colour, .sampler = sampler};
        material.metallic_roughness_texture = {.image = surface, .sampler = sampler};
        material.normal_texture = {.image = bumps, .sampler = sampler};
        material.occlusion_texture = {.image = shade, .sampler = sampler};
        material.emissive_texture = {
            .image = glow, .sampler = sampler, .uv_linear = glm::mat2(0, 1, -1, 0), .uv_offset = {0.25f, 0.1f}};
        add_material(material);
        add(square(2));
        add_light({.kind = LightKind::point, .intensity = 14, .range = 9}, {1.5, 1, 2});
        add_light({.kind = LightKind::point, .colour = {0.5f, 0.7f, 1}, .intensity = 10, .range = 9}, {-1.5, -1, 1.5});
        world.ambient = {0.1f, 0.1f, 0.1f};
    }
    Shot shot() const { return {.world = &world, .camera = front_camera(4.5)}; }
};

TEST(Textures, AllFiveAgreeWithTheReference) {
    const TexturedWall wall;
    expect_agrees(wall.shot());
}

TEST(Textures, AllFiveInPhong) {
    const TexturedWall wall;
    Shot shot = wall.shot();
    shot.shading = Shading::phong;
    shot.exposure = -1;
    expect_agrees(shot);
}

TEST(Textures, WrapModesAndSecondTexcoordSet) {
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge}) {
        TexturedWall wall({.wrap_s = wrap, .wrap_t = wrap});
        Primitive& primitive = wall.scene.meshes[0].primitives[0];
        for (const glm::vec2& uv : primitive.texcoords[0])
            primitive.texcoords[1].push_back(uv * 1.7f - 0.4f);
        wall.scene.materials[0].base_colour_texture.texcoord = 1;
        wall.scene.materials[0].normal_texture.texcoord = 1;
        expect_agrees(wall.shot());
    }
}

TEST(Textures, MirroredInstanceShowsTheMirroredPicture) {
    TexturedWall wall;
    expect_agrees(wall.shot());
    const Image straight = render_linear(test_device(), wall.shot());
    // Mirror everything at x = 0: the picture is the same with left and right exchanged.
    wall.world.instances[0].transform = glm::scale(glm::dmat4(1), {-1, 1, 1});
    wall.world.instances[0].mirrored = true;
    for (PlacedLight& light : wall.world.lights)
        light.position.x *= -1;
    expect_agrees(wall.shot());
    Image mirrored = render_linear(test_device(), wall.shot());
    for (uint32_t y = 0; y < mirrored.height; ++y)
        std::reverse(&mirrored.at(0, y), &mirrored.at(0, y) + mirrored.width);
    EXPECT_GE(compare_pixels(mirrored, straight).psnr, 50);
}

TEST(Materials, AlphaMaskVertexColourDoubleSidedUnlit) {
    TestWorld world;
    const uint32_t holes = add_picture(world, [](float u, float v) {
        return glm::vec4(1, 1, 1, 0.5f + 0.5f * std::sin(2 * tau * u) * std::sin(2 * tau * v));
    });
    Material masked{.name = "masked",
                    .metallic = 0,
                    .roughness = 0.7f,
                    .alpha_mode = AlphaMode::mask,
                    .alpha_cutoff = 0.4f,
                    .double_sided = true};
    masked.base_colour_texture = {.image = holes};
    world.add_material(masked);
    Primitive front = square(1);
    front.colours = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 1}};
    world.add(front, glm::translate(glm::dmat4(1), {-1.1, 0, 0}));
    // The same seen from behind: double-sided, lit from the viewer's side.
    world.add(front, glm::rotate(glm::translate(glm::dmat4(1), {1.1, 0, 0}), 2.7, {0, 1, 0}));
    world.add_material({.name = "unlit", .base_colour = {0.2f, 0.6f, 0.3f, 1}, .unlit = true});
    world.add(square(4), glm::translate(glm::dmat4(1), {0, 0, -2}));
    // Single-sided and turned away: not there.
    world.add_material({.name = "away", .base_colour = {1, 0, 1, 1}});
    world.add(square(0.5f), glm::rotate(glm::translate(glm::dmat4(1), {0, 0, 1}), 3.0, {0, 1, 0}));
    world.add_light({.kind = LightKind::point, .intensity = 14, .range = 12}, {0.5, 1, 3});
    expect_agrees({.world = &world.world, .camera = front_camera(5)});
}

TEST(Nodes, FlattenedToAPlaneAreStillThere) {
    Garden garden;
    garden.add_lights(6, 5, 6);
    const size_t sphere = garden.scene.meshes.size() - 1;
    glm::dmat4 flat = glm::translate(glm::dmat4(1), glm::dvec3(0, 1.2, 3));
    flat = glm::scale(flat, glm::dvec3(1, 1, 0));
    garden.place(static_cast<uint32_t>(sphere), flat);
    // Front and back lie in one plane: only the front half, which the z-test may pick, is compared.
    Scene& scene = garden.scene;
    std::vector<uint32_t>& indices = scene.meshes[sphere].primitives[0].indices;
    std::vector<uint32_t> front;
    for (size_t i = 0; i < indices.size(); i += 3)
        if (scene.meshes[sphere].primitives[0].positions[indices[i]].z > 0.05f)
            front.insert(front.end(), indices.begin() + static_cast<long>(i),
                         indices.begin() + static_cast<long>(i) + 3);
    indices = front;
    expect_agrees(garden.shot());
}

TEST(Determinism, TwoRunsGiveTheSameBytes) {
    Garden garden;
    garden.add_lights(80, 4, 3);
    const Image first = render_linear(test_device(), garden.shot());
    const Image second = render_linear(test_device(), garden.shot());
    EXPECT_TRUE(first.pixels == second.pixels);
}

TEST(Determinism, AFrameDoesNotDependOnTheOneBefore) {
    Garden garden;
    garden.add_lights(8, 4, 3);
    RenderOptions options;
    options.width = 160;
    options.height = 90;
    const auto renderer = create_renderer("light-prepass", &test_device(), options);
    renderer->set_world(garden.world);
    renderer->render(garden.camera, 3);
    const Image first = renderer->read("final");
    PlacedCamera other = garden.camera;
    other.position.y += 3;
    renderer->render(other);
    EXPECT_FALSE(renderer->read("final").pixels == first.pixels);
    renderer->render(garden.camera);
    EXPECT_TRUE(renderer->read("final").pixels == first.pixels);
    expect_validation_clean(test_device());
}

TEST(Views, EveryBufferCanBeSeen) {
    const TexturedWall wall;
    RenderOptions options;
    options.width = 160;
    options.height = 90;
    for (const RendererInfo& info : renderer_infos())
        if (info.name == "light-prepass")
            options.views = info.views;
    for (const char* buffer : {"rgba16f", "packed-rgba16f", "packed-rgba8"}) {
        options.settings["light-buffer"] = buffer;
        const auto renderer = create_renderer("light-prepass", &test_device(), options);
        renderer->set_world(wall.world);
        renderer->render(wall.shot().camera);
        for (const std::string& view : options.views) {
            const Image image = renderer->read(view);
            float low = 1e9f, high = -1e9f;
            for (const glm::vec3& p : image.pixels) {
                low = std::min({low, p.x, p.y, p.z});
                high = std::max({high, p.x, p.y, p.z});
            }
            EXPECT_GE(low, 0) << view;
            if (view == "ambient-occlusion" || view == "edges" || view == "layers")
                continue; // a wall alone has none
            EXPECT_GT(high - low, 0.1f) << view << " is black or flat";
        }
    }
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
