#include "gizmo.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <imgui.h>

namespace prelight::app::viewer {
namespace {

constexpr double arrow_share = 0.16; // of the picture's height
constexpr float near_pixels = 9;

ImVec2 on_screen(const PicturePoint& point) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    return {static_cast<float>(0.5 + 0.5 * point.x) * size.x, static_cast<float>(0.5 - 0.5 * point.y) * size.y};
}

/// Distance from a point to a stretch, pixels.
float distance(ImVec2 p, ImVec2 a, ImVec2 b) {
    const glm::vec2 along(b.x - a.x, b.y - a.y), to(p.x - a.x, p.y - a.y);
    const float length = glm::dot(along, along);
    const float share = length > 0 ? std::clamp(glm::dot(to, along) / length, 0.0f, 1.0f) : 0;
    return glm::length(to - share * along);
}

/// How far along the axis through `origin` the ray passes nearest to it, metres; absent: they are parallel.
std::optional<double> along_axis(const Ray& ray, glm::dvec3 origin, glm::dvec3 axis) {
    const glm::dvec3 w = origin - ray.origin;
    const double b = glm::dot(axis, ray.direction), below = 1 - b * b;
    if (below < 1e-6)
        return {};
    return (b * glm::dot(ray.direction, w) - glm::dot(axis, w)) / below;
}

} // namespace

std::optional<glm::dvec3> place_of_selection(const Session& session) {
    const Selection selection = session.selection();
    if (selection.kind == SelectionKind::light) {
        const auto light = session.stage().light(selection.number);
        if (light && light->light.kind != LightKind::directional)
            return light->position;
    }
    if (selection.kind == SelectionKind::object) {
        const World& world = session.stage().world();
        const auto instance = std::ranges::find(world.instances, selection.number, &Instance::node);
        if (instance != world.instances.end()) {
            const InstanceBox box = box_of(world, *instance);
            return (box.low + box.high) * 0.5;
        }
    }
    return {};
}

void Gizmo::build(const Session& session, std::vector<Event>& events) {
    hovered_ = false;
    const auto place = place_of_selection(session);
    const auto origin = place ? projected(session.camera(), *place, session.aspect()) : std::nullopt;
    if (!origin || session.minimised()) {
        axis_.reset();
        return;
    }
    const ImGuiIO& io = ImGui::GetIO();
    const Camera& camera = session.camera().camera;
    const double away = glm::dot(*place - session.camera().position, session.rig().forward());
    const double half = camera.kind == ProjectionKind::perspective ? away * std::tan(camera.yfov / 2) : camera.ymag;
    const double length = 2 * half * arrow_share;
    const ImVec2 size = io.DisplaySize;
    const PicturePoint mouse{2 * io.MousePos.x / size.x - 1, 1 - 2 * io.MousePos.y / size.y, session.aspect()};
    const Ray ray = ray_through(session.camera(), mouse);

    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImU32 colours[] = {IM_COL32(240, 80, 80, 255), IM_COL32(110, 220, 90, 255), IM_COL32(90, 140, 255, 255)};
    const ImVec2 from = on_screen(*origin);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 direction(0);
        direction[axis] = 1;
        const auto end = projected(session.camera(), *place + length * direction, session.aspect());
        if (!end)
            continue;
        const ImVec2 to = on_screen(*end);
        const bool over = !axis_ && !ImGui::IsWindowHovered(ImGuiHoveredFlags_AnyWindow) &&
                          distance(io.MousePos, from, to) < near_pixels && distance(io.MousePos, from, from) > 4;
        const bool lit = axis_ ? *axis_ == axis : over && !hovered_;
        list.AddLine(from, to, lit ? IM_COL32(255, 240, 120, 255) : colours[axis], lit ? 4 : 3);
        list.AddCircleFilled(to, 5, lit ? IM_COL32(255, 240, 120, 255) : colours[axis]);
        const auto now = along_axis(ray, *place, direction);
        if (over && !hovered_) {
            hovered_ = true;
            if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && now) {
                axis_ = axis;
                grabbed_ = *now;
            }
        }
        if (axis_ && *axis_ == axis && now && io.MouseDown[0] && *now != grabbed_ &&
            (io.MouseDelta.x != 0 || io.MouseDelta.y != 0)) {
            // The arrows follow, so that what is grabbed stays under the mouse.
            const glm::dvec3 by = (*now - grabbed_) * direction;
            const bool light = session.selection().kind == SelectionKind::light;
            events.push_back({0,
                              light ? "move-light" : "move-object",
                              {fmt::format("{}", session.selection().number), fmt::format("{}", by.x),
                               fmt::format("{}", by.y), fmt::format("{}", by.z)}});
        }
    }
    if (!io.MouseDown[0])
        axis_.reset();
}

} // namespace prelight::app::viewer
