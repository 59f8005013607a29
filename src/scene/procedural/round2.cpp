#include <cmath>
#include <scene/procedural/builder.hpp>
#include <scene/procedural/material_maps.hpp>
#include <scene/procedural/random.hpp>
#include <scene/procedural/round2.hpp>
#include <scene/procedural/shapes.hpp>
#include <scene/tangents.hpp>

namespace prelight {

Scene make_round2_scene(uint32_t lights, uint64_t seed) {
    Scene scene;
    scene.name = "round2";
    scene.scenes = {{.name = "round2", .nodes = {}}};
    scene.ambient = glm::vec3(0.04f);
    add_camera(scene, {.name = "front", .yfov = 0.7, .znear = 0.05}, {1.2, 1.1, 5.2}, {0, 0, 0});

    const TextureRef colours{.image = append(scene.images, brick_colours()), .sampler = {}};
    const TextureRef normals{.image = append(scene.images, brick_normals()), .sampler = {}};
    const auto bricks = append(scene.materials, {.name = "bricks",
                                                 .metallic = 0,
                                                 .roughness = 0.4f,
                                                 .base_colour_texture = colours,
                                                 .normal_texture = normals});
    Primitive knot = make_knot(1, 0.33f, 384, 48);
    generate_tangents(knot, normals);
    add_root(scene, "knot", glm::dmat4(1)).mesh = add_mesh(scene, "knot", std::move(knot), bricks);

    Random random(seed);
    const double turn = random.unit();
    for (uint32_t i = 0; i < lights; ++i) {
        // All around, and from above and below in turn.
        const double round = full_turn * (turn + double(i) / lights);
        const double height = i % 2 ? 0.7 : -0.15;
        const glm::dvec3 from(std::sin(round), height, std::cos(round));
        const PlacedCamera aim = look_at({}, from, {0, 0, 0}); // shines along −Z, as a camera looks
        glm::dmat4 local(aim.axes);
        Node& node = add_root(scene, {}, local);
        node.light = append(scene.lights, {.kind = LightKind::directional,
                                           .colour = hue_colour(double(i) / lights, 0.45f),
                                           .intensity = 12.0f / static_cast<float>(lights)});
    }
    return scene;
}

} // namespace prelight
