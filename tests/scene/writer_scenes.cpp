#include <glm/ext/matrix_transform.hpp>
#include <limits>
#include <scene/procedural/builder.hpp>
#include <scene/procedural/shapes.hpp>
#include <scene/tangents.hpp>
#include <scene/writer_scenes.hpp>

namespace prelight {
namespace {

TextureImage checker(const char* name, uint8_t alpha) {
    TextureImage image{.name = name, .width = 5, .height = 3, .rgba = {}};
    for (uint32_t i = 0; i < 15; ++i)
        image.rgba.insert(image.rgba.end(), {static_cast<uint8_t>(17 * i), static_cast<uint8_t>(255 - 16 * i), 128,
                                             i == 4 ? alpha : uint8_t{255}});
    return image;
}

Material textured() {
    Material material{.name = "everything",
                      .base_colour = {0.25f, 0.5f, 0.75f, 0.9f},
                      .metallic = 0.3f,
                      .roughness = 0.6f,
                      .emissive = {0, 3.7f, 12.1f},
                      .normal_scale = 0.7f,
                      .occlusion_strength = 0.4f,
                      .alpha_mode = AlphaMode::mask,
                      .alpha_cutoff = 0.3f,
                      .double_sided = true};
    material.base_colour_texture = {.image = 0, .sampler = {}};
    material.metallic_roughness_texture = {.image = 1, .sampler = {}};
    material.normal_texture = {.image = 1, .sampler = {.wrap_s = Wrap::clamp_to_edge, .mag = Filter::nearest}};
    material.occlusion_texture = {.image = 1, .sampler = {}, .texcoord = 1};
    material.emissive_texture = {
        .image = 0,
        .sampler = {.wrap_t = Wrap::mirrored_repeat, .min = Filter::nearest, .mip = MipFilter::none},
        .texcoord = 1};
    const float c = std::cos(0.5f), s = std::sin(0.5f);
    material.emissive_texture.uv_linear = {{2 * c, -2 * s}, {-3 * s, -3 * c}};
    material.emissive_texture.uv_offset = {0.25f, -0.5f};
    material.base_colour_texture.uv_linear = {{-1, 0}, {0, 4}};
    return material;
}

void add_lights(Scene& scene) {
    const float inf = std::numeric_limits<float>::infinity();
    add_light(scene, {.name = "sun", .kind = LightKind::directional, .intensity = 2}, {0, 9, 0});
    add_light(scene, {.name = "bulb", .colour = {1, 0.5f, 0.3f}, .intensity = 40, .range = inf}, {1, 2, 3});
    add_light(scene,
              {.name = "bright",
               .colour = {5, 0, 0.7f},
               .intensity = 3.3f,
               .range = 8.1f,
               .shininess = 2.5f,
               .falloff = Falloff::linear,
               .casts_shadow = false},
              {-1, 2, 3});
    add_light(scene,
              {.name = "spot",
               .kind = LightKind::spot,
               .intensity = 9,
               .range = 7,
               .inner_cone = 0.2f,
               .outer_cone = 0.5f,
               .falloff = Falloff::quadratic},
              {0, 3, 0});
    add_light(scene,
              {.name = "half space", .kind = LightKind::spot, .inner_cone = 1.57079633f, .outer_cone = 1.57079633f},
              {0, 4, 0});
}

void add_meshes(Scene& scene) {
    Primitive sphere = make_sphere(0.5f, 12, 6);
    sphere.texcoords[1] = sphere.texcoords[0];
    sphere.colours.assign(sphere.positions.size(), {0.5f, 0.25f, 1, 1});
    generate_tangents(sphere, 0);
    Primitive triangle; // its six bytes of indices leave the next view unaligned, if it is not padded
    triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    triangle.indices = {0, 1, 2};
    make_flat_normals(triangle);
    triangle.material = 3;
    Primitive box = make_box({-1, -1, -1}, {1, 1, 1});
    box.texcoords[0].clear(); // its material reads sets 0 and 1 all the same
    box.material = 1;
    Primitive ground = make_ground({40, 40}, 300); // more than 65,535 vertices
    ground.material = 2;
    scene.meshes = {{.name = "empty", .primitives = {}},
                    {.name = "three", .primitives = {sphere, Primitive{}, triangle, box}},
                    {.name = "ground", .primitives = {ground}}};
}

void add_nodes(Scene& scene) {
    add_root(scene, "nothing", glm::dmat4(1)).mesh = 0;
    add_root(scene, "far", translation({10000.123456789, 0.001, -10000.5})).mesh = 1;
    add_root(scene, "ground", glm::dmat4(1)).mesh = 2;
    const auto turned = glm::rotate(glm::dmat4(1), 0.7, glm::normalize(glm::dvec3(1, 2, 3)));
    const auto mirrored = turned * glm::scale(glm::dmat4(1), glm::dvec3(-1, 2, 0.5));
    Node& parent = add_root(scene, "mirrored", mirrored);
    parent.mesh = 1;
    parent.instances = {translation({1, 2, 3}), mirrored, glm::dmat4(1)};
    const auto child = static_cast<uint32_t>(scene.nodes.size());
    parent.children = {child, child + 1};
    scene.nodes.push_back({.name = "flat", .local = turned * glm::scale(glm::dmat4(1), glm::dvec3(1, 0, 1))});
    scene.nodes[child].mesh = 1;
    scene.nodes.push_back({.name = "leaf", .local = glm::scale(glm::dmat4(1), glm::dvec3(2, 2, -2))});
    scene.nodes[child + 1].mesh = 2;
}

} // namespace

Scene scene_with_everything() {
    Scene scene;
    scene.name = "everything";
    scene.ambient = {0.1f, 0.2f, 0.3f};
    scene.images = {checker("opaque", 255), checker("see-through", 7)};
    scene.materials = {textured(), textured(), {.name = "unlit", .alpha_mode = AlphaMode::blend, .unlit = true}, {}};
    scene.materials[1].normal_texture = {};
    scene.materials[1].normal_scale = 1; // a scale without a map has no place in glTF
    scene.scenes = {{.name = "empty", .nodes = {}}, {.name = "full", .nodes = {}}};
    scene.default_scene = 1;
    add_camera(scene, {.name = "infinite", .yfov = 1.1}, {0, 5, 20}, {0, 0, 0});
    add_camera(scene, {.name = "near", .zfar = 123.5}, {3, 5, 20}, {0, 0, 0});
    add_camera(scene, {.name = "plan", .kind = ProjectionKind::orthographic, .ymag = 12.5, .znear = 0, .zfar = 50},
               {0.1, 30, 0}, {0, 0, 0});
    add_lights(scene);
    add_meshes(scene);
    add_nodes(scene);
    return scene;
}

} // namespace prelight
