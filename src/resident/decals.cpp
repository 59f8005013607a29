#include "decals.hpp"
#include "scene.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <prelight/error.hpp>
#include <shared/bindings.h>

namespace prelight::resident {
namespace {

glm::dvec3 corner(int i) { return {(i & 1 ? 0.5 : -0.5), (i & 2 ? 0.5 : -0.5), (i & 4 ? 0.5 : -0.5)}; }

glm::dvec3 transformed(const glm::dmat4& m, const glm::dvec3& p) { return glm::dvec3(m * glm::dvec4(p, 1)); }

/// Extent of the box [low, high] in another space, around its middle there.
struct Extent {
    glm::dvec3 middle{0}, half{0};
    Extent(const glm::dmat4& m, const glm::dvec3& low, const glm::dvec3& high)
        : middle(transformed(m, 0.5 * (low + high))), half(0) {
        for (int axis = 0; axis < 3; ++axis)
            half += glm::abs(glm::dvec3(m[axis])) * (0.5 * (high[axis] - low[axis]));
    }
};

bool apart(const Extent& a, const glm::dvec3& low, const glm::dvec3& high) {
    const glm::dvec3 margin = 1e-6 * (glm::abs(low) + glm::abs(high)); // the device computes in single precision
    return glm::any(glm::greaterThan(a.middle - a.half, high + margin)) ||
           glm::any(glm::lessThan(a.middle + a.half, low - margin));
}

void set_rows(glm::vec4 (&rows)[3], const glm::dmat4& matrix) {
    const glm::dmat4 m = glm::transpose(matrix);
    for (int row = 0; row < 3; ++row)
        rows[row] = glm::vec4(m[row]);
}

} // namespace

std::vector<DecalBox> decal_boxes(const World& world) {
    std::vector<DecalBox> boxes;
    for (const PlacedDecal& placed : world.decals) {
        const uint32_t material = placed.decal.material;
        if (material >= world.scene->materials.size())
            throw Error(
                fmt::format("{}: decal {}: there is no material {}", world.scene->name, boxes.size(), material));
        if (world.scene->materials[material].shader)
            throw Error(fmt::format("{}: decal {}: material {} has a shader of its own, and decals know none",
                                    world.scene->name, boxes.size(), material));
        DecalBox& box = boxes.emplace_back();
        box.decal = placed.decal;
        box.features = features_of(*world.scene, world.scene->materials[material]) &
                       (FEATURE_BASE_COLOUR_TEXTURE | FEATURE_METALLIC_ROUGHNESS_TEXTURE | FEATURE_NORMAL_TEXTURE |
                        FEATURE_ALPHA_MASK);
        box.world_from_box = placed.transform;
        box.box_from_world = glm::inverse(placed.transform);
        box.mirrored = glm::determinant(glm::dmat3(placed.transform)) < 0;
        const Extent extent(placed.transform, glm::dvec3(-0.5), glm::dvec3(0.5));
        box.low = extent.middle - extent.half;
        box.high = extent.middle + extent.half;
    }
    return boxes;
}

bool reaches_any(std::span<const DecalBox> decals, const glm::dvec3& low, const glm::dvec3& high) {
    return std::any_of(decals.begin(), decals.end(), [&](const DecalBox& box) {
        return !apart(Extent(glm::dmat4(1), low, high), box.low, box.high) &&
               !apart(Extent(box.box_from_world, low, high), glm::dvec3(-0.5), glm::dvec3(0.5));
    });
}

DecalView view_of(const DecalBox& box, const glm::dvec3& eye, const glm::mat4& clip_from_world) {
    glm::dmat4 relative = box.world_from_box;
    relative[3] -= glm::dvec4(eye, 0);
    const glm::dmat4 clip_from_box = glm::dmat4(clip_from_world) * relative;
    // Bits: beyond the left, right, upper, lower plane; behind the near plane (reversed depth).
    int all = 31, any = 0;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec4 c = clip_from_box * glm::dvec4(corner(i), 1);
        const int out = (c.x < -c.w) | (c.x > c.w) << 1 | (c.y < -c.w) << 2 | (c.y > c.w) << 3 | (c.z > c.w) << 4;
        all &= out;
        any |= out;
    }
    if (all != 0)
        return DecalView::unseen;
    return any & 16 ? DecalView::from_inside : DecalView::from_outside;
}

shared::DecalConstants decal_constants(const DecalBox& box, const glm::dvec3& eye, bool from_inside) {
    shared::DecalConstants constants{};
    glm::dmat4 relative = box.world_from_box;
    relative[3] -= glm::dvec4(eye, 0);
    set_rows(constants.world_row, relative);
    glm::dmat4 back = box.box_from_world;
    back[3] = box.box_from_world * glm::dvec4(eye, 1);
    set_rows(constants.box_row, back);
    const Decal& decal = box.decal;
    const double whole = std::cos(static_cast<double>(decal.fade_from)),
                 gone = std::cos(static_cast<double>(decal.fade_to));
    const double scale = 1 / std::max(whole - gone, 1e-4);
    constants.fade = glm::vec4(scale, -gone * scale, 0, from_inside ? 1 : 0);
    constants.opacity = decal.opacity * glm::vec4(decal.colour, decal.normal, decal.roughness, 0);
    return constants;
}

} // namespace prelight::resident
