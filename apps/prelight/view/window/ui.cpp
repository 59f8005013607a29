#include "ui.hpp"

#include <fmt/format.h>
#include <imgui.h>
#include <utility>
#if __has_include(<backends/imgui_impl_glfw.h>) // as Debian has it
#include <backends/imgui_impl_glfw.h>
#else
#include <imgui_impl_glfw.h>
#endif

namespace prelight::app::viewer {
namespace {

constexpr float font_pixels = 13; // of the font that comes with Dear ImGui
constexpr float panel_width = 330;

void set_style(double scale) {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 4;
    style.FrameRounding = 3;
    style.GrabRounding = 3;
    style.Colors[ImGuiCol_WindowBg].w = 0.86f; // the picture shows through
    style.ScaleAllSizes(static_cast<float>(scale));
}

} // namespace

Ui::Ui(GLFWwindow* window, double scale) : scale_(scale) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // nothing is left behind
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    io.BackendRendererName = "prelight";
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    ImFontConfig font;
    font.SizePixels = font_pixels * static_cast<float>(scale);
    io.Fonts->AddFontDefault(&font);
    set_style(scale);
    ImGui_ImplGlfw_InitForVulkan(window, true); // after the window's own callbacks, which it then calls
}

Ui::~Ui() {
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Ui::wait(const std::string& line) {
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    const ImVec2 screen = ImGui::GetIO().DisplaySize, size = ImGui::CalcTextSize(line.c_str());
    ImGui::GetForegroundDrawList()->AddText({(screen.x - size.x) / 2, (screen.y - size.y) / 2},
                                            ImGui::GetColorU32(ImGuiCol_Text), line.c_str());
    ImGui::Render();
}

std::vector<Event> Ui::build(Session& session, const Figures& figures,
                             const std::map<std::string, std::string>& in_force) {
    std::vector<Event> events;
    const PanelFrame frame{session, figures, in_force, events, scale_};
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    draw_marks(frame);
    gizmo_.build(session, events);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const auto unit = static_cast<float>(scale_);
    if (session.shows_panels()) {
        ImGui::SetNextWindowPos({10 * unit, 10 * unit}, ImGuiCond_FirstUseEver);
        ImGui::SetNextWindowSize({panel_width * unit, std::max(screen.y - 20 * unit, 100 * unit)},
                                 ImGuiCond_FirstUseEver);
        const std::optional<bool> focus = std::exchange(focus_, {});
        if (focus == true)
            ImGui::SetNextWindowFocus();
        ImGui::Begin("Prelight (G hides, ? helps)", nullptr, ImGuiWindowFlags_NoFocusOnAppearing);
        renderer_panel(frame);
        figures_panel(frame);
        lights_panel(frame);
        objects_panel(frame);
        camera_panel(frame);
        time_panel(frame);
        if (focus == false && !ImGui::IsAnyItemActive()) // a text that is edited ends first
            ImGui::SetWindowFocus(nullptr);
        ImGui::End();
    }
    help_panel(frame);
    if (message_panel(frame))
        session.dismiss_messages();
    ImGui::Render();
    return events;
}

const ImDrawData& Ui::data() const { return *ImGui::GetDrawData(); }

bool Ui::wants_mouse() const { return ImGui::GetIO().WantCaptureMouse || gizmo_.holds_mouse(); }

bool Ui::wants_keyboard() const { return ImGui::GetIO().WantCaptureKeyboard || ImGui::GetIO().WantTextInput; }

bool Ui::busy() const { return ImGui::IsAnyItemActive() || ImGui::GetIO().WantTextInput; }

} // namespace prelight::app::viewer
