#pragma once
#include "../event.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>
#include <vulkan/vulkan_core.h>

struct GLFWwindow;

namespace prelight::app::viewer {

/// A window of the system, and what happens in it as events of a session.
class GlfwWindow {
public:
    /// `width` and `height` in pixels, as far as the screen has room. Throws Error where there is no window system.
    GlfwWindow(const std::string& title, uint32_t width, uint32_t height);
    ~GlfwWindow();
    GlfwWindow(const GlfwWindow&) = delete;
    GlfwWindow& operator=(const GlfwWindow&) = delete;

    /// Instance extensions for its surface.
    static std::vector<std::string> extensions();
    /// Throws Error.
    VkSurfaceKHR make_surface(VkInstance instance) const;
    /// Waits for input, `seconds` at most, and takes it in.
    void wait(double seconds);
    /// What has happened since the last call, in order; their steps are the caller's to fill in.
    std::vector<Event> take_events();
    /// Something happened to the window or in it, events or not.
    bool take_stir();
    /// The panels have the mouse or the keyboard: what begins there is no event.
    void capture(bool mouse, bool keyboard);
    /// Escape was pressed while the panels had the keyboard.
    bool take_escape() { return std::exchange(escaped_, false); }
    bool closed() const;
    void set_title(const std::string& title) const;
    /// Pixels now.
    VkExtent2D extent() const;
    double content_scale() const; ///< of the screen: 2 on one with twice the usual dots
    double refresh_rate() const;  ///< Hz
    GLFWwindow* handle() const { return window_; }

private:
    struct Callbacks;
    void add(std::string verb, std::vector<std::string> words);

    GLFWwindow* window_ = nullptr;
    std::vector<Event> events_;
    bool mouse_captured_ = false, keyboard_captured_ = false, escaped_ = false, stirred_ = true;
    double pixels_per_unit_ = 1; ///< of the window system's coordinates
};

} // namespace prelight::app::viewer
