#include "decal_world.hpp"
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace prelight {
namespace {

constexpr uint32_t texture_side = 32;

template <class Value>
std::vector<uint8_t> decal_texels(Value value) {
    std::vector<uint8_t> out;
    for (uint32_t y = 0; y < texture_side; ++y)
        for (uint32_t x = 0; x < texture_side; ++x) {
            const glm::dvec4 v = value(6.2831853 * (x + 0.5) / texture_side, 6.2831853 * (y + 0.5) / texture_side);
            for (int c = 0; c < 4; ++c)
                out.push_back(static_cast<uint8_t>(std::lround(255 * std::clamp(v[c], 0.0, 1.0))));
        }
    return out;
}

} // namespace

DecalGarden::DecalGarden(glm::dvec3 origin) : Garden(origin) {
    const auto image = [&](auto value) {
        return TextureRef{.image = add_image(texture_side, texture_side, decal_texels(value)),
                          .sampler = {.wrap_s = Wrap::clamp_to_edge, .wrap_t = Wrap::clamp_to_edge}};
    };
    const TextureRef colours = image([](double u, double v) {
        return glm::dvec4(0.5 + 0.5 * std::sin(u), 0.5 + 0.5 * std::cos(2 * v), 0.4,
                          0.5 - 0.5 * std::cos(u) * std::cos(0.5 * v));
    });
    const TextureRef normals = image([](double u, double v) {
        const glm::dvec3 n = glm::normalize(glm::dvec3(0.5 * std::sin(2 * u), 0.4 * std::cos(3 * v), 1));
        return glm::dvec4(n * 0.5 + 0.5, 1);
    });
    const TextureRef factors = image(
        [](double u, double v) { return glm::dvec4(0, 0.6 + 0.3 * std::sin(u + v), 0.5 + 0.5 * std::cos(v), 1); });
    const auto add = [&](const Material& material) {
        add_material(material);
        return static_cast<uint32_t>(scene.materials.size() - 1);
    };
    painted = add({.name = "painted",
                   .base_colour = {0.9f, 1, 0.8f, 1},
                   .metallic = 0.6f,
                   .roughness = 0.9f,
                   .base_colour_texture = colours,
                   .metallic_roughness_texture = factors});
    bumpy = add({.name = "bumpy",
                 .base_colour = {0.5f, 0.6f, 0.7f, 0.8f},
                 .metallic = 0,
                 .roughness = 0.45f,
                 .normal_scale = 0.8f,
                 .normal_texture = normals});
    dull = add({.name = "dull", .metallic = 0, .roughness = 0.95f});
    const glm::dvec3 up(0, 1, 0);
    add_decal({.material = painted}, {-2.4, 0.1, 1.6}, up, 0.5, {3, 2.2, 0.6});
    add_decal({.material = bumpy, .opacity = 0.9f, .order = 1}, {-1.2, 0, 2.2}, up, -0.4, {2.5, 2.5, 0.8});
    add_decal({.material = painted, .opacity = 0.7f, .order = 2}, {0, 1, 0.8}, glm::normalize(glm::dvec3(0.2, 0.6, 1)),
              0.3, {1.6, 1.7, 1.3});
    add_decal({.material = bumpy}, {2.1, 1.1, -1.1}, glm::normalize(glm::dvec3(-0.3, 0.5, 1)), 0, {1.9, 1.8, 2.2});
    add_decal({.material = bumpy, .colour = false}, {2.4, 0, 2.4}, up, 0.9, {-2.2, 1.9, 0.5}); // mirrored
    add_decal({.material = dull, .colour = false, .normal = false}, {-4, 1, 0.6},
              glm::normalize(glm::dvec3(0.3, 1, 0.8)), 0, {2, 2, 1.9});
}

PlacedDecal& DecalGarden::add_decal(const Decal& decal, glm::dvec3 centre, glm::dvec3 out, double turn,
                                    glm::dvec3 size) {
    const glm::dvec3 side =
        glm::normalize(glm::cross(std::abs(out.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1), out));
    glm::dmat4 frame(glm::dvec4(side, 0), glm::dvec4(glm::cross(out, side), 0), glm::dvec4(out, 0),
                     glm::dvec4(at(centre.x, centre.y, centre.z), 1));
    frame = glm::scale(glm::rotate(frame, turn, glm::dvec3(0, 0, 1)), size);
    const auto place =
        std::upper_bound(world.decals.begin(), world.decals.end(), decal.order,
                         [](int32_t order, const PlacedDecal& other) { return order < other.decal.order; });
    return *world.decals.insert(place, {decal, frame});
}

} // namespace prelight
