// What lies over the picture: the selection, help, messages.
#include "../keys.hpp"
#include "ui.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <numbers>
#include <prelight/light_distribution.hpp>

namespace prelight::app::viewer {
namespace {

constexpr ImU32 mark_colour = IM_COL32(255, 225, 90, 220);

class Pen {
public:
    explicit Pen(const Session& session) : session_(session), list_(*ImGui::GetBackgroundDrawList()) {}

    void line(glm::dvec3 a, glm::dvec3 b) const {
        const auto p = place(a), q = place(b);
        if (p && q)
            list_.AddLine(*p, *q, mark_colour, 1.5f);
    }
    void ring(glm::dvec3 centre, glm::dvec3 u, glm::dvec3 v) const {
        constexpr int sides = 64;
        for (int i = 0; i < sides; ++i) {
            const double a = 2 * std::numbers::pi * i / sides, b = 2 * std::numbers::pi * (i + 1) / sides;
            line(centre + std::cos(a) * u + std::sin(a) * v, centre + std::cos(b) * u + std::sin(b) * v);
        }
    }
    void dot(glm::dvec3 at) const {
        if (const auto p = place(at))
            list_.AddCircle(*p, 9, mark_colour, 0, 2);
    }

private:
    std::optional<ImVec2> place(glm::dvec3 world) const {
        const auto point = projected(session_.camera(), world, session_.aspect());
        if (!point)
            return {};
        const ImVec2 size = ImGui::GetIO().DisplaySize;
        return ImVec2(static_cast<float>(0.5 + 0.5 * point->x) * size.x,
                      static_cast<float>(0.5 - 0.5 * point->y) * size.y);
    }
    const Session& session_;
    ImDrawList& list_;
};

void mark_light(const Pen& pen, const PlacedLight& placed) {
    const Light& light = placed.light;
    if (light.kind == LightKind::directional)
        return;
    pen.dot(placed.position);
    if (!std::isfinite(light.range))
        return;
    const double r = light.range;
    if (light.kind == LightKind::point) {
        const glm::dvec3 x(r, 0, 0), y(0, r, 0), z(0, 0, r);
        pen.ring(placed.position, x, y);
        pen.ring(placed.position, y, z);
        pen.ring(placed.position, z, x);
        return;
    }
    const glm::dmat3 axes = light_axes(placed);
    const double across = r * std::sin(light.outer_cone);
    const glm::dvec3 end = placed.position + r * std::cos(light.outer_cone) * placed.direction;
    pen.ring(end, across * axes[0], across * axes[1]);
    for (int side = 0; side < 4; ++side) {
        const glm::dvec3 out = (side < 2 ? axes[0] : axes[1]) * (side % 2 ? across : -across);
        pen.line(placed.position, end + out);
    }
}

void mark_box(const Pen& pen, const InstanceBox& box) {
    const auto corner = [&](int c) {
        return glm::dvec3(c & 1 ? box.high.x : box.low.x, c & 2 ? box.high.y : box.low.y,
                          c & 4 ? box.high.z : box.low.z);
    };
    for (int c = 0; c < 8; ++c)
        for (const int axis : {1, 2, 4})
            if (!(c & axis))
                pen.line(corner(c), corner(c | axis));
}

} // namespace

void draw_marks(const PanelFrame& frame) {
    const Session& session = frame.session;
    const Selection selection = session.selection();
    const Pen pen(session);
    if (selection.kind == SelectionKind::light)
        if (const auto light = session.stage().light(selection.number))
            mark_light(pen, *light);
    if (selection.kind == SelectionKind::object)
        for (const Instance& instance : session.stage().world().instances)
            if (instance.node == selection.number)
                mark_box(pen, box_of(session.stage().world(), instance));
}

void help_panel(const PanelFrame& frame) {
    if (!frame.session.shows_help())
        return;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x * 0.5f, screen.y * 0.5f}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowBgAlpha(0.97f);
    ImGui::Begin("Help", nullptr,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
    std::vector<std::pair<std::string_view, std::string_view>> rows;
    for (const Habit& habit : habits())
        rows.emplace_back(habit.keys, habit.meaning);
    for (const KeyBinding& binding : key_bindings())
        if (!binding.shown.empty())
            rows.emplace_back(binding.shown, binding.meaning);
    // Side by side where the window is too low for all of them below each other.
    const bool high = static_cast<float>(rows.size() + 3) * ImGui::GetTextLineHeightWithSpacing() < screen.y;
    const size_t below = high ? rows.size() : (rows.size() + 1) / 2;
    if (ImGui::BeginTable("keys", high ? 2 : 4, ImGuiTableFlags_SizingFixedFit)) {
        for (size_t r = 0; r < below; ++r) {
            ImGui::TableNextRow();
            for (size_t i = r; i < rows.size(); i += below) {
                ImGui::TableNextColumn();
                const auto& [keys, meaning] = rows[i];
                ImGui::TextColored(ImVec4(1, 0.85f, 0.5f, 1), "%.*s", static_cast<int>(keys.size()), keys.data());
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(meaning.data(), meaning.data() + meaning.size());
            }
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

bool message_panel(const PanelFrame& frame) {
    const auto& messages = frame.session.messages();
    if (messages.empty())
        return false;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const auto unit = static_cast<float>(frame.scale);
    ImGui::SetNextWindowPos({screen.x - 10 * unit, screen.y - 10 * unit}, ImGuiCond_Always, {1, 1});
    ImGui::SetNextWindowSize({std::min(520 * unit, screen.x - 20 * unit), 0}, ImGuiCond_Always);
    ImGui::Begin("Messages", nullptr,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
    for (const std::string& message : messages)
        ImGui::TextWrapped("%s", message.c_str());
    const bool dismissed = ImGui::SmallButton("dismiss");
    ImGui::End();
    return dismissed;
}

} // namespace prelight::app::viewer
