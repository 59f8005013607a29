// What a picture costs: device time of each pass, one column a picture.
#include "ui.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace prelight::app::viewer {
namespace {

ImU32 colour_of(size_t pass) {
    // Hues a golden angle apart: neighbours differ.
    float r = 0, g = 0, b = 0;
    const float hue = std::fmod(0.58f + 0.381966f * static_cast<float>(pass), 1.0f);
    ImGui::ColorConvertHSVtoRGB(hue, 0.55f, 0.9f, r, g, b);
    return ImGui::GetColorU32(ImVec4(r, g, b, 1));
}

/// Stacked columns; the height is the dearest of them.
void plot(const std::deque<FrameFigures>& frames, double most) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const ImVec2 size(ImGui::GetContentRegionAvail().x, ImGui::GetFontSize() * 7);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(from, {from.x + size.x, from.y + size.y}, IM_COL32(0, 0, 0, 120));
    const float step = size.x / 120;
    float x = from.x + size.x - step * static_cast<float>(frames.size());
    for (const FrameFigures& frame : frames) {
        float y = from.y + size.y;
        for (size_t p = 0; p < frame.passes.size(); ++p) {
            const auto height = static_cast<float>(frame.passes[p].second / most * size.y);
            list.AddRectFilled({x, y - height}, {x + std::max(step - 0.5f, 1.0f), y}, colour_of(p));
            y -= height;
        }
        x += step;
    }
    list.AddText({from.x + 3, from.y + 2}, IM_COL32(255, 255, 255, 200), fmt::format("{:.2f} ms", most).c_str());
    ImGui::Dummy(size);
}

} // namespace

void figures_panel(const PanelFrame& frame) {
    const auto& frames = frame.figures.frames();
    const Session& session = frame.session;
    ImGui::Separator();
    ImGui::Text("%ux%u, %.1f ms from input to picture", session.picture_width(), session.picture_height(),
                frame.figures.shown_ms());
    if (frames.empty() || !ImGui::CollapsingHeader("Passes", ImGuiTreeNodeFlags_DefaultOpen))
        return;
    double most = 1e-3;
    std::vector<double> sums(frames.back().passes.size());
    for (const FrameFigures& one : frames) {
        most = std::max(most, one.gpu);
        for (size_t p = 0; p < sums.size() && p < one.passes.size(); ++p)
            sums[p] += one.passes[p].second;
    }
    plot(frames, most);
    double total = 0;
    for (size_t p = 0; p < sums.size(); ++p) {
        const double mean = sums[p] / static_cast<double>(frames.size());
        total += mean;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float side = ImGui::GetFontSize() * 0.8f;
        ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + 1}, {at.x + side, at.y + 1 + side}, colour_of(p));
        ImGui::Dummy({side, side});
        ImGui::SameLine();
        ImGui::Text("%7.2f ms  %s", mean, frames.back().passes[p].first.c_str());
    }
    ImGui::Text("   %7.2f ms  all passes, on the device", total);
}

} // namespace prelight::app::viewer
