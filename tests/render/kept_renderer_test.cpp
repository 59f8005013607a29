// A renderer that is kept while lights, objects and camera change draws what a new one draws: nothing of an earlier
// frame stays where it does not belong. Sequences of changes are drawn by lot, with fixed seeds.
#include "every_way.hpp"
#include "garden.hpp"
#include "random_scene.hpp"
#include "stage.hpp"
#include <functional>
#include <glm/geometric.hpp>

namespace prelight {
namespace {

/// Draws `steps` states of the stage with each of `kept`, which are told what changed, and with a new renderer.
void expect_as_new(const Shot& shot, const std::vector<std::map<std::string, std::string>>& kept, uint64_t seed,
                   int steps) {
    Stage stage(seed);
    std::vector<std::unique_ptr<World>> worlds; // as long as a renderer knows them
    std::vector<std::unique_ptr<Renderer>> renderers;
    const auto make = [&](const std::map<std::string, std::string>& settings) {
        Shot one = shot;
        one.settings.insert(settings.begin(), settings.end());
        return create_renderer(one.renderer, &test_device(), options_of(one));
    };
    for (const auto& settings : kept)
        renderers.push_back(make(settings));
    for (int step = 0; step < steps; ++step) {
        const bool objects = step > 0 && stage.change();
        const auto& world = worlds.emplace_back(std::make_unique<World>(stage.world));
        const auto fresh = make(kept[0]);
        fresh->set_world(*world);
        fresh->render(stage.camera);
        const Image expected = fresh->read("linear");
        for (size_t r = 0; r < renderers.size(); ++r) {
            if (step == 0 || objects)
                renderers[r]->set_world(*world);
            else
                renderers[r]->set_lights(world->lights);
            renderers[r]->render(stage.camera, 1 + static_cast<uint32_t>(step % 2));
            const Image image = renderers[r]->read("linear");
            size_t off = 0;
            for (size_t i = 0; i < image.pixels.size(); ++i)
                off += image.pixels[i] != expected.pixels[i];
            ASSERT_EQ(off, 0u) << "pixels, seed " << seed << ", step " << step << ", kept renderer " << r;
        }
    }
}

class KeptRenderer : public testing::TestWithParam<Shot> {};

INSTANTIATE_TEST_SUITE_P(All, KeptRenderer, testing::ValuesIn(every_way({.width = 96, .height = 54})), way_name);

TEST_P(KeptRenderer, DrawsWhatANewOneDraws) {
    expect_as_new(GetParam(), {{}}, seed_of(GetParam()), 5);
    expect_validation_clean(test_device());
}

// What a shadow was made from decides whether it is kept.
TEST_P(KeptRenderer, ShadowsAreThoseOfANewOne) {
    Shot shot = GetParam();
    shot.settings.insert({{"shadows", "on"}, {"shadow-filter", "hard"}, {"shadow-budget", "262144"}});
    expect_as_new(shot, {{{"shadow-cache", "on"}}, {{"shadow-cache", "off"}}}, seed_of(GetParam()), 5);
    const std::string culling = shot.settings.contains("light-culling") ? shot.settings.at("light-culling") : "";
    if ((shot.renderer == "light-prepass" || shot.renderer == "deferred") && culling != "tiles" &&
        culling != "clusters") {
        shot.settings["shadow-memory"] = "reuse";
        expect_as_new(shot, {{{"shadow-cache", "on"}}, {{"shadow-cache", "off"}}}, seed_of(GetParam()) + 1, 3);
    }
    expect_validation_clean(test_device());
}

// Samples of edge pixels, of which there may be more from one frame to the next than there is room for.
TEST(KeptRenderers, SeveralSamplesAPixel) {
    for (const std::string& renderer : device_renderers) {
        SCOPED_TRACE(renderer);
        const Shot shot{.width = 96, .height = 54, .renderer = renderer, .samples = 4};
        expect_as_new(shot, {{}}, seed_of(shot), 5);
    }
    Shot shadowed{.width = 96, .height = 54, .samples = 4};
    shadowed.settings = {{"shadows", "on"}, {"shadow-budget", "262144"}, {"msaa-light", "samples"}};
    expect_as_new(shadowed, {{}}, 5, 3);
    expect_validation_clean(test_device());
}

// The same with what filters read beside the texel, and with the shadow that waits in a G-buffer.
TEST(KeptRenderers, EveryFilterAndTheSunOcclusionChannel) {
    for (const char* filter : {"pcf", "contact"})
        for (const char* memory : {"atlas", "reuse"}) {
            Shot shot{.width = 96, .height = 54, .renderer = "deferred"};
            shot.settings = {{"shadows", "on"},         {"shadow-filter", filter}, {"shadow-budget", "262144"},
                             {"shadow-memory", memory}, {"g-buffer", "killzone2"}, {"light-culling", "volumes"}};
            SCOPED_TRACE(name_of(shot));
            expect_as_new(shot, {{}}, 21, 4);
        }
    expect_validation_clean(test_device());
}

/// A light over two cards on a floor that it can't shine at both at once.
struct TwoCards : TestWorld {
    TwoCards() {
        const glm::dmat4 flat = glm::rotate(glm::dmat4(1), -1.5707963267948966, {1, 0, 0});
        add_material({.name = "white", .double_sided = true});
        add(square(10), flat);
        add(square(0.6f), glm::translate(glm::dmat4(1), {3, 1, 0}) * flat);
        place(1, glm::translate(glm::dmat4(1), {-3, 1, 0}) * flat);
        world.ambient = glm::vec3(0.02f);
        Light spot{.kind = LightKind::spot, .intensity = 60, .range = 20, .inner_cone = 0.2f, .outer_cone = 0.35f};
        add_light(spot, {0, 4, 0}, {-3, -4, 0}).up = {0, 0, 1};
    }
};

// One change of one light after the other, each of which brings in casters that it did not have before.
TEST(KeptRenderers, ALightThatChangesWhereItStandsFindsItsCastersAnew) {
    using Change = std::function<void(PlacedLight&)>;
    const std::vector<std::tuple<const char*, Change, Change>> changes{
        {"turns", [](PlacedLight&) {}, [](PlacedLight& l) { l.direction = glm::normalize(glm::dvec3(3, -4, 0)); }},
        {"widens", [](PlacedLight&) {}, [](PlacedLight& l) { l.light.outer_cone = 0.95f; }},
        {"widens as a cube",
         [](PlacedLight& l) {
             l.light.outer_cone = 1.1f;
             l.direction = glm::normalize(glm::dvec3(-3, -3, 0));
         },
         [](PlacedLight& l) { l.light.outer_cone = 1.55f; }},
        {"reaches farther",
         [](PlacedLight& l) {
             l.light.kind = LightKind::point;
             l.light.range = 3;
         },
         [](PlacedLight& l) { l.light.range = 12; }},
        {"becomes a point",
         [](PlacedLight& l) {
             l.light.outer_cone = 1.1f;
             l.direction = glm::normalize(glm::dvec3(-3, -3, 0));
         },
         [](PlacedLight& l) { l.light.kind = LightKind::point; }},
        {"becomes a sun", [](PlacedLight&) {},
         [](PlacedLight& l) {
             l.light.kind = LightKind::directional;
             l.light.intensity = 2;
         }},
    };
    const PlacedCamera camera = look_at(Camera{}, {0, 9, 9}, {0, 0, 0});
    for (const auto& [name, first, then] : changes)
        for (const char* renderer : {"light-prepass", "multipass"}) {
            SCOPED_TRACE(std::string(renderer) + ": " + name);
            TwoCards cards;
            first(cards.world.lights[0]);
            Shot shot{.world = &cards.world,
                      .camera = camera,
                      .width = 160,
                      .height = 90,
                      .settings = {{"shadows", "on"}, {"shadow-budget", "1048576"}},
                      .renderer = renderer};
            const auto kept = create_renderer(renderer, &test_device(), options_of(shot));
            kept->set_world(cards.world);
            kept->render(camera);
            World changed = cards.world;
            then(changed.lights[0]);
            kept->set_lights(changed.lights);
            kept->render(camera);
            EXPECT_GT(kept->stats().shadows->tiles_drawn, 0u) << "its casters are others";
            shot.world = &changed;
            const Image fresh = render_linear(test_device(), shot);
            EXPECT_TRUE(kept->read("linear").pixels == fresh.pixels);
            shot.settings.clear();
            EXPECT_FALSE(render_linear(test_device(), shot).pixels == fresh.pixels) << "there is a shadow to compare";
        }
    expect_validation_clean(test_device());
}

// A light that mostly stays where it is, in tiles of one size, mostly as a cube whose faces do not turn with it: what
// it reaches alone decides whether its casters are still the same.
TEST(KeptRenderers, OneLightThroughManyChangesInPlace) {
    TwoCards cards;
    for (int i = 0; i < 8; ++i) // all around, nearer and farther
        cards.place(1, glm::rotate(glm::dmat4(1), i * 2.4, {0, 1, 0}) *
                           glm::translate(glm::dmat4(1), {1 + 0.5 * i, 0.5 + 0.1 * i, 0}) *
                           glm::rotate(glm::dmat4(1), -1.2, {1, 0, 0}));
    const PlacedCamera camera = look_at(Camera{}, {0, 9, 7}, {0, 0, 0});
    for (const bool cached : {true, false}) {
        Shot shot{.camera = camera,
                  .width = 96,
                  .height = 54,
                  .settings = {{"shadows", "on"},
                               {"shadow-budget", "65536"},
                               {"shadow-detail", "16"},
                               {"shadow-cache", cached ? "on" : "off"},
                               {"light-culling", "volumes"}}};
        const auto kept = create_renderer(shot.renderer, &test_device(), options_of(shot));
        kept->set_world(cards.world);
        Random random(3);
        World world = cards.world;
        PlacedLight& placed = world.lights[0];
        placed.light.outer_cone = 1.1f;
        for (int step = 0; step < (cached ? 24 : 6); ++step) {
            switch (random.below(12)) {
            case 0: // what casts is found anew
            case 1:
            case 2:
            case 3: placed.position = {random.uniform(-2, 2), 3, random.uniform(-2, 2)}; break;
            case 4:
                placed.light.kind = placed.light.kind == LightKind::spot ? LightKind::point : LightKind::spot;
                break;
            case 5: placed.light.outer_cone = static_cast<float>(random.uniform(1, 1.5)); break;
            case 6:
            case 7:
            case 8:
                placed.direction =
                    glm::normalize(glm::dvec3(random.uniform(-1, 1), random.uniform(-1, -0.2), random.uniform(-1, 1)));
                break;
            default: placed.light.range = static_cast<float>(random.uniform(2, 9));
            }
            placed.light.inner_cone = 0.9f * placed.light.outer_cone;
            kept->set_lights(world.lights);
            kept->render(camera);
            shot.world = &world;
            EXPECT_TRUE(kept->read("linear").pixels == render_linear(test_device(), shot).pixels)
                << "cached " << cached << ", step " << step;
        }
    }
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
