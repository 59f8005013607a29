#include "garden.hpp"
#include <cmath>

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
        {.name = "lamp", .base_colour = {0.5f, 0.5f, 0.5f, 1}, .metallic = 0, .roughness = 0.7f, .emissive = {0.2f, 0.1f, 0.3f}}};
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
    return {.kind = LightKind::spot, .colour = {0.9f, 1, 0.8f}, .intensity = intensity, .range = range,
            .inner_cone = outer * 0.6f, .outer_cone = outer};
}

void Garden::add_lights(uint32_t count, float range, float intensity) {
    for (uint32_t i = 0; i < count; ++i) {
        // A low-discrepancy walk over the floor (the plastic number's), so that no seed is needed.
        const double u = std::fmod(0.5 + 0.7548776662466927 * i, 1.0), v = std::fmod(0.5 + 0.5698402909980532 * i, 1.0);
        const double hue = 2.0943951 * i;
        const glm::vec3 colour(0.6 + 0.4 * std::cos(hue), 0.6 + 0.4 * std::cos(hue - 2.1), 0.6 + 0.4 * std::cos(hue + 2.1));
        add_light(point(range, intensity, colour), at(11 * u - 5.5, 0.6 + 1.5 * std::fmod(0.37 * i, 1.0), 11 * v - 5.5));
    }
}

} // namespace prelight
