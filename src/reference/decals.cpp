#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <prelight/error.hpp>
#include <reference/decals.hpp>

namespace prelight::reference {
namespace {

/// Share of the way from b's angle to a's, eased at both ends; angles from the axis, by their cosines.
double fade(double cosine, double whole, double gone) {
    if (cosine >= whole)
        return 1;
    if (cosine <= gone)
        return 0;
    const double x = (cosine - gone) / (whole - gone);
    return x * x * (3 - 2 * x);
}

} // namespace

Decals::Decals(const World& world, glm::dvec3 origin, const Textures& textures) : textures_(textures) {
    for (const PlacedDecal& placed : world.decals) {
        Box box{&placed.decal,
                &world.scene->materials.at(placed.decal.material),
                glm::dvec3(placed.transform[3]) - origin,
                {}};
        if (box.material->shader)
            throw Error("reference: a decal's material has a shader of its own");
        for (int axis = 0; axis < 3; ++axis)
            box.sides[axis] = glm::dvec3(placed.transform[axis]);
        boxes_.push_back(box);
    }
}

void Decals::cover(Surface& surface) const {
    const glm::dvec3 own = surface.normal;
    glm::dvec3 mixed = own;
    double roughness = surface.environment_roughness;
    for (const Box& box : boxes_) {
        // Cramer's rule: how many sides along each axis.
        const glm::dvec3 from = surface.position - box.centre, (&s)[3] = box.sides;
        const double volume = glm::dot(s[0], glm::cross(s[1], s[2]));
        const glm::dvec3 place =
            glm::dvec3(glm::dot(from, glm::cross(s[1], s[2])), glm::dot(s[0], glm::cross(from, s[2])),
                       glm::dot(s[0], glm::cross(s[1], from))) /
            volume;
        if (std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z)}) > 0.5)
            continue;
        const double seen =
            fade(glm::dot(own, glm::normalize(s[2])), std::cos(static_cast<double>(box.decal->fade_from)),
                 std::cos(static_cast<double>(box.decal->fade_to)));
        if (seen == 0)
            continue;
        const Material& material = *box.material;
        const auto look = [&](const TextureRef& ref, Encoding encoding) {
            return ref ? textures_.sample(ref, {0.5 + place.x, 0.5 - place.y}, encoding) : glm::dvec4(1);
        };
        glm::dvec4 base = glm::dvec4(material.base_colour) * look(material.base_colour_texture, Encoding::srgb);
        if (material.alpha_mode == AlphaMode::mask)
            base.a = base.a < static_cast<double>(material.alpha_cutoff) ? 0 : 1;
        const glm::dvec4 factors = look(material.metallic_roughness_texture, Encoding::linear);
        const double share = base.a * box.decal->opacity * seen;
        if (box.decal->colour) {
            surface.base_colour += share * (glm::dvec3(base) - surface.base_colour);
            surface.metallic += share * (material.metallic * factors.b - surface.metallic);
        }
        if (box.decal->roughness)
            roughness += share * (material.roughness * factors.g - roughness);
        if (!box.decal->normal)
            continue;
        glm::dvec3 bumped = own;
        if (material.normal_texture) {
            const glm::dvec3 texel = 2.0 * glm::dvec3(look(material.normal_texture, Encoding::linear)) - 1.0;
            // The surface's tangent plane, the first direction along what is left of the picture's right.
            const glm::dvec3 right = glm::normalize(glm::cross(glm::cross(own, s[0]), own));
            const glm::dvec3 up = glm::cross(own, right) * (volume < 0 ? -1.0 : 1.0); // a mirrored box mirrors
            bumped = glm::normalize(right * texel.x * static_cast<double>(material.normal_scale) +
                                    up * texel.y * static_cast<double>(material.normal_scale) + own * texel.z);
        }
        mixed += share * (bumped - mixed);
    }
    surface.normal = glm::normalize(mixed);
    surface.environment_roughness = roughness;
}

} // namespace prelight::reference
