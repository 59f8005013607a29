#include "glfw_window.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <gpu/check.hpp>
#include <map>
#include <prelight/error.hpp>
#include <utility>
#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>

namespace prelight::app::viewer {
namespace {

/// The name that a `key` event has; empty: one that nobody asks for.
std::string key_name(int key, int modifiers) {
    if ((key >= GLFW_KEY_A && key <= GLFW_KEY_Z) || (key >= GLFW_KEY_0 && key <= GLFW_KEY_9))
        return std::string(1, static_cast<char>(key)); // GLFW numbers them as ASCII does
    if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9)
        return std::string(1, static_cast<char>('0' + key - GLFW_KEY_KP_0));
    if (key == GLFW_KEY_SLASH)
        return modifiers & GLFW_MOD_SHIFT ? "?" : "/";
    static const std::map<int, const char*> names{{GLFW_KEY_SPACE, "Space"},
                                                  {GLFW_KEY_ESCAPE, "Escape"},
                                                  {GLFW_KEY_ENTER, "Enter"},
                                                  {GLFW_KEY_TAB, "Tab"},
                                                  {GLFW_KEY_BACKSPACE, "Backspace"},
                                                  {GLFW_KEY_LEFT, "Left"},
                                                  {GLFW_KEY_RIGHT, "Right"},
                                                  {GLFW_KEY_UP, "Up"},
                                                  {GLFW_KEY_DOWN, "Down"},
                                                  {GLFW_KEY_PAGE_UP, "PageUp"},
                                                  {GLFW_KEY_PAGE_DOWN, "PageDown"},
                                                  {GLFW_KEY_HOME, "Home"},
                                                  {GLFW_KEY_END, "End"},
                                                  {GLFW_KEY_INSERT, "Insert"},
                                                  {GLFW_KEY_DELETE, "Delete"},
                                                  {GLFW_KEY_LEFT_SHIFT, "Shift"},
                                                  {GLFW_KEY_RIGHT_SHIFT, "Shift"},
                                                  {GLFW_KEY_LEFT_CONTROL, "Ctrl"},
                                                  {GLFW_KEY_RIGHT_CONTROL, "Ctrl"},
                                                  {GLFW_KEY_LEFT_ALT, "Alt"},
                                                  {GLFW_KEY_RIGHT_ALT, "Alt"},
                                                  {GLFW_KEY_F1, "F1"},
                                                  {GLFW_KEY_F12, "F12"},
                                                  {GLFW_KEY_COMMA, ","},
                                                  {GLFW_KEY_PERIOD, "."},
                                                  {GLFW_KEY_LEFT_BRACKET, "["},
                                                  {GLFW_KEY_RIGHT_BRACKET, "]"},
                                                  {GLFW_KEY_MINUS, "-"},
                                                  {GLFW_KEY_EQUAL, "="}};
    const auto found = names.find(key);
    return found == names.end() ? "" : found->second;
}

const char* button_name(int button) {
    return button == GLFW_MOUSE_BUTTON_LEFT     ? "left"
           : button == GLFW_MOUSE_BUTTON_MIDDLE ? "middle"
           : button == GLFW_MOUSE_BUTTON_RIGHT  ? "right"
                                                : nullptr;
}

std::string number(double value) { return fmt::format("{}", value); }

[[noreturn]] void fail(const char* what) {
    const char* reason = nullptr;
    glfwGetError(&reason);
    throw Error(fmt::format("window: {}: {}", what, reason ? reason : "the window system does not say why"));
}

} // namespace

struct GlfwWindow::Callbacks {
    static GlfwWindow& of(GLFWwindow* window) { return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window)); }
    static std::pair<double, double> cursor(GlfwWindow& self) {
        double x = 0, y = 0;
        glfwGetCursorPos(self.window_, &x, &y);
        return {x * self.pixels_per_unit_, y * self.pixels_per_unit_};
    }

    static void key(GLFWwindow* window, int key, int, int action, int modifiers) {
        GlfwWindow& self = of(window);
        const std::string name = key_name(key, modifiers);
        self.stirred_ = true;
        if (self.keyboard_captured_ && action == GLFW_PRESS && name == "Escape")
            self.escaped_ = true;
        if (name.empty() || action == GLFW_REPEAT || (self.keyboard_captured_ && action == GLFW_PRESS))
            return;
        self.add("key", {name, action == GLFW_PRESS ? "down" : "up"});
    }
    static void button(GLFWwindow* window, int button, int action, int) {
        GlfwWindow& self = of(window);
        const char* name = button_name(button);
        if (!name || (self.mouse_captured_ && action == GLFW_PRESS))
            return;
        const auto [x, y] = cursor(self);
        self.add("button", {name, action == GLFW_PRESS ? "down" : "up", number(x), number(y)});
    }
    static void moved(GLFWwindow* window, double x, double y) {
        GlfwWindow& self = of(window);
        if (!self.events_.empty() && self.events_.back().verb == "move")
            self.events_.pop_back(); // where it was meanwhile tells nothing
        self.add("move", {number(x * self.pixels_per_unit_), number(y * self.pixels_per_unit_)});
    }
    static void wheel(GLFWwindow* window, double x, double y) {
        GlfwWindow& self = of(window);
        if (!self.mouse_captured_)
            self.add("wheel", {number(x), number(y)});
    }
    static void resized(GLFWwindow* window, int width, int height) {
        of(window).add("resize", {fmt::format("{}", width), fmt::format("{}", height)});
    }
    static void focus(GLFWwindow* window, int focused) {
        if (!focused)
            of(window).add("leave", {});
        of(window).stirred_ = true;
    }
    static void dropped(GLFWwindow* window, int count, const char** files) {
        for (int i = 0; i < count; ++i)
            of(window).add("drop", {files[i]});
    }
    static void refresh(GLFWwindow* window) { of(window).stirred_ = true; }
};

GlfwWindow::GlfwWindow(const std::string& title, uint32_t width, uint32_t height) {
    if (!glfwInit())
        fail("there is no window system");
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    if (!glfwVulkanSupported()) {
        glfwTerminate();
        throw Error("window: the window system has no Vulkan");
    }
    if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
        int x = 0, y = 0, room_x = 0, room_y = 0;
        glfwGetMonitorWorkarea(monitor, &x, &y, &room_x, &room_y);
        if (room_x > 0 && room_y > 0) {
            width = std::min(width, static_cast<uint32_t>(room_x));
            height = std::min(height, static_cast<uint32_t>(room_y));
        }
    }
    window_ = glfwCreateWindow(static_cast<int>(width), static_cast<int>(height), title.c_str(), nullptr, nullptr);
    if (!window_) {
        glfwTerminate();
        throw Error("window: cannot be opened");
    }
    int units = 0, pixels = 0, ignored = 0;
    glfwGetWindowSize(window_, &units, &ignored);
    glfwGetFramebufferSize(window_, &pixels, &ignored);
    if (units > 0 && pixels > 0)
        pixels_per_unit_ = double(pixels) / units;
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, Callbacks::key);
    glfwSetMouseButtonCallback(window_, Callbacks::button);
    glfwSetCursorPosCallback(window_, Callbacks::moved);
    glfwSetScrollCallback(window_, Callbacks::wheel);
    glfwSetFramebufferSizeCallback(window_, Callbacks::resized);
    glfwSetWindowFocusCallback(window_, Callbacks::focus);
    glfwSetDropCallback(window_, Callbacks::dropped);
    glfwSetWindowRefreshCallback(window_, Callbacks::refresh);
}

GlfwWindow::~GlfwWindow() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void GlfwWindow::add(std::string verb, std::vector<std::string> words) {
    events_.push_back({0, std::move(verb), std::move(words)});
    stirred_ = true;
}

std::vector<std::string> GlfwWindow::extensions() {
    uint32_t count = 0;
    const char** names = glfwGetRequiredInstanceExtensions(&count);
    if (!names)
        throw Error("window: the window system has no Vulkan surfaces");
    return {names, names + count};
}

VkSurfaceKHR GlfwWindow::make_surface(VkInstance instance) const {
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    gpu::check(glfwCreateWindowSurface(instance, window_, nullptr, &surface), "window surface");
    return surface;
}

void GlfwWindow::wait(double seconds) {
    if (seconds > 0)
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
}

std::vector<Event> GlfwWindow::take_events() { return std::exchange(events_, {}); }

bool GlfwWindow::take_stir() { return std::exchange(stirred_, false); }

void GlfwWindow::capture(bool mouse, bool keyboard) {
    mouse_captured_ = mouse;
    keyboard_captured_ = keyboard;
}

bool GlfwWindow::closed() const { return glfwWindowShouldClose(window_); }

void GlfwWindow::set_title(const std::string& title) const { glfwSetWindowTitle(window_, title.c_str()); }

VkExtent2D GlfwWindow::extent() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    return {static_cast<uint32_t>(width), static_cast<uint32_t>(height)};
}

double GlfwWindow::content_scale() const {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::clamp(double(std::max(x, y)), 1.0, 4.0);
}

double GlfwWindow::refresh_rate() const {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    return mode && mode->refreshRate > 0 ? std::clamp(mode->refreshRate, 30, 240) : 60;
}

} // namespace prelight::app::viewer
