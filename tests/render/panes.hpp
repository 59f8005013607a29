#pragma once
#include "every_way.hpp"
#include "garden.hpp"
#include <cmath>
#include <gpu/context.hpp>
#include <utility>

namespace prelight {

// Worlds with blended surfaces, and ways to draw them.

inline glm::dmat4 placed_at(double x, double y, double z) { return glm::translate(glm::dmat4(1), {x, y, z}); }

inline Material unlit_material(const char* name, glm::vec4 colour, AlphaMode mode = AlphaMode::blend) {
    return {.name = name, .base_colour = colour, .alpha_mode = mode, .unlit = true};
}

/// What a pixel shows of `layers`, nearest last, over `behind`.
inline glm::dvec3 laid_over(glm::dvec3 behind, const std::vector<glm::dvec4>& layers) {
    for (const glm::dvec4& layer : layers)
        behind = glm::mix(behind, glm::dvec3(layer), layer.a);
    return behind;
}

/// Each blend may lose a step of a half float.
inline void expect_layers(const glm::vec3& is, const glm::dvec3& should, size_t layers) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(is[c], should[c], (static_cast<double>(layers) + 2) / 1024 * std::max(should[c], 0.05)) << c;
}

inline glm::vec3 middle_of(const Image& image) {
    return image.pixels[size_t(image.height / 2) * image.width + image.width / 2];
}

/// A wall behind a stack of panes, placed and made in another order than they lie.
struct Panes : TestWorld {
    std::vector<glm::dvec4> layers; ///< farthest first
    explicit Panes(size_t count, bool lit = false) {
        add_material(unlit_material("wall", {0.1f, 0.3f, 0.2f, 1}, AlphaMode::opaque));
        add(square(20), placed_at(0, 0, -3));
        layers.resize(count);
        for (size_t i = 0; i < count; ++i) {
            const size_t place = i * 7 % count; // 1, 4 and 15 have no factor 7
            const auto t = static_cast<float>(place);
            const glm::vec4 colour(0.5f + 0.45f * std::sin(t), 0.5f + 0.45f * std::sin(2 * t + 1),
                                   0.5f + 0.45f * std::cos(3 * t), 0.2f + 0.04f * static_cast<float>(place % 5));
            Material material = unlit_material("pane", colour);
            material.unlit = !lit;
            material.metallic = 0;
            add_material(material);
            add(square(3), placed_at(0, 0, -1 + 0.15 * static_cast<double>(place)));
            layers[place] = colour;
        }
        world.ambient = glm::vec3(0.2f);
    }
    Shot shot() const { return {.world = &world, .camera = front_camera(5), .width = 64, .height = 36}; }
};

/// Three panes at one place before a wall: the world's first one is the nearest.
struct CoincidentPanes : TestWorld {
    CoincidentPanes() {
        add_material(unlit_material("wall", {0.1f, 0.3f, 0.2f, 1}, AlphaMode::opaque));
        add(square(20), placed_at(0, 0, -3));
        for (const glm::vec4& colour : {glm::vec4(0.9f, 0.1f, 0.1f, 0.5f), glm::vec4(0.1f, 0.1f, 0.9f, 0.5f),
                                        glm::vec4(0.1f, 0.9f, 0.1f, 0.5f)}) {
            add_material(unlit_material("pane", colour));
            add(square(2), placed_at(0, 0, 0));
        }
    }
    Shot shot() const { return {.world = &world, .camera = front_camera(5), .width = 64, .height = 36}; }
    static glm::dvec3 in_order() {
        return laid_over({0.1, 0.3, 0.2}, {{0.1, 0.9, 0.1, 0.5}, {0.1, 0.1, 0.9, 0.5}, {0.9, 0.1, 0.1, 0.5}});
    }
};

inline Shot with(Shot shot, const std::map<std::string, std::string>& settings) {
    shot.settings.insert(settings.begin(), settings.end());
    return shot;
}

/// A fan of panes that all cross in one line, each lit.
struct Fan : TestWorld {
    explicit Fan(int count) {
        add_material(unlit_material("wall", {0.4f, 0.3f, 0.2f, 1}, AlphaMode::opaque));
        add(square(20), placed_at(0, 0, -3));
        for (int i = 0; i < count; ++i) {
            const auto t = static_cast<float>(i);
            Material pane{.name = "pane", .metallic = 0, .roughness = 0.5f, .alpha_mode = AlphaMode::blend};
            pane.base_colour = {0.5f + 0.45f * std::sin(2 * t), 0.5f + 0.45f * std::cos(3 * t), 0.6f, 0.3f};
            pane.double_sided = true;
            add_material(pane);
            add(square(1.5f), glm::rotate(glm::dmat4(1), 3.0 * (i + 0.5) / count, glm::dvec3(0, 1, 0.1)));
        }
        add_light({.kind = LightKind::point, .intensity = 6, .range = 12}, {1, 1, 3});
        add_light({.kind = LightKind::point, .intensity = 3, .range = 8}, {-1.5, 0.5, -2});
        world.ambient = glm::vec3(0.1f);
    }
    Shot shot() const { return {.world = &world, .camera = front_camera(5), .width = 160, .height = 90}; }
};

/// A pane of every material property before the garden.
struct LitPane : Garden {
    explicit LitPane(std::shared_ptr<const MaterialShader> shader = nullptr) {
        add_lights(12, 5, 5);
        add_light(spot(0.7f, 9, 30), {1, 4, 3}, {0, -1, -0.2});
        add_light({.kind = LightKind::directional, .colour = {0.9f, 0.8f, 1}, .intensity = 0.6f}, {}, {0.2, -1, -0.7});
        add_light(point(3, 12), {0.5, 1.5, 3.2}); // reaches the pane and little more
        Material material{.name = "pane", .metallic = 0.1f, .roughness = 0.4f, .emissive = {0.02f, 0.05f, 0}};
        material.base_colour = {0.7f, 0.8f, 0.9f, alpha};
        material.shader = std::move(shader);
        material.double_sided = true;
        add_material(material);
        add(square(1.2f), glm::rotate(placed_at(0, 1, 2), -0.2, {1, 0, 0}));
        world.ambient = glm::vec3(0.05f);
    }
    Material& pane() { return scene.materials.back(); }
    static constexpr float alpha = 0.4f;
};

/// A lit pane where the driver ends loops early, so that lists of lights take several rounds: it is drawn as where
/// loops run on. With the statistics. `settings`: of `light-prepass`, whose opaque surfaces need no lists.
inline Stats expect_the_same_in_rounds(const std::map<std::string, std::string>& settings) {
    const auto device = Device::create({.select = "cpu", .validate = true});
    dynamic_cast<gpu::Context&>(*device).end_loops_after(24); // a light takes two turns
    LitPane lit;
    lit.pane().alpha_mode = AlphaMode::blend;
    const Shot shot = with(with(lit.shot(), settings), {{"light-culling", "volumes"}});
    const Image expected = render_linear(test_device(), shot);
    const auto renderer = create_renderer("light-prepass", device.get(), options_of(shot));
    renderer->set_world(lit.world);
    renderer->render(lit.camera);
    expect_within(compare(renderer->read("linear"), expected), half_float_bound);
    expect_validation_clean(*device);
    return renderer->stats();
}

/// α of the picture with the pane opaque and 1 − α of the one without: what it is where the pane is in front.
inline Image expected_of(LitPane& lit, const Shot& shot) {
    lit.pane().alpha_mode = AlphaMode::opaque;
    Image opaque = render_linear(test_device(), shot);
    lit.world.instances.back().visible = false;
    const Image without = render_linear(test_device(), shot);
    lit.world.instances.back().visible = true;
    for (size_t i = 0; i < opaque.pixels.size(); ++i)
        opaque.pixels[i] = glm::mix(without.pixels[i], opaque.pixels[i], LitPane::alpha);
    return opaque;
}

/// Every architecture with every way of finding lights, blended by lists and sorted; and with one of them peeled.
inline std::vector<Shot> every_blended_way() {
    std::vector<Shot> shots;
    std::string renderer;
    for (const Shot& shot : every_way({.width = 160, .height = 90})) {
        for (const char* how : {"lists", "sorted"})
            shots.push_back(with(shot, {{"transparency", how}}));
        if (std::exchange(renderer, shot.renderer) != shot.renderer)
            shots.push_back(with(shot, {{"transparency", "peeled"}}));
    }
    return shots;
}

/// The way of `way` with the picture of `shot`.
inline Shot in_way(Shot shot, const Shot& way) {
    shot.renderer = way.renderer;
    return with(shot, way.settings);
}

} // namespace prelight
