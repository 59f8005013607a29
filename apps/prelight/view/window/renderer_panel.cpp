// Renderer, preset and every setting, from the renderers' own tables.
#include "ui.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>
#include <setting_values/allows.hpp>

namespace prelight::app::viewer {
namespace {

/// A list to pick from. The word that was picked, or nothing.
std::optional<std::string> pick(const char* label, const std::string& now, const std::vector<std::string>& words,
                                const char* shown_when_empty = "none") {
    std::optional<std::string> picked;
    if (ImGui::BeginCombo(label, now.empty() ? shown_when_empty : now.c_str())) {
        for (const std::string& word : words)
            if (ImGui::Selectable(word.empty() ? shown_when_empty : word.c_str(), word == now) && word != now)
                picked = word;
        ImGui::EndCombo();
    }
    return picked;
}

void tip(const std::string& text) {
    if (!ImGui::IsItemHovered())
        return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 28);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool is_range(const std::string& value) { return value.find(" … ") != std::string::npos; }

/// What the setting is now: as it was asked for, or else as the renderer has resolved it.
std::string value_of(const PanelFrame& frame, const SettingInfo& setting) {
    const auto& asked = frame.session.look().options.settings;
    if (const auto found = asked.find(setting.key); found != asked.end())
        return found->second;
    const auto found = frame.in_force.find(setting.key);
    return found != frame.in_force.end() ? found->second : setting.default_value;
}

/// Whether what the setting needs is in force; a setting that has no effect is refused.
bool has_effect(const PanelFrame& frame, const SettingInfo& setting, const std::string& shading) {
    // Of several needs with one key, any value of theirs will do only where all say so: all have to hold.
    return std::ranges::all_of(setting.needs, [&](const SettingNeed& need) {
        const auto found = frame.in_force.find(need.key);
        const std::string now = need.key == "shading"           ? shading
                                : need.key == "msaa"            ? std::to_string(frame.session.look().options.msaa)
                                : found != frame.in_force.end() ? found->second
                                                                : "";
        return std::ranges::find(need.values, now) != need.values.end() ||
               (!need.or_view.empty() && frame.session.look().buffer == need.or_view);
    });
}

void number_widget(const PanelFrame& frame, const SettingInfo& setting, const std::string& now) {
    // Typed and then entered: each change makes a renderer.
    static std::map<std::string, std::string> drafts;
    std::string& draft = drafts[setting.key];
    char text[32] = {};
    const std::string& shown = draft.empty() ? now : draft;
    shown.copy(text, sizeof(text) - 1);
    if (ImGui::InputText(setting.key.c_str(), text, sizeof(text), ImGuiInputTextFlags_EnterReturnsTrue)) {
        if (text != now)
            frame.ask("set", {setting.key, text});
        draft.clear();
    } else {
        draft = ImGui::IsItemActive() ? text : "";
    }
}

void setting_widget(const PanelFrame& frame, const SettingInfo& setting, const std::string& shading) {
    const std::string now = value_of(frame, setting);
    const bool asked = frame.session.look().options.settings.contains(setting.key);
    const bool useful = has_effect(frame, setting, shading);
    ImGui::PushID(setting.key.c_str());
    ImGui::BeginDisabled(!useful && !asked);
    if (asked)
        ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1, 0.85f, 0.5f, 1));
    const bool numbers = std::ranges::any_of(setting.values, is_range);
    const bool two = setting.values.size() == 2 && allows(setting, "on") && allows(setting, "off");
    if (two) {
        bool on = now == "on";
        if (ImGui::Checkbox(setting.key.c_str(), &on))
            frame.ask("set", {setting.key, on ? "on" : "off"});
    } else if (numbers) {
        number_widget(frame, setting, now);
    } else if (const auto picked = pick(setting.key.c_str(), now, setting.values)) {
        frame.ask("set", {setting.key, *picked});
    }
    if (asked)
        ImGui::PopStyleColor();
    ImGui::EndDisabled();
    std::string help =
        fmt::format("{}\n{} (default {})", setting.description, fmt::join(setting.values, ", "), setting.default_value);
    for (const SettingNeed& need : setting.needs)
        help += fmt::format("\nneeds {}={}", need.key, fmt::join(need.values, "|"));
    std::ranges::replace(help, '\t', ' ');
    // The font has no such characters.
    for (size_t at; (at = help.find("…")) != std::string::npos;)
        help.replace(at, std::string_view("…").size(), "...");
    tip(help);
    if (asked) {
        ImGui::SameLine();
        if (ImGui::SmallButton("x"))
            frame.ask("unset", {setting.key});
        tip("back to its default");
    }
    ImGui::PopID();
}

} // namespace

void renderer_panel(const PanelFrame& frame) {
    const Look& look = frame.session.look();
    static const std::vector<RendererInfo> infos = renderer_infos();
    const auto info = std::ranges::find(infos, look.renderer, &RendererInfo::name);
    if (info == infos.end())
        return;
    ImGui::PushItemWidth(ImGui::GetWindowWidth() * 0.5f);
    std::vector<std::string> names;
    for (const RendererInfo& one : infos)
        names.push_back(one.name);
    if (const auto picked = pick("renderer", look.renderer, names))
        frame.ask("renderer", {*picked});
    tip(info->description);
    std::vector<std::string> presets{""};
    presets.insert(presets.end(), info->presets.begin(), info->presets.end());
    if (presets.size() > 1)
        if (const auto picked = pick("preset", look.options.preset, presets))
            frame.ask("preset", {*picked});
    std::vector<std::string> buffers = info->views;
    std::erase(buffers, "linear");
    if (const auto picked = pick("buffer", look.buffer, buffers))
        frame.ask("buffer", {*picked});
    const Shading shading = shading_in_force(*info, look.options);
    const std::string shading_word = shading == Shading::phong ? "phong" : "ggx";
    if (const auto picked = pick("shading", shading_word, {"ggx", "phong"}))
        frame.ask("shading", {*picked});
    const char* curves[] = {"pbr-neutral", "aces", "none"};
    if (const auto picked =
            pick("tonemap", curves[static_cast<size_t>(look.options.tonemap)], {"pbr-neutral", "aces", "none"}))
        frame.ask("tonemap", {*picked});
    auto exposure = static_cast<float>(look.options.exposure);
    if (ImGui::InputFloat("exposure EV", &exposure, 0.5f, 1, "%.2f", ImGuiInputTextFlags_EnterReturnsTrue))
        frame.ask("exposure", {fmt::format("{}", exposure)});
    // The multipass sample's own slider.
    if (const auto per_pass = std::ranges::find(info->settings, "lights-per-pass", &SettingInfo::key);
        per_pass != info->settings.end()) {
        int lights = std::atoi(value_of(frame, *per_pass).c_str());
        if (ImGui::SliderInt("lights a pass", &lights, 1, static_cast<int>(per_pass->values.size())))
            frame.ask("set", {per_pass->key, fmt::format("{}", lights)});
    }
    if (ImGui::CollapsingHeader("Settings"))
        for (const SettingInfo& setting : info->settings)
            setting_widget(frame, setting, shading_word);
    ImGui::PopItemWidth();
}

} // namespace prelight::app::viewer
