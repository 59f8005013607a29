// Blended surfaces against the reference, which composes them hit by hit.
#include "panes.hpp"

namespace prelight {
namespace {

/// The garden behind glass of every kind, none of which meets another.
struct Glasshouse : Garden {
    Glasshouse() {
        add_lights(14, 5, 4);
        add_light(spot(0.7f, 9, 20), {1, 4, 3}, {0, -1, -0.2});
        add_light(point(2.5f, 6), {-0.5, 1.2, 3.4}); // before all that is opaque
        world.ambient = glm::vec3(0.05f);
        const uint32_t spots = add_image(4, 4, dots());
        Material glass{.name = "glass", .base_colour = {0.6f, 0.8f, 0.9f, 0.35f}, .metallic = 0, .roughness = 0.4f};
        glass.alpha_mode = AlphaMode::blend;
        glass.double_sided = true;
        add_material(glass);
        add(sphere(48), glm::scale(placed_at(-2.2, 1.5, 1.4), glm::dvec3(0.7)));
        glass.name = "print", glass.base_colour = {0.9f, 0.5f, 0.3f, 0.8f}, glass.emissive = {0.03f, 0, 0.05f};
        glass.base_colour_texture = {.image = spots};
        add_material(glass);
        Primitive tinted = square(0.9f);
        tinted.colours = {{1, 1, 1, 1}, {0.5f, 1, 1, 0.4f}, {1, 0.6f, 1, 0.9f}, {1, 1, 0.3f, 0.6f}};
        add(tinted, glm::rotate(placed_at(0.2, 1.1, 2), 0.3, glm::dvec3(0, 1, 0)));
        add(tinted, glm::scale(placed_at(2.1, 1.2, 1.7), {-1, 1, 1})); // mirrored
        add_material(unlit_material("film", {0.3f, 0.5f, 0.2f, 0.3f}));
        add(square(0.8f), placed_at(0.9, 1.3, 2.9));
        Material net{.name = "net", .metallic = 0, .roughness = 0.7f, .alpha_mode = AlphaMode::mask};
        net.base_colour_texture = {.image = spots};
        net.double_sided = true;
        add_material(net);
        add(square(0.7f), placed_at(-0.6, 1.4, 2.5));
    }
    static std::vector<uint8_t> dots() {
        std::vector<uint8_t> rgba;
        for (uint32_t i = 0; i < 16; ++i)
            rgba.insert(rgba.end(), {255, static_cast<uint8_t>(140 + 7 * i), 200,
                                     static_cast<uint8_t>((i / 4 + i) % 2 ? 230 : 60)});
        return rgba;
    }
};

class TransparencyOf : public testing::TestWithParam<Shot> {};

INSTANTIATE_TEST_SUITE_P(All, TransparencyOf, testing::ValuesIn(every_blended_way()), way_name);

TEST_P(TransparencyOf, AGlasshouseAgreesWithTheReference) {
    static const Glasshouse house;
    static References references;
    const Shot shot = in_way(house.shot(), GetParam());
    const ReferencePicture& reference = references.of(shot);
    const Image picture = render_linear(test_device(), shot);
    save_when_wanted(picture, reference);
    expect_within(compare_pixels(picture, reference.linear, reference.left_out()), half_float_bound);
    expect_validation_clean(test_device());
}

TEST(TransparencyForms, AgreeWithTheReference) {
    Glasshouse house;
    References references;
    for (const std::string& name : device_renderers) {
        Shot shot = house.shot();
        shot.renderer = name;
        references.expect_agrees(shot); // with the renderer's own form of Fresnel
        shot.shading = Shading::phong;
        shot.exposure = -2;
        references.expect_agrees(shot);
    }
    house.camera.camera.kind = ProjectionKind::orthographic;
    house.camera.camera.ymag = 3;
    house.camera.camera.zfar = 30;
    expect_agrees(house.shot());
}

TEST(TransparencyForms, ShadowsAndSurroundingsLieOnGlass) {
    Glasshouse house;
    auto sky = std::make_shared<Environment>();
    sky->name = "sky";
    sky->image = Image(32, 16);
    for (size_t i = 0; i < sky->image.pixels.size(); ++i) // smooth, and another colour in each direction
        sky->image.pixels[i] = {0.3f + 0.2f * std::sin(static_cast<float>(i % 32) * 0.19635f),
                                0.25f + 0.01f * static_cast<float>(i / 32), 0.4f};
    house.scene.environment = sky;
    for (PlacedLight& light : house.world.lights)
        light.light.casts_shadow = &light == &house.world.lights[14]; // the spot
    References references;
    for (const char* how : {"lists", "sorted", "peeled"})
        for (const bool shadows : {false, true}) {
            SCOPED_TRACE(std::string(how) + (shadows ? " with shadows" : ""));
            Shot shot = house.shot();
            shot.settings = {{"transparency", how}};
            if (shadows)
                shot.settings.insert({{"shadows", "on"}, {"shadow-filter", "hard"}, {"shadow-detail", "8"}});
            const ReferencePicture& reference = references.of(shot);
            const Image picture = render_linear(test_device(), shot);
            save_when_wanted(picture, reference);
            expect_within(compare_pixels(picture, reference.linear, reference.left_out()),
                          shadows ? Bound{.left_out = 0.15} : half_float_bound);
        }
    expect_validation_clean(test_device());
}

TEST(TransparencyForms, SamplesOfLayersAgree) {
    const Glasshouse house;
    References references;
    for (const std::string& name : device_renderers)
        for (const char* how : {"lists", "sorted", "peeled"}) {
            SCOPED_TRACE(name + " " + how);
            Shot shot = with_samples(house.shot(), 448);
            shot.renderer = name;
            shot.settings = {{"transparency", how}};
            const ReferencePicture& reference = references.of(shot);
            const Image picture = render_linear(test_device(), shot);
            save_when_wanted(picture, reference);
            expect_within_on_edges(picture, reference);
        }
    expect_validation_clean(test_device());
}

TEST(TransparencyForms, LessGeometryMakesNoDifference) {
    const Glasshouse house;
    expect_same_with_less_geometry(house.shot());
}

} // namespace
} // namespace prelight
