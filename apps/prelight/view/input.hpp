#pragma once
#include "camera_rig.hpp"
#include "event.hpp"

#include <set>

namespace prelight::app::viewer {

/// Keys and buttons that are down, and where the mouse is: what becomes of them for the camera.
class Input {
public:
    /// A picture of this size, pixels.
    void resize(uint32_t width, uint32_t height);
    PicturePoint point(double x, double y) const;
    glm::dvec2 mouse() const { return mouse_; }
    double aspect() const { return width_ / height_; }

    void key(const std::string& name, bool down);
    /// True: this was a click of the left button, and no drag.
    bool button(const std::string& name, bool down, double x, double y);
    /// Where the drag takes the camera. Absent: it moves nothing.
    std::optional<Rig> move(const Rig& rig, double x, double y);
    Rig wheel(const Rig& rig, double notches) const { return dollied(rig, notches, point(mouse_.x, mouse_.y)); }
    void release_all();
    /// One step of what is held down. `pace`: metres a second. Absent: nothing is.
    std::optional<Rig> step(const Rig& rig, double pace) const;

private:
    bool is_down(const char* name) const { return down_.contains(name); }

    double width_ = 1280, height_ = 720;
    std::set<std::string, std::less<>> down_;
    std::string dragging_; ///< the button that began it; empty: none
    bool moved_ = false;   ///< since it went down
    glm::dvec2 mouse_{0}, pressed_{0};
};

} // namespace prelight::app::viewer
