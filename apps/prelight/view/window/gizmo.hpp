#pragma once
#include "../session.hpp"

namespace prelight::app::viewer {

/// Three arrows at what is selected, along the world's axes: dragging one moves it.
class Gizmo {
public:
    /// Draws it and looks at the mouse; moves come out as events. Between ImGui::NewFrame() and Render().
    void build(const Session& session, std::vector<Event>& events);
    /// A drag of an arrow, or the mouse over one: not the camera's.
    bool holds_mouse() const { return hovered_ || axis_; }

private:
    std::optional<int> axis_; ///< that is dragged
    bool hovered_ = false;
    double grabbed_ = 0; ///< metres along the axis
};

/// Where the selection is; absent: nothing is, or it has no place (a directional light).
std::optional<glm::dvec3> place_of_selection(const Session& session);

} // namespace prelight::app::viewer
