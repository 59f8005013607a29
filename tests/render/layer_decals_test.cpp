// Decals on blended surfaces, against the reference's own form of them.
#include "decal_world.hpp"
#include "panes.hpp"
#include <prelight/material_shader.hpp>

namespace prelight {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/// Two blended panes on which decals lie: with every channel, overlapping, mirrored, beside their edges.
struct PaneWithDecals : DecalGarden {
    explicit PaneWithDecals(std::shared_ptr<const MaterialShader> shader = nullptr) {
        std::erase_if(world.decals, [](const PlacedDecal& decal) { // a few beside the panes
            return decal.transform[3].x < 2.3 && decal.transform[3].x > -3;
        });
        add_lights(8, 5, 5);
        Material pane{.name = "pane", .metallic = 0.1f, .roughness = 0.4f};
        pane.base_colour = {0.7f, 0.8f, 0.9f, 0.6f};
        pane.alpha_mode = AlphaMode::blend;
        pane.double_sided = true;
        pane.shader = std::move(shader);
        add_material(pane);
        place = glm::rotate(placed_at(0, 1, 2), -0.2, {1, 0, 0});
        add(square(1.2f), place);
        add(square(0.6f), glm::rotate(placed_at(-1.6, 0.8, 2.4), 0.5, {0, 1, 0}));
        const glm::dvec3 out(place[2]);
        add_decal({.material = painted, .order = 3}, {-0.4, 1, 2}, out, 0.4, {1.1, 0.9, 0.5});
        add_decal({.material = bumpy, .opacity = 0.9f, .order = 4}, {0, 1.2, 2}, out, -0.3, {0.9, 0.9, 0.5});
        add_decal({.material = bumpy, .order = 5, .colour = false}, {0.7, 0.7, 2}, out, 0.9, {-0.8, 0.7, 0.5});
        add_decal({.material = dull, .order = 6, .normal = false}, {0.6, 1.5, 2}, out, 0, {0.8, 0.9, 0.6});
        world.ambient = glm::vec3(0.1f);
    }
    glm::dmat4 place{1};
    Shot shot() const { return {.world = &world, .camera = camera, .width = 240, .height = 135}; }
};

TEST(LayerDecals, AgreeWithTheReferenceInEveryArchitecture) {
    const PaneWithDecals garden;
    const auto expect = [&](const std::string& renderer, const std::map<std::string, std::string>& settings) {
        Shot shot = with(garden.shot(), settings);
        shot.renderer = renderer;
        expect_agrees(shot);
    };
    for (const std::string& renderer : device_renderers)
        expect(renderer, {});
    for (const char* transparency : {"sorted", "peeled"})
        expect("light-prepass", {{"transparency", transparency}});
    for (const char* model : {"weighted", "nv"}) // without and with the point's normal
        expect("inferred", {{"inferred-scale", "1"}, {"model", model}});
    expect("inferred", {{"inferred-scale", "5/8"}});
}

// Opaque surfaces look at each sample's decals, blended ones at a fragment's.
TEST(LayerDecals, WithFourSamplesAPixel) {
    PaneWithDecals garden;
    std::erase_if(garden.world.decals, [](const PlacedDecal& decal) { return decal.decal.order < 3; });
    for (size_t i = 1; i + 2 < garden.world.instances.size(); ++i) // all but the floor: their normal maps are a
        garden.world.instances[i].visible = false;                 // fragment's, and not what is looked at here
    Shot shot = garden.shot();
    shot.samples = 4;
    expect_agrees(shot);
}

TEST(LayerDecals, LieOnMaterialsOfTheirOwn) {
    for (const char* material : {"skin", "layered"})
        expect_agrees(PaneWithDecals(find_material_shader(material)).shot());
}

TEST(LayerDecals, AreSeen) {
    PaneWithDecals garden;
    const Image with_them = render_linear(test_device(), garden.shot());
    garden.world.instances.back().receives_decals = false;
    (garden.world.instances.end() - 2)->receives_decals = false;
    const Image without = render_linear(test_device(), garden.shot());
    EXPECT_LT(compare_pixels(with_them, without, std::vector<uint8_t>(without.pixels.size(), 0)).psnr, 35);
    expect_agrees(garden.shot());
}

TEST(LayerDecals, FollowWhatMoves) {
    PaneWithDecals garden;
    const auto renderer = create_renderer("light-prepass", &test_device(), options_of(garden.shot()));
    renderer->set_world(garden.world);
    renderer->render(garden.camera);
    garden.world.decals[garden.world.decals.size() - 1].transform[3].x -= 0.7;
    renderer->update_world({.decals = true});
    const uint32_t pane = static_cast<uint32_t>(garden.world.instances.size() - 2);
    garden.world.instances[pane].transform[3].x += 0.15;
    renderer->update_world({.instances = {pane}});
    for (int frame = 0; frame < 3; ++frame) // each slot's lists
        renderer->render(garden.camera);
    EXPECT_TRUE(renderer->read("linear").pixels == render_linear(test_device(), garden.shot()).pixels);
    expect_validation_clean(test_device());
}

// The uppermost four lie on it, and the statistics say how many do not.
TEST(LayerDecals, OfMoreThanFourTheLowestAreLeftOut) {
    PaneWithDecals garden;
    const auto drawn = [&] { return render_with(garden.world, garden.camera, options_of(garden.shot())); };
    EXPECT_THAT(drawn().stats.notes, IsEmpty());
    garden.add_decal({.material = garden.painted, .order = -5}, {0, 1, 2}, glm::dvec3(garden.place[2]), 0, {2, 2, 0.5});
    EXPECT_THAT(drawn().stats.notes, Contains(HasSubstr("1 decals on blended surfaces are left out")));
    garden.world.decals.erase(garden.world.decals.begin());
    expect_agrees(garden.shot());
}

} // namespace
} // namespace prelight
