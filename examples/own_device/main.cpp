// Pictures in a program that has a Vulkan device and a swapchain already: a GLFW window with moving lights, where
// Prelight draws into the swapchain's images. example_own_device [FRAMES]; with EXAMPLE_VALIDATE set under validation.
#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>
#include <prelight/vulkan.hpp>

namespace {

using namespace prelight;

void check(VkResult result, const char* what) {
    if (result != VK_SUCCESS && result != VK_SUBOPTIMAL_KHR)
        throw Error(std::string(what) + ": VkResult " + std::to_string(result));
}

bool wants_validation() { return std::getenv("EXAMPLE_VALIDATE") != nullptr; }

/// What a program like this one has before it meets Prelight: window, instance, device, queue.
struct Program {
    GLFWwindow* window = nullptr;
    VkInstance instance = VK_NULL_HANDLE;
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    uint32_t family = 0;
    vulkan::DeviceFeatures features;

    Program() {
        if (!glfwInit())
            throw Error("GLFW: no display");
        glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
        window = glfwCreateWindow(640, 360, "Prelight on another program's device", nullptr, nullptr);
        make_instance();
        check(glfwCreateWindowSurface(instance, window, nullptr, &surface), "surface");
        choose_device();
        make_device();
    }
    ~Program() {
        vkDestroyDevice(device, nullptr);
        vkDestroySurfaceKHR(instance, surface, nullptr);
        vkDestroyInstance(instance, nullptr);
        glfwTerminate();
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void make_instance() {
        VkApplicationInfo application{};
        application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
        application.apiVersion = VK_API_VERSION_1_3;
        uint32_t count = 0;
        const char** extensions = glfwGetRequiredInstanceExtensions(&count);
        const char* layer = "VK_LAYER_KHRONOS_validation"; // its messages go to stdout
        VkInstanceCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
        info.pApplicationInfo = &application;
        info.enabledExtensionCount = count;
        info.ppEnabledExtensionNames = extensions;
        info.enabledLayerCount = wants_validation() ? 1 : 0;
        info.ppEnabledLayerNames = &layer;
        check(vkCreateInstance(&info, nullptr, &instance), "instance");
    }

    /// The first device, and the first queue family of it for graphics and the window.
    void choose_device() {
        uint32_t count = 1;
        vkEnumeratePhysicalDevices(instance, &count, &physical);
        if (count == 0)
            throw Error("Vulkan: no device");
        std::array<VkQueueFamilyProperties, 16> families{};
        count = families.size();
        vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
        for (family = 0; family < count; ++family) {
            VkBool32 shows = VK_FALSE;
            vkGetPhysicalDeviceSurfaceSupportKHR(physical, family, surface, &shows);
            if (shows && (families[family].queueFlags & VK_QUEUE_GRAPHICS_BIT))
                return;
        }
        throw Error("Vulkan: no queue for this window");
    }

    /// With what Prelight wants, and what the program itself needs.
    void make_device() {
        features = vulkan::wanted_features(physical);
        features.extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
        const float priority = 1;
        VkDeviceQueueCreateInfo queues{};
        queues.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
        queues.queueFamilyIndex = family;
        queues.queueCount = 1;
        queues.pQueuePriorities = &priority;
        VkDeviceCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
        info.pNext = features.chain();
        info.queueCreateInfoCount = 1;
        info.pQueueCreateInfos = &queues;
        info.enabledExtensionCount = static_cast<uint32_t>(features.extensions.size());
        info.ppEnabledExtensionNames = features.extensions.data();
        check(vkCreateDevice(physical, &info, nullptr, &device), "device");
        vkGetDeviceQueue(device, family, 0, &queue);
    }
};

/// The window's images, with the semaphores that each frame needs.
class WindowImages {
public:
    explicit WindowImages(const Program& program) : program_(program) {
        VkSurfaceCapabilitiesKHR can{};
        check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(program.physical, program.surface, &can), "window");
        extent_ = can.currentExtent;
        VkSwapchainCreateInfoKHR info{};
        info.sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR;
        info.surface = program.surface;
        info.minImageCount = can.minImageCount;
        info.imageFormat = format;
        info.imageExtent = extent_;
        info.imageArrayLayers = 1;
        info.imageUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
        info.preTransform = can.currentTransform;
        info.compositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR;
        info.presentMode = VK_PRESENT_MODE_FIFO_KHR;
        info.clipped = VK_TRUE;
        check(vkCreateSwapchainKHR(program.device, &info, nullptr, &swapchain_), "window images");
        uint32_t count = 0;
        vkGetSwapchainImagesKHR(program.device, swapchain_, &count, nullptr);
        images_.resize(count);
        vkGetSwapchainImagesKHR(program.device, swapchain_, &count, images_.data());
        for (VkImage image : images_) {
            VkImageViewCreateInfo view{};
            view.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
            view.image = image;
            view.viewType = VK_IMAGE_VIEW_TYPE_2D;
            view.format = format;
            view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
            check(vkCreateImageView(program.device, &view, nullptr, &views_.emplace_back()), "window image");
            finished_.push_back(make_semaphore());
            acquired_.push_back(make_semaphore());
        }
        acquired_.push_back(make_semaphore()); // one more: it is taken before the image is known
    }
    ~WindowImages() {
        vkQueueWaitIdle(program_.queue);
        for (VkImageView view : views_)
            vkDestroyImageView(program_.device, view, nullptr);
        for (const auto* semaphores : {&acquired_, &finished_})
            for (VkSemaphore semaphore : *semaphores)
                vkDestroySemaphore(program_.device, semaphore, nullptr);
        vkDestroySwapchainKHR(program_.device, swapchain_, nullptr);
    }
    WindowImages(const WindowImages&) = delete;
    WindowImages& operator=(const WindowImages&) = delete;
    VkExtent2D extent() const { return extent_; }

    /// Prelight draws into the next image, which is then shown. False: the window is not what it was.
    bool show(Renderer& renderer, const PlacedCamera& camera) {
        const VkSemaphore acquired = acquired_[frame_++ % acquired_.size()];
        uint32_t index = 0;
        const VkResult got =
            vkAcquireNextImageKHR(program_.device, swapchain_, UINT64_MAX, acquired, VK_NULL_HANDLE, &index);
        if (got == VK_ERROR_OUT_OF_DATE_KHR)
            return false;
        check(got, "window");
        vulkan::render_into(renderer, camera,
                            {.image = images_[index],
                             .view = views_[index],
                             .format = format,
                             .extent = extent_,
                             .layout_after = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR,
                             .wait = {{acquired, 0, VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT}},
                             .signal = {{finished_[index]}}});
        VkPresentInfoKHR present{};
        present.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR;
        present.waitSemaphoreCount = 1;
        present.pWaitSemaphores = &finished_[index];
        present.swapchainCount = 1;
        present.pSwapchains = &swapchain_;
        present.pImageIndices = &index;
        const VkResult shown = vkQueuePresentKHR(program_.queue, &present);
        if (shown == VK_ERROR_OUT_OF_DATE_KHR)
            return false;
        check(shown, "window");
        return shown == VK_SUCCESS && got == VK_SUCCESS;
    }

private:
    static constexpr VkFormat format = VK_FORMAT_B8G8R8A8_SRGB;

    VkSemaphore make_semaphore() const {
        VkSemaphoreCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
        VkSemaphore semaphore = VK_NULL_HANDLE;
        check(vkCreateSemaphore(program_.device, &info, nullptr, &semaphore), "semaphore");
        return semaphore;
    }

    const Program& program_;
    VkExtent2D extent_{};
    VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
    std::vector<VkImage> images_;
    std::vector<VkImageView> views_;
    std::vector<VkSemaphore> acquired_, finished_;
    uint64_t frame_ = 0;
};

void run(int frames) {
    const Program program;
    const std::unique_ptr<Device> device = Device::adopt({.instance = program.instance,
                                                          .physical_device = program.physical,
                                                          .device = program.device,
                                                          .queue = program.queue,
                                                          .queue_family = program.family,
                                                          .enabled = program.features});
    const Scene scene = make_scene("lights", 1000, 1);
    World world = resolve(scene);
    const std::vector<PlacedLight> rest = world.lights;
    auto images = std::make_unique<WindowImages>(program);
    const auto renderer = create_renderer("light-prepass", device.get(),
                                          {.width = images->extent().width, .height = images->extent().height});
    renderer->set_world(world);
    for (int frame = 0; !glfwWindowShouldClose(program.window) && (frames == 0 || frame < frames); ++frame) {
        glfwPollEvents();
        for (size_t i = 0; i < rest.size(); ++i) {
            const double angle = 0.05 * frame + 2.4 * double(i);
            world.lights[i].position = rest[i].position + 0.3 * glm::dvec3(std::cos(angle), 0, std::sin(angle));
        }
        renderer->set_lights(world.lights);
        if (images->show(*renderer, world.cameras.at(0)))
            continue;
        int width = 0, height = 0;
        for (glfwGetFramebufferSize(program.window, &width, &height); width == 0 || height == 0; // minimised
             glfwGetFramebufferSize(program.window, &width, &height))
            glfwWaitEvents();
        images.reset(); // a surface has one swapchain
        images = std::make_unique<WindowImages>(program);
        renderer->resize(images->extent().width, images->extent().height);
    }
}

} // namespace

int main(int argc, char** argv) {
    try {
        run(argc > 1 ? std::atoi(argv[1]) : 0);
        return 0;
    } catch (const prelight::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
