// The material pass: every kind of material that the source texts name shades from one and the same light buffer, and a
// material may be a small file of the user's own.
#include "garden.hpp"
#include <prelight/material_shader.hpp>

namespace prelight {
namespace {

/// Six spheres that differ in nothing but their material's shader, under the same lights.
struct MaterialRow : TestWorld {
    static constexpr double step = 1.3;
    explicit MaterialRow(const std::vector<std::shared_ptr<const MaterialShader>>& shaders) {
        const double left = -0.5 * step * (double(shaders.size()) - 1);
        for (size_t i = 0; i < shaders.size(); ++i) {
            Material material{
                .name = "ball", .base_colour = {0.7f, 0.45f, 0.3f, 1}, .metallic = 0.3f, .roughness = 0.4f};
            material.shader = shaders[i];
            add_material(material);
            add(sphere(), glm::scale(glm::translate(glm::dmat4(1), {left + step * double(i), 0, 0}), glm::dvec3(0.55)));
            camera = front_camera(9, 0.173); // each ball in its own sixth of the picture
            // The same light on every ball: it moves along with them.
            add_light({.kind = LightKind::point, .colour = {1, 0.9f, 0.8f}, .intensity = 6, .range = 3.4f},
                      {left + step * double(i) + 0.9, 1.2, 1.6});
        }
        world.ambient = {0.05f, 0.05f, 0.06f};
    }
    PlacedCamera camera;
    Shot shot(Shading shading) const {
        return {.world = &world, .camera = camera, .width = 480, .height = 96, .shading = shading};
    }
};

std::vector<std::shared_ptr<const MaterialShader>> kinds() {
    std::vector<std::shared_ptr<const MaterialShader>> shaders;
    for (const char* name : {"metallic-roughness", "blinn-phong", "skin", "minnaert", "reflection", "fresnel-rim"})
        shaders.push_back(find_material_shader(name));
    return shaders;
}

TEST(MaterialPass, EveryKindOfMaterialReadsTheSameLightBuffer) {
    const MaterialRow row(kinds());
    for (const Shading shading : {Shading::ggx, Shading::phong}) {
        expect_agrees(row.shot(shading));
        RenderOptions options = options_of(row.shot(shading));
        options.views = {"diffuse-light", "linear"};
        const auto draw = [&](const World& world) {
            const auto renderer = create_renderer("light-prepass", &test_device(), options);
            renderer->set_world(world);
            renderer->render(row.camera);
            return std::pair(renderer->read("diffuse-light"), renderer->read("linear"));
        };
        const auto [light, picture] = draw(row.world);
        // Nothing of a material but its roughness is in the light buffer, and everything of it is in the picture.
        const MaterialRow plain(std::vector<std::shared_ptr<const MaterialShader>>(kinds().size()));
        const auto [same_light, plain_picture] = draw(plain.world);
        EXPECT_TRUE(light.pixels == same_light.pixels);
        for (size_t kind = 2; kind < kinds().size(); ++kind) {
            const auto column = static_cast<uint32_t>(480 * (double(kind) + 0.5) / double(kinds().size()));
            double difference = 0; // over the ball
            for (uint32_t y = 14; y < 82; ++y)
                for (uint32_t x = column - 34; x < column + 34; ++x)
                    difference += double(glm::length(picture.at(x, y) - plain_picture.at(x, y)));
            EXPECT_GT(difference, 5) << kinds()[kind]->name; // of some 3,600 pixels
        }
    }
}

/// A file as a user writes one: it bends the normal, knows its own roughness and holes, and shades from the sums alone.
constexpr const char* own_file = R"(
PARAMETERS {
    float dim DEFAULT(0.5) RANGE(0.0, 1.0);
};
Surface surface(Point p) {
    Surface s = gltf_surface(p);
    s.normal = normalize(s.normal + vec3(0.5, 0.0, 0.0));
    s.roughness = 0.6;
    s.alpha = fract(p.position.y * 4.0) < 0.5 ? 1.0 : 0.0;
    return s;
}
vec3 shade(Point p, Surface s, Light light) { return dim * light.diffuse + light.specular; }
)";

TEST(CustomMaterial, SurfaceFillsTheFirstPassAndShadeGetsTheLightBuffer) {
    TestWorld world;
    Material material{.name = "wall", .metallic = 0, .roughness = 0.3f, .alpha_mode = AlphaMode::mask};
    material.shader = parse_material_shader("own.glsl", "own.glsl", own_file);
    world.add_material(material);
    world.add(square(1));
    world.add_light({.kind = LightKind::point, .intensity = 4, .range = 9}, {0.4, 0.3, 2});
    RenderOptions options{
        .width = 64, .height = 64, .shading = Shading::phong, .settings = {{"texture-filter", "bilinear"}}};
    options.views = {"normal", "roughness", "depth", "diffuse-sum", "specular-sum", "linear"};
    const auto renderer = create_renderer("light-prepass", &test_device(), options);
    renderer->set_world(world.world);
    renderer->render(front_camera(2));
    const Image normal = renderer->read("normal"), roughness = renderer->read("roughness"),
                depth = renderer->read("depth");
    const Image diffuse = renderer->read("diffuse-sum"), specular = renderer->read("specular-sum"),
                picture = renderer->read("linear");
    const float bent = 0.5f / std::sqrt(1.25f) * 0.5f + 0.5f;
    size_t there = 0, holes = 0;
    for (uint32_t y = 18; y < 46; ++y)
        for (uint32_t x = 18; x < 46; ++x) {
            if (depth.at(x, y).r == 0) { // the first pass discards, and nothing after it has to
                EXPECT_EQ(picture.at(x, y), glm::vec3(0));
                ++holes;
                continue;
            }
            ++there;
            ASSERT_NEAR(normal.at(x, y).r, bent, 0.01) << "surface() bends the stored normal";
            ASSERT_NEAR(roughness.at(x, y).r, 0.6f, 0.01) << "and stores its own roughness";
            const glm::vec3 expected = 0.5f * diffuse.at(x, y) + specular.at(x, y);
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(picture.at(x, y)[c], expected[c], 2e-3 + 2e-3 * double(expected[c]))
                    << "shade() has the sums, and no more";
        }
    EXPECT_GT(there, 200u);
    EXPECT_GT(holes, 200u);
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
