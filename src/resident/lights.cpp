#include "lights.hpp"
#include "light_bounds.hpp"
#include <algorithm>
#include <cmath>
#include <prelight/light_distribution.hpp>

namespace prelight::resident {
namespace {

constexpr double widest_cone = 80.0 / 180.0 * 3.14159265358979323846;

/// A range so large that its inverse is no normal float is none.
constexpr float longest_range = 1e18f;

bool has_volume(const Light& light) { return light.kind != LightKind::directional && light.range < longest_range; }

bool is_dark(const Light& light) {
    return light.intensity <= 0 || (light.colour.x <= 0 && light.colour.y <= 0 && light.colour.z <= 0);
}

/// What of a view the test of each light needs, made once a frame. World space relative to the camera.
class LightView {
public:
    LightView(const PlacedCamera& camera, const shared::FrameConstants& constants)
        : camera_(camera.camera), forward_(constants.forward),
          corner_(glm::length(glm::dvec3(constants.ray_right) + glm::dvec3(constants.ray_up) + forward_)),
          across_(glm::length(glm::dvec3(constants.ray_right)) * glm::length(glm::dvec3(constants.ray_up))) {
        const glm::dmat4 clip(constants.clip_from_world);
        const auto row = [&](int r) { return glm::dvec4(clip[0][r], clip[1][r], clip[2][r], clip[3][r]); };
        const glm::dvec4 w = row(3);
        // Reversed depth: the near plane is clip.z = w, the far plane clip.z = 0.
        for (const glm::dvec4& plane : {w + row(0), w - row(0), w + row(1), w - row(1), w - row(2), row(2)})
            if (const double length = glm::length(glm::dvec3(plane)); length > 0)
                planes_[count_++] = plane / length;
    }

    /// The sphere lies wholly behind one of the view's planes.
    bool misses(glm::dvec3 centre, double radius) const {
        for (size_t p = 0; p < count_; ++p)
            if (glm::dot(glm::dvec3(planes_[p]), centre) + planes_[p].w < -radius)
                return true;
        return false;
    }
    double along(glm::dvec3 point) const { return glm::dot(point, forward_); }

    bool may_touch_near_plane(glm::dvec3 centre, double radius) const {
        const double depth = along(centre);
        if (std::abs(depth - camera_.znear) > radius)
            return depth < camera_.znear; // wholly behind counts as inside: its far side may still show
        if (camera_.kind == ProjectionKind::orthographic)
            return true;
        return glm::length(centre) <= radius + camera_.znear * corner_;
    }

    /// The share of the picture that a sphere covers, roughly; 1 when the camera is in it.
    double share(glm::dvec3 centre, double radius) const {
        double distance2 = 1;
        if (camera_.kind == ProjectionKind::perspective) {
            const double depth = along(centre);
            if (depth <= radius)
                return 1;
            distance2 = depth * depth - radius * radius;
        }
        return std::min(0.785 * radius * radius / (across_ * distance2), 1.0);
    }

private:
    Camera camera_;
    glm::dvec3 forward_{0};
    double corner_; ///< distance to the near plane's corner, in near distances
    double across_; ///< a quarter of the picture's area at distance 1
    std::array<glm::dvec4, 6> planes_{};
    size_t count_ = 0;
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

LightGroups group_lights(std::span<const PlacedLight> lights, const PlacedCamera& camera,
                         const shared::FrameConstants& constants, double aspect, VkExtent2D extent,
                         LightCulling culling, bool depth_clamp, bool spot_boxes) {
    const bool rectangles = culling == LightCulling::rectangles, lists = builds_lists(culling);
    const ScreenBoundsOf screen_bounds(camera, aspect);
    std::vector<shared::LightScreenBounds> bounds(rectangles ? lights.size() : 0);
    std::array<std::vector<uint32_t>, light_group_count> members;
    LightGroups groups;
    const LightView view(camera, constants);
    for (uint32_t i = 0; i < lights.size(); ++i) {
        const PlacedLight& light = lights[i];
        if (is_dark(light.light))
            continue;
        LightGroup group = LightGroup::fullscreen;
        if (culling != LightCulling::fullscreen && has_volume(light.light)) {
            const glm::dvec3 centre = light.position - camera.position;
            if (view.misses(centre, light.light.range))
                continue;
            if (rectangles) {
                const ScreenBounds screen = screen_bounds(light);
                if (screen.empty())
                    continue;
                bounds[i] = light_bounds(screen, constants, extent);
            }
            if (lists) {
                group = LightGroup::listed;
                groups.listed_pictures += view.share(centre, light.light.range);
            } else {
                const double radius = light.light.range * volume_reach(light.light, spot_boxes);
                if (depth_clamp || rectangles || view.along(centre) + radius < camera.camera.zfar)
                    group = group_of(light, view, centre, radius);
            }
        }
        members[static_cast<size_t>(group)].push_back(i);
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
