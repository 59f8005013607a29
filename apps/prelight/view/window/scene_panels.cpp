// Lights, objects, camera and time.
#include "ui.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <limits>

namespace prelight::app::viewer {
namespace {

std::string text(double value) { return fmt::format("{}", value); }

void toggle(const PanelFrame& frame, const char* label, const char* verb, bool now) {
    if (ImGui::Checkbox(label, &now))
        frame.ask(verb, {now ? "on" : "off"});
}

/// What moves by a drag: the difference goes out, metres.
void position_widget(const PanelFrame& frame, const char* verb, uint32_t number, glm::dvec3 position, double size) {
    float at[] = {static_cast<float>(position.x), static_cast<float>(position.y), static_cast<float>(position.z)};
    const glm::vec3 before(at[0], at[1], at[2]);
    if (ImGui::DragFloat3("position", at, static_cast<float>(size / 500), 0, 0, "%.3g"))
        frame.ask(verb,
                  {fmt::format("{}", number), text(at[0] - before.x), text(at[1] - before.y), text(at[2] - before.z)});
}

void selected_light(const PanelFrame& frame, uint32_t index, const PlacedLight& placed, double size) {
    const Light& light = placed.light;
    const std::string number = fmt::format("{}", index);
    const char* kinds[] = {"directional", "point", "spot"};
    ImGui::Text("light %u: %s %s", index, kinds[static_cast<size_t>(light.kind)], light.name.c_str());
    if (light.kind != LightKind::directional)
        position_widget(frame, "move-light", index, placed.position, size);
    float colour[] = {light.colour.r, light.colour.g, light.colour.b};
    if (ImGui::ColorEdit3("colour", colour, ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR))
        frame.ask("light-colour", {number, text(colour[0]), text(colour[1]), text(colour[2])});
    float intensity = light.intensity;
    if (ImGui::DragFloat(light.kind == LightKind::directional ? "lux" : "candela", &intensity,
                         std::max(intensity, 0.01f) / 100, 0, 1e6f, "%.4g"))
        frame.ask("light-intensity", {number, text(std::max(intensity, 0.0f))});
    if (light.kind != LightKind::directional) {
        float range = std::isinf(light.range) ? 0 : light.range;
        if (ImGui::DragFloat("range (0: no end)", &range, static_cast<float>(size / 500), 0, 1e6f, "%.3g"))
            frame.ask("light-range", {number, text(std::max(range, 0.0f))});
    }
    toggle(frame, "shines alone (O)", "only-selected", frame.session.only_selected());
    if (ImGui::Button("remove (Delete)"))
        frame.ask("remove-light", {number});
}

/// What the selected light reaches, by the way in which lights find their pixels.
void reach_widget(const PanelFrame& frame) {
    ImGui::TextUnformatted("its reach:");
    for (const char* way : {"volumes", "tiles", "clusters"}) {
        ImGui::SameLine();
        if (!ImGui::SmallButton(way[0] == 'v' ? "pixels" : way))
            continue;
        frame.ask("set", {"light-culling", way});
        frame.ask("only-selected", {"on"});
        frame.ask("buffer", {"light-count"});
    }
    if (frame.session.look().buffer == "light-count") {
        ImGui::SameLine();
        if (ImGui::SmallButton("picture")) {
            frame.ask("only-selected", {"off"});
            frame.ask("buffer", {"final"});
        }
    }
}

double size_of(const World& world) { return std::max(glm::length(world.bounds_max - world.bounds_min), 1e-3); }

} // namespace

void lights_panel(const PanelFrame& frame) {
    const Session& session = frame.session;
    const Stage& stage = session.stage();
    const uint32_t numbers = stage.light_edits.numbers(stage.own_lights());
    if (!ImGui::CollapsingHeader(fmt::format("Lights ({})###Lights", numbers - stage.light_edits.removed()).c_str(),
                                 ImGuiTreeNodeFlags_DefaultOpen))
        return;
    ImGui::PushID("lights");
    ImGui::PushItemWidth(ImGui::GetWindowWidth() * 0.5f);
    if (ImGui::Button("add (Insert)"))
        frame.ask("add-light");
    ImGui::SameLine();
    if (ImGui::Button("random (N)"))
        frame.ask("random-lights");
    ImGui::SameLine();
    toggle(frame, "go round (V)", "turn-lights", session.turns_lights());
    const Selection selection = session.selection();
    const auto light = selection.kind == SelectionKind::light ? stage.light(selection.number) : std::nullopt;
    auto number = light ? static_cast<int>(selection.number) : -1;
    if (numbers > 0 &&
        ImGui::SliderInt("select", &number, 0, static_cast<int>(numbers) - 1, number < 0 ? "none" : "%d") &&
        number >= 0 && stage.light(static_cast<uint32_t>(number)))
        frame.ask("select-light", {fmt::format("{}", number)});
    if (light) {
        selected_light(frame, selection.number, *light, size_of(stage.world()));
        reach_widget(frame);
    } else {
        ImGui::TextDisabled("L selects the light at the cursor");
    }
    ImGui::PopItemWidth();
    ImGui::PopID();
}

void objects_panel(const PanelFrame& frame) {
    const Session& session = frame.session;
    const World& world = session.stage().world();
    if (!ImGui::CollapsingHeader(fmt::format("Objects ({})###Objects", world.instances.size()).c_str()))
        return;
    ImGui::PushID("objects");
    ImGui::PushItemWidth(ImGui::GetWindowWidth() * 0.5f);
    toggle(frame, "turn (B)", "turn-objects", session.turns_objects());
    ImGui::SameLine();
    if (ImGui::Button("next material (M)"))
        frame.ask("cycle-materials");
    const Selection selection = session.selection();
    const auto instance = std::ranges::find(world.instances, selection.number, &Instance::node);
    if (selection.kind == SelectionKind::object && instance != world.instances.end()) {
        const Scene& scene = session.stage().scene();
        const Mesh& mesh = world.mesh_of(*instance);
        const std::string& node = scene.nodes.at(selection.number).name;
        ImGui::TextWrapped("node %u %s, mesh %s", selection.number, node.c_str(), mesh.name.c_str());
        for (const Primitive& primitive : mesh.primitives)
            ImGui::TextWrapped("%zu triangles, material %s", primitive.indices.size() / 3,
                               scene.materials.at(primitive.material).name.c_str());
        position_widget(frame, "move-object", selection.number, glm::dvec3(instance->transform[3]), size_of(world));
    } else {
        ImGui::TextDisabled("a click selects");
    }
    ImGui::PopItemWidth();
    ImGui::PopID();
}

void camera_panel(const PanelFrame& frame) {
    if (!ImGui::CollapsingHeader("Camera"))
        return;
    const Session& session = frame.session;
    toggle(frame, "goes round (C)", "turn-camera", session.turns_camera());
    ImGui::SameLine();
    if (ImGui::Button("frame all (F)"))
        frame.ask("frame");
    const auto& cameras = session.stage().world().cameras;
    for (size_t i = 0; i < cameras.size(); ++i)
        if (ImGui::Selectable(fmt::format("{} {}", i, cameras[i].camera.name).c_str()))
            frame.ask("camera", {fmt::format("{}", i)});
    const glm::dvec3 at = session.camera().position;
    ImGui::Text("at %.2f %.2f %.2f", at.x, at.y, at.z);
    auto scale = static_cast<float>(session.scale());
    if (ImGui::SliderFloat("scale", &scale, 0.25f, 1, "%.2f"))
        frame.ask("scale", {text(scale)});
}

void time_panel(const PanelFrame& frame) {
    const Session& session = frame.session;
    const Scene& scene = session.stage().scene();
    if (scene.animations.empty() && scene.emitters.empty())
        return;
    if (!ImGui::CollapsingHeader("Animation", ImGuiTreeNodeFlags_DefaultOpen))
        return;
    ImGui::PushID("time");
    ImGui::PushItemWidth(ImGui::GetWindowWidth() * 0.5f);
    if (ImGui::Button(session.playing() ? "pause (Space)" : "play (Space)"))
        frame.ask("play", {"toggle"});
    const double length = session.stage().length(session.animation());
    auto time = static_cast<float>(session.time());
    if (ImGui::SliderFloat("seconds", &time, 0, static_cast<float>(length > 0 ? length : 10)))
        frame.ask("time", {text(time)});
    auto speed = static_cast<float>(session.speed());
    if (ImGui::SliderFloat("speed", &speed, -4, 4))
        frame.ask("speed", {text(speed)});
    const std::string now = session.animation() ? scene.animations[*session.animation()].name : "all";
    if (scene.animations.size() > 1 && ImGui::BeginCombo("animation", now.c_str())) {
        if (ImGui::Selectable("all"))
            frame.ask("animation", {""});
        for (size_t a = 0; a < scene.animations.size(); ++a)
            if (ImGui::Selectable(fmt::format("{} {}", a, scene.animations[a].name).c_str()))
                frame.ask("animation", {fmt::format("{}", a)});
        ImGui::EndCombo();
    }
    ImGui::PopItemWidth();
    ImGui::PopID();
}

} // namespace prelight::app::viewer
