#include "shadow_views.hpp"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>

namespace prelight::resident {
namespace {

/// A wider spot is drawn as a cube: its one tile would have few texels in the middle.
constexpr double widest_tile = 1.05; // 60°

struct Basis {
    glm::dvec3 right{0}, up{0}, forward{0};
};

Basis basis_of(glm::dvec3 forward) {
    const glm::dvec3 helper = std::abs(forward.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, helper));
    return {right, glm::cross(forward, right), forward};
}

Basis spot_basis(glm::dvec3 direction) {
    const glm::vec3 axis(direction);
    return {shared::spot_right(axis), shared::spot_up(axis), direction};
}

glm::dmat4 from_rows(glm::dvec4 x, glm::dvec4 y, glm::dvec4 z, glm::dvec4 w) {
    return glm::transpose(glm::dmat4(x, y, z, w));
}

/// A square pyramid from `eye` (relative to the world's centre); `half`: tangent of half its angle.
ShadowView perspective(glm::dvec3 eye, const Basis& b, double half, uint32_t side) {
    const auto row = [&](glm::dvec3 axis) { return glm::dvec4(axis, -glm::dot(axis, eye)); };
    ShadowView view;
    view.clip_from_centre = from_rows(row(b.right / half), row(b.up / half), {0, 0, 0, SHADOW_NEAR}, row(b.forward));
    view.texel_per_w = 2 * half / side;
    return view;
}

/// Tangents of the view's half width and half height (perspective), or metres.
glm::dvec2 half_size(const Camera& camera, double aspect) {
    const double half = camera.kind == ProjectionKind::perspective ? std::tan(camera.yfov / 2) : camera.ymag;
    return {half * aspect, half};
}

struct Sphere {
    double depth = 0, radius = 0; ///< on the camera's axis
};

/// The smallest sphere around a slice of the view.
Sphere sphere_of(const Camera& camera, double aspect, double begin, double end) {
    const double across = glm::length(half_size(camera, aspect));
    if (camera.kind == ProjectionKind::orthographic)
        return {(begin + end) / 2, std::hypot(across, (end - begin) / 2)};
    const double depth = std::min((begin + end) * (1 + across * across) / 2, end);
    return {depth, std::hypot(end - depth, across * end)};
}

ShadowView cascade(const Basis& b, glm::dvec3 middle, double radius, const WorldBox& world, uint32_t side,
                   uint32_t guard) {
    const double texel = 2 * radius / std::max(side - 2 * guard, 1u), half = texel * side / 2;
    const glm::dvec3 centre = world.centre();
    // In whole texels from the world's origin.
    const auto snapped = [&](glm::dvec3 axis) {
        return std::round(glm::dot(axis, middle) / texel) * texel - glm::dot(axis, centre);
    };
    // Along the light: all of the world, casters behind the view included.
    const double deep = 1.001 * glm::dot(glm::abs(b.forward), world.reach()) + 0.01;
    ShadowView view;
    view.clip_from_centre =
        from_rows(glm::dvec4(b.right, -snapped(b.right)) / half, glm::dvec4(b.up, -snapped(b.up)) / half,
                  glm::dvec4(-b.forward, deep) / (2 * deep), {0, 0, 0, 1});
    view.texel = texel;
    view.depth_range = 2 * deep;
    return view;
}

} // namespace

uint32_t shadow_kind(const Light& light) {
    if (light.kind == LightKind::directional)
        return SHADOW_CASCADES;
    return light.kind == LightKind::spot && double(light.outer_cone) <= widest_tile ? SHADOW_SPOT : SHADOW_FACES;
}

uint32_t shadow_tiles(const Light& light) {
    const uint32_t kind = shadow_kind(light);
    return kind == SHADOW_CASCADES ? 4 : kind == SHADOW_FACES ? 6 : 1;
}

glm::dvec4 cascade_ends(const PlacedCamera& camera, const WorldBox& world) {
    const double size = std::max(glm::distance(world.low, world.high), 1e-3);
    const double away = glm::distance(camera.position, world.centre()) + size / 2;
    // Twice as far each time that a camera outside goes twice as far away.
    double far = away > size ? size * std::exp2(std::ceil(std::log2(away / size))) : size;
    far = std::min(far, camera.camera.zfar);
    const bool perspective = camera.camera.kind == ProjectionKind::perspective;
    const double begin = std::max(camera.camera.znear, far * 1e-3), share = perspective ? 0.6 : 0;
    glm::dvec4 ends{0};
    for (int i = 1; i <= 4; ++i)
        ends[i - 1] = share * begin * std::pow(far / begin, i / 4.0) + (1 - share) * far * i / 4.0;
    return ends;
}

void find_shadow_views(const PlacedLight& light, const PlacedCamera& camera, double aspect, const WorldBox& world,
                       uint32_t side, uint32_t guard, std::vector<ShadowView>& out) {
    out.clear();
    const glm::dvec3 eye = light.position - world.centre();
    const double wider = double(side) / std::max(side - 2 * guard, 1u);
    switch (shadow_kind(light.light)) {
    case SHADOW_SPOT:
        out.push_back(perspective(eye, spot_basis(light.direction),
                                  std::tan(double(light.light.outer_cone) + 1e-3) * wider, side));
        return;
    case SHADOW_FACES:
        for (const int axis : {0, 1, 2})
            for (const double sign : {1.0, -1.0}) {
                glm::dvec3 forward(0);
                forward[axis] = sign;
                out.push_back(perspective(eye, basis_of(forward), wider, side));
            }
        return;
    default: break;
    }
    const glm::dvec4 ends = cascade_ends(camera, world);
    const Basis b = basis_of(light.direction);
    for (int i = 0; i < 4; ++i) {
        const Sphere sphere = sphere_of(camera.camera, aspect, i == 0 ? 0.0 : ends[i - 1], ends[i]);
        out.push_back(cascade(b, camera.position - camera.axes[2] * sphere.depth, sphere.radius, world, side, guard));
    }
}

} // namespace prelight::resident
