#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <prelight/error.hpp>
#include <prelight/vulkan.hpp>
#include <string>
#include <string_view>

#ifndef GLFW_INCLUDE_NONE
#define GLFW_INCLUDE_NONE
#endif
#include <GLFW/glfw3.h>

// GLFW declares it only where Vulkan's own header came first, and a program may have included GLFW before this one.
extern "C" GLFWAPI VkResult glfwCreateWindowSurface(VkInstance, GLFWwindow*, const VkAllocationCallbacks*,
                                                    VkSurfaceKHR*);

/// Windows of GLFW 3.3 (glfw.org). A header alone: nothing else of Prelight's knows GLFW. The program links it, and
/// calls all of this in its main thread.
namespace prelight::glfw {

/// A window with the device that draws for it. Keys, mouse and the rest are GLFW's, by handle(). The first one starts
/// GLFW and the last one ends it, with all windows that the program has made itself.
class Window {
public:
    /// Opens one, `width` × `height` screen coordinates large inside. Of the device `options` say the rest; their
    /// window_extensions are GLFW's. Throws Error: no display, or no device that shows pictures there.
    Window(const std::string& title, int width, int height, DeviceOptions options = {})
        : window_(open(title, width, height)) {
        uint32_t count = 0;
        const char** const names = glfwGetRequiredInstanceExtensions(&count);
        if (!names)
            fail();
        options.window_extensions.assign(names, names + count);
        device_ = Device::create(options);
        VkSurfaceKHR surface = VK_NULL_HANDLE;
        if (glfwCreateWindowSurface(vulkan::handles(*device_).instance, handle(), nullptr, &surface) != VK_SUCCESS)
            fail();
        presenter_ = std::make_unique<vulkan::Presenter>(*device_, surface);
    }

    /// Takes in what has been typed, clicked and resized since. False: somebody wants the window closed.
    bool is_open() {
        glfwPollEvents();
        return !glfwWindowShouldClose(handle());
    }
    /// Shows the renderer's last frame, as Presenter::show() does; the renderer is on device(). False: nothing could be
    /// shown now. Throws Error.
    bool show(const Renderer& renderer, const std::function<void(VkCommandBuffer, VkExtent2D)>& overlay = {},
              std::string_view buffer = "final") {
        return presenter_->show(renderer, size(), overlay, buffer);
    }

    /// Of its inside, pixels: what Renderer::resize() takes, unless it is 0 × 0, minimised.
    VkExtent2D size() const {
        int width = 0, height = 0;
        glfwGetFramebufferSize(handle(), &width, &height);
        return {static_cast<uint32_t>(width), static_cast<uint32_t>(height)};
    }
    /// For create_renderer(). It lives as long as the window.
    Device& device() const { return *device_; }
    /// For GLFW's own functions.
    GLFWwindow* handle() const { return window_.get(); }

private:
    struct Close {
        void operator()(GLFWwindow* window) const {
            glfwDestroyWindow(window);
            if (--count == 0)
                glfwTerminate();
        }
    };
    static inline int count = 0; ///< of windows that are open

    [[noreturn]] static void fail() {
        const char* reason = nullptr;
        glfwGetError(&reason);
        const std::string message = std::string("GLFW: ") + (reason ? reason : "no reason given");
        if (count == 0)
            glfwTerminate(); // nothing where it did not start
        throw Error(message);
    }
    static GLFWwindow* open(const std::string& title, int width, int height) {
        if (!glfwInit())
            fail();
        glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
        GLFWwindow* const window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
        if (!window)
            fail();
        ++count;
        return window;
    }

    std::unique_ptr<GLFWwindow, Close> window_;
    std::unique_ptr<Device> device_;
    std::unique_ptr<vulkan::Presenter> presenter_;
};

} // namespace prelight::glfw
