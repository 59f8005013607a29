#include "garden.hpp"
#include <cmath>
#include <prelight/light_distribution.hpp>
#include <scene/procedural/cookie_maps.hpp>

namespace prelight {

Garden::Garden() : Garden(glm::dvec3(0)) {}

Garden::Garden(glm::dvec3 origin) : origin_(origin) {
    const auto place = [&](Primitive primitive, glm::dvec3 where, glm::dvec3 scale, double turn) {
        glm::dmat4 m = glm::translate(glm::dmat4(1), origin + where);
        m = glm::rotate(m, turn, glm::dvec3(1, 0, 0));
        add(std::move(primitive), glm::scale(m, scale));
    };
    add_material({.name = "floor", .base_colour = {0.7f, 0.7f, 0.65f, 1}, .metallic = 0, .roughness = 0.6f});
    place(square(6), {0, 0, 0}, glm::dvec3(1), -1.5707963267948966);
    const Material spheres[] = {
        {.name = "clay", .base_colour = {0.8f, 0.3f, 0.2f, 1}, .metallic = 0, .roughness = 0.9f},
        {.name = "paint", .base_colour = {0.2f, 0.5f, 0.8f, 1}, .metallic = 0, .roughness = 0.35f},
        {.name = "gold", .base_colour = {1, 0.77f, 0.34f, 1}, .metallic = 1, .roughness = 0.4f},
        {.name = "steel", .base_colour = {0.6f, 0.6f, 0.6f, 1}, .metallic = 1, .roughness = 0.55f},
        {.name = "lamp",
         .base_colour = {0.5f, 0.5f, 0.5f, 1},
         .metallic = 0,
         .roughness = 0.7f,
         .emissive = {0.2f, 0.1f, 0.3f}}};
    // One stretched, one mirrored, one both: normals go by the inverse transpose, winding by the sign.
    const glm::dvec3 scales[] = {{1, 1, 1}, {0.7, 1.3, 0.9}, {-1, 1, 1}, {1.2, -0.8, 1}, {1, 1, 1}};
    for (int i = 0; i < 5; ++i) {
        add_material(spheres[i]);
        place(sphere(96), {-4.0 + 2.0 * i, 1, i % 2 ? -1.2 : 0.8}, scales[i], 0);
    }
    Camera lens;
    lens.yfov = 0.7;
    camera = look_at(lens, at(0.5, 4.5, 9), at(0, 0.6, 0));
    world.ambient = {0.03f, 0.04f, 0.05f};
}

Light Garden::point(float range, float intensity, glm::vec3 colour) const {
    return {.kind = LightKind::point, .colour = colour, .intensity = intensity, .range = range};
}

Light Garden::spot(float outer, float range, float intensity) const {
    return {.kind = LightKind::spot,
            .colour = {0.9f, 1, 0.8f},
            .intensity = intensity,
            .range = range,
            .inner_cone = outer * 0.6f,
            .outer_cone = outer};
}

void Garden::add_lights(uint32_t count, float range, float intensity) {
    for (uint32_t i = 0; i < count; ++i) {
        // A low-discrepancy walk over the floor (the plastic number's), so that no seed is needed.
        const double u = std::fmod(0.5 + 0.7548776662466927 * i, 1.0), v = std::fmod(0.5 + 0.5698402909980532 * i, 1.0);
        const double hue = 2.0943951 * i;
        const glm::vec3 colour(0.6 + 0.4 * std::cos(hue), 0.6 + 0.4 * std::cos(hue - 2.1),
                               0.6 + 0.4 * std::cos(hue + 2.1));
        add_light(point(range, intensity, colour),
                  at(11 * u - 5.5, 0.6 + 1.5 * std::fmod(0.37 * i, 1.0), 11 * v - 5.5));
    }
}

BacklitGarden::BacklitGarden() {
    for (const double x : {-4.0, 0.0, 4.0})
        add_light(point(20, 40), {x, 0.8, -7});
    camera = look_at(camera.camera, {0.5, 0.9, 9}, {0, 0.5, 0});
}

FewLights::FewLights(bool grey) {
    for (int i = 0; i < 4; ++i)
        add_light(point(9, 6), {2.6 * i - 3.9, 4.5, 1.0 + 0.3 * i});
    if (grey)
        for (Material& material : scene.materials)
            if (material.metallic > 0)
                material.base_colour = {0.7f, 0.7f, 0.7f, 1};
}

ShadedGarden::ShadedGarden(std::shared_ptr<const MaterialShader> shader, uint32_t lights) {
    for (size_t m = 1; m < scene.materials.size(); ++m)
        scene.materials[m].shader = shader;
    add_lights(lights, 5, 6);
}

void ShadedGarden::set(const char* parameter, glm::vec4 value) {
    for (size_t m = 1; m < scene.materials.size(); ++m)
        scene.materials[m].parameters[parameter] = value;
}

std::shared_ptr<const LightProfile> wall_lamp() {
    static const auto profile = std::make_shared<const LightProfile>(parse_profile(wall_lamp_profile(), "wall lamp"));
    return profile;
}

MixedMaterials::MixedMaterials() {
    constexpr uint32_t size = 64;
    std::vector<uint8_t> holes;
    for (uint32_t i = 0; i < size * size; ++i) {
        const double u = 12.5663706 * (i % size + 0.5) / size, v = 12.5663706 * (i / size + 0.5) / size;
        const auto alpha = static_cast<uint8_t>(std::lround(127.5 + 127.5 * std::sin(u) * std::sin(v)));
        holes.insert(holes.end(), {255, 255, 255, alpha});
    }
    Material masked{.name = "masked",
                    .metallic = 0,
                    .roughness = 0.7f,
                    .alpha_mode = AlphaMode::mask,
                    .alpha_cutoff = 0.4f,
                    .double_sided = true};
    masked.base_colour_texture = {.image = add_image(size, size, holes)};
    add_material(masked);
    Primitive front = square(1);
    front.colours = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 1}};
    const auto at = [](double x, double y, double z) { return glm::translate(glm::dmat4(1), {x, y, z}); };
    add(front, at(-1.1, 0, 0));
    add(front, glm::rotate(at(1.1, 0, 0), 2.7, {0, 1, 0}));
    add_material({.name = "paint",
                  .base_colour = {0.9f, 0.5f, 0.3f, 1},
                  .metallic = 0,
                  .roughness = 0.5f,
                  .emissive = {0.05f, 0, 0.1f}});
    add(square(0.4f), glm::scale(at(0, 1.4, 0.3), {-1, 1, 1}));
    add_material({.name = "unlit", .base_colour = {0.2f, 0.6f, 0.3f, 1}, .unlit = true});
    add(square(4), at(0, 0, -2));
    add_material({.name = "away", .base_colour = {1, 0, 1, 1}});
    add(square(0.5f), glm::rotate(at(0, 0, 1), 3.0, {0, 1, 0}));
    for (int i = 0; i < 11; ++i)
        add_light({.kind = LightKind::point,
                   .colour = {1, 0.1f * static_cast<float>(i), 0.6f},
                   .intensity = 1.5f,
                   .range = 12},
                  {0.4 * i - 2, 1.5 - 0.3 * (i % 4), 3});
    world.ambient = {0.05f, 0.06f, 0.08f};
}

} // namespace prelight
