#pragma once
#include "../session.hpp"
#include "figures.hpp"
#include "gizmo.hpp"

#include <prelight/renderer.hpp>

struct GLFWwindow;
struct ImDrawData;

namespace prelight::app::viewer {

/// What panels are built from, and where what they ask for goes.
struct PanelFrame {
    const Session& session;
    const Figures& figures;
    const std::map<std::string, std::string>& in_force; ///< settings, as Stats has them
    std::vector<Event>& events;
    double scale = 1; ///< of the screen

    void ask(std::string verb, std::vector<std::string> words = {}) const {
        events.push_back({0, std::move(verb), std::move(words)});
    }
};

// Each in its file; all stand in one window, below each other.
void renderer_panel(const PanelFrame& frame);
void lights_panel(const PanelFrame& frame);
void objects_panel(const PanelFrame& frame);
void camera_panel(const PanelFrame& frame);
void time_panel(const PanelFrame& frame);
void figures_panel(const PanelFrame& frame);
/// Over the picture: lights' marks, the selection with its reach.
void draw_marks(const PanelFrame& frame);
void help_panel(const PanelFrame& frame);
/// True: dismissed.
bool message_panel(const PanelFrame& frame);

/// Dear ImGui with the panels.
class Ui {
public:
    Ui(GLFWwindow* window, double scale);
    ~Ui();
    Ui(const Ui&) = delete;
    Ui& operator=(const Ui&) = delete;

    /// Lays out a line in the middle of a window that has nothing else to show yet.
    void wait(const std::string& line);
    /// Lays out one picture's panels; what the user does in them comes back as events.
    std::vector<Event> build(Session& session, const Figures& figures,
                             const std::map<std::string, std::string>& in_force);
    /// The keyboard goes to the panels, or back to the camera, with the next picture. Not by ImGui's own keys: of those
    /// it sees only what is held down when a picture begins.
    void focus_panels(bool on) { focus_ = on; }
    const ImDrawData& data() const;
    bool wants_mouse() const;
    bool wants_keyboard() const;
    /// Something in the panels moves on by itself (a text cursor, a held button).
    bool busy() const;

private:
    double scale_;
    Gizmo gizmo_;
    std::optional<bool> focus_ = false; ///< asked for; at the start keys are the camera's
};

} // namespace prelight::app::viewer
