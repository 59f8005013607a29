#include "lights.hpp"
#include "light_bounds.hpp"
#include <algorithm>
#include <cmath>
#include <optional>
#include <prelight/light_distribution.hpp>

namespace prelight::resident {
namespace {

constexpr double widest_cone = 80.0 / 180.0 * 3.14159265358979323846;

/// What of a view the test of each light needs, made once a frame. World space relative to the camera.
class LightView {
public:
    LightView(const PlacedCamera& camera, const shared::FrameConstants& constants)
        : camera_(camera.camera), corner_(glm::length(glm::dvec3(constants.ray_right) + glm::dvec3(constants.ray_up) +
                                                      glm::dvec3(constants.forward))) {
        spheres_.forward = constants.forward;
        spheres_.perspective = camera_.kind == ProjectionKind::perspective;
        spheres_.across = glm::length(glm::dvec3(constants.ray_right)) * glm::length(glm::dvec3(constants.ray_up));
        const glm::dmat4 clip(constants.clip_from_world);
        const auto row = [&](int r) { return glm::dvec4(clip[0][r], clip[1][r], clip[2][r], clip[3][r]); };
        const glm::dvec4 w = row(3);
        // Reversed depth: the near plane is clip.z = w, the far plane clip.z = 0.
        for (const glm::dvec4& plane : {w + row(0), w - row(0), w + row(1), w - row(1), w - row(2), row(2)})
            if (const double length = glm::length(glm::dvec3(plane)); length > 0)
                spheres_.planes[spheres_.plane_count++] = plane / length;
    }

    const SphereView& spheres() const { return spheres_; }
    double along(glm::dvec3 point) const { return glm::dot(point, spheres_.forward); }

    bool may_touch_near_plane(glm::dvec3 centre, double radius) const {
        const double depth = along(centre);
        if (std::abs(depth - camera_.znear) > radius)
            return depth < camera_.znear; // wholly behind counts as inside: its far side may still show
        if (camera_.kind == ProjectionKind::orthographic)
            return true;
        return glm::length(centre) <= radius + camera_.znear * corner_;
    }

private:
    Camera camera_;
    double corner_; ///< distance to the near plane's corner, in near distances
    SphereView spheres_;
};

LightGroup group_of(const PlacedLight& light, const LightView& view, glm::dvec3 centre, double radius) {
    const bool inside = view.may_touch_near_plane(centre, radius);
    if (is_cone(light.light))
        return inside ? LightGroup::cone_inside : LightGroup::cone_outside;
    return inside ? LightGroup::sphere_inside : LightGroup::sphere_outside;
}

} // namespace

bool is_cone(const Light& light) { return light.kind == LightKind::spot && light.outer_cone < widest_cone; }

bool builds_lists(LightCulling culling) {
    return culling == LightCulling::tiles || culling == LightCulling::clusters || culling == LightCulling::grid;
}

double volume_reach(const Light& light, bool spot_boxes) {
    if (!is_cone(light))
        return 1.08; // sphere_volume()'s corners lie at 1.0716, times light_volume.vert's 1.001
    if (spot_boxes)  // a far corner of the box: sin(outer cone) to both sides
        return std::sqrt(1 + 2 * std::pow(std::sin(double(light.outer_cone)), 2)) * 1.002;
    // The rim of the cone and the rim of its cap, on polygons of `cone_sides` around their circles.
    const double outward = 1 / std::cos(3.14159265358979323846 / cone_sides);
    const double angle = light.outer_cone;
    const double rim = std::hypot(std::cos(angle), std::sin(angle) * outward);
    const double cap = std::hypot(1.0, std::tan(angle / 2) * outward);
    return std::max(rim, cap) * 1.002;
}

static uint32_t falloff_code(Falloff falloff) {
    switch (falloff) {
    case Falloff::gltf: return LIGHT_FALLOFF_GLTF;
    case Falloff::linear: return LIGHT_FALLOFF_LINEAR;
    case Falloff::quadratic: return LIGHT_FALLOFF_QUADRATIC;
    }
    return LIGHT_FALLOFF_GLTF;
}

shared::LightData light_data(const PlacedLight& placed, glm::dvec3 camera, double exposure) {
    const Light& light = placed.light;
    const bool directional = light.kind == LightKind::directional;
    shared::LightData data{};
    data.position = directional ? -glm::dvec3(placed.direction) : placed.position - camera;
    data.kind = directional ? LIGHT_DIRECTIONAL : falloff_code(light.falloff);
    data.colour = glm::dvec3(light.colour) * (largest_intensity(light) * exposure);
    data.inverse_range = static_cast<float>(has_volume(light) ? 1.0 / light.range : 0.0);
    data.axis = placed.direction;
    data.shininess = light.shininess;
    double scale = 0, offset = 1;
    if (light.kind == LightKind::spot) {
        const double outer = std::cos(double(light.outer_cone)), inner = std::cos(double(light.inner_cone));
        scale = 1 / std::max(1e-3, inner - outer);
        offset = -outer * scale;
    }
    data.cone = glm::vec2(scale, offset);
    data.outer_angle = light.outer_cone;
    return data;
}

LightGroups group_lights(std::span<const PlacedLight> lights, const LightSpheres& spheres, const PlacedCamera& camera,
                         const shared::FrameConstants& constants, double aspect, VkExtent2D extent,
                         LightCulling culling, bool depth_clamp, bool spot_boxes) {
    const bool rectangles = culling == LightCulling::rectangles, lists = builds_lists(culling);
    const bool culls = culling != LightCulling::fullscreen;
    const ScreenBoundsOf screen_bounds(camera, aspect);
    std::vector<shared::LightScreenBounds> bounds(rectangles ? lights.size() : 0);
    std::array<std::vector<uint32_t>, light_group_count> members;
    LightGroups groups;
    const LightView view(camera, constants);
    const auto group_of_volume = [&](uint32_t i) -> std::optional<LightGroup> {
        const PlacedLight& light = lights[i];
        if (rectangles) {
            const ScreenBounds screen = screen_bounds(light);
            if (screen.empty())
                return {};
            bounds[i] = light_bounds(screen, constants, extent);
        }
        const glm::dvec3 centre = light.position - camera.position;
        const double radius = light.light.range * volume_reach(light.light, spot_boxes);
        if (depth_clamp || rectangles || view.along(centre) + radius < camera.camera.zfar)
            return group_of(light, view, centre, radius);
        return LightGroup::fullscreen;
    };
    SphereBatch batch;
    for (size_t first = 0; first < lights.size(); first += sphere_batch) {
        const size_t count = std::min(sphere_batch, lights.size() - first);
        if (culls)
            test_spheres(spheres, first, count, camera.position, view.spheres(), batch);
        for (size_t at = 0; at < count; ++at) {
            const auto i = static_cast<uint32_t>(first + at);
            const double radius = spheres.radius[i];
            if (radius == -LightSpheres::endless || (culls && !batch.shows[at]))
                continue;
            std::optional<LightGroup> group = LightGroup::fullscreen;
            if (culls && radius != LightSpheres::endless)
                group = lists ? LightGroup::listed : group_of_volume(i);
            if (group == LightGroup::listed)
                groups.listed_pictures += batch.share[at];
            if (group)
                members[static_cast<size_t>(*group)].push_back(i);
        }
    }
    size_t total = 0;
    for (const std::vector<uint32_t>& group : members)
        total += group.size();
    groups.order.reserve(total);
    for (size_t g = 0; g < light_group_count; ++g) {
        groups.first[g] = static_cast<uint32_t>(groups.order.size());
        groups.count[g] = static_cast<uint32_t>(members[g].size());
        groups.order.insert(groups.order.end(), members[g].begin(), members[g].end());
    }
    if (rectangles) {
        groups.bounds.reserve(total);
        for (const uint32_t light : groups.order)
            groups.bounds.push_back(bounds[light]);
    }
    return groups;
}

} // namespace prelight::resident
