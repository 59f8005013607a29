#include "swapchain.hpp"
#include "check.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace prelight::gpu {

UniqueSemaphore make_semaphore(const Context& context, std::string_view name) {
    const VkSemaphoreCreateInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
    VkSemaphore handle = VK_NULL_HANDLE;
    check(vkCreateSemaphore(context.device(), &info, nullptr, &handle), name);
    context.set_name(VK_OBJECT_TYPE_SEMAPHORE, reinterpret_cast<uint64_t>(handle), name);
    return {context.device(), handle};
}

Swapchain::Swapchain(const Context& context, VkSurfaceKHR surface) : context_(context), surface_(surface) {
    try {
        VkBool32 shows = VK_FALSE;
        check_surface(vkGetPhysicalDeviceSurfaceSupportKHR(context.physical(), context.queue_family(), surface, &shows),
                      "window");
        if (!shows)
            throw Error(context.name() + ": cannot show pictures in this window");
        choose_format();
    } catch (...) {
        vkDestroySurfaceKHR(context.instance(), surface, nullptr);
        throw;
    }
}

Swapchain::~Swapchain() {
    context_.wait_idle(); // presentation has no other end to wait for
    images_.clear();
    vkDestroySwapchainKHR(context_.device(), swapchain_, nullptr);
    vkDestroySurfaceKHR(context_.instance(), surface_, nullptr);
}

void Swapchain::check_surface(VkResult result, const char* what) const {
    if (lost_ || result == VK_ERROR_SURFACE_LOST_KHR)
        throw SurfaceLost(fmt::format("{}: {}", what, result_name(VK_ERROR_SURFACE_LOST_KHR)));
    check(result, what);
}

void Swapchain::choose_format() {
    uint32_t count = 0;
    check_surface(vkGetPhysicalDeviceSurfaceFormatsKHR(context_.physical(), surface_, &count, nullptr), "window");
    std::vector<VkSurfaceFormatKHR> formats(count);
    check_surface(vkGetPhysicalDeviceSurfaceFormatsKHR(context_.physical(), surface_, &count, formats.data()),
                  "window");
    for (const VkFormat wanted : {VK_FORMAT_B8G8R8A8_UNORM, VK_FORMAT_R8G8B8A8_UNORM}) {
        const auto found = std::ranges::find(formats, wanted, &VkSurfaceFormatKHR::format);
        if (found == formats.end() || !context_.supports(wanted, VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT))
            continue;
        format_ = *found;
        return;
    }
    throw Error(context_.name() + ": the window has no images of 8 bits a channel that take plain bytes");
}

void Swapchain::make(VkExtent2D window) {
    VkSurfaceCapabilitiesKHR can{};
    check_surface(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(context_.physical(), surface_, &can), "window");
    VkExtent2D extent = can.currentExtent;
    if (extent.width == 0xffffffffu) // the window takes the images' size
        extent = {std::clamp(window.width, can.minImageExtent.width, can.maxImageExtent.width),
                  std::clamp(window.height, can.minImageExtent.height, can.maxImageExtent.height)};
    images_.clear();
    stale_ = false;
    extent_ = extent;
    if (extent.width == 0 || extent.height == 0) {
        extent_ = {};
        stale_ = true;
        return;
    }
    VkSwapchainCreateInfoKHR info{VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
    info.surface = surface_;
    info.minImageCount = can.minImageCount; // more would only be more frames between input and picture
    info.imageFormat = format_.format;
    info.imageColorSpace = format_.colorSpace;
    info.imageExtent = extent;
    info.imageArrayLayers = 1;
    info.imageUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT; // which every surface has
    info.preTransform = can.currentTransform;
    info.compositeAlpha = can.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                              ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                              : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
    info.presentMode = VK_PRESENT_MODE_FIFO_KHR;
    info.clipped = VK_TRUE;
    info.oldSwapchain = swapchain_;
    VkSwapchainKHR next = VK_NULL_HANDLE;
    const VkResult result = vkCreateSwapchainKHR(context_.device(), &info, nullptr, &next);
    vkDestroySwapchainKHR(context_.device(), swapchain_, nullptr);
    swapchain_ = next;
    check_surface(result, "window images");

    uint32_t count = 0;
    check(vkGetSwapchainImagesKHR(context_.device(), swapchain_, &count, nullptr), "window images");
    std::vector<VkImage> images(count);
    check(vkGetSwapchainImagesKHR(context_.device(), swapchain_, &count, images.data()), "window images");
    for (VkImage image : images) {
        VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
        view.image = image;
        view.viewType = VK_IMAGE_VIEW_TYPE_2D;
        view.format = format_.format;
        view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        VkImageView handle = VK_NULL_HANDLE;
        check(vkCreateImageView(context_.device(), &view, nullptr, &handle), "window image");
        images_.push_back({image, {context_.device(), handle}, make_semaphore(context_, "window image done")});
    }
}

std::optional<uint32_t> Swapchain::acquire(VkSemaphore ready) {
    if (images_.empty())
        return {};
    uint32_t index = 0;
    const VkResult result =
        lost_ ? VK_ERROR_SURFACE_LOST_KHR
              : vkAcquireNextImageKHR(context_.device(), swapchain_, UINT64_MAX, ready, VK_NULL_HANDLE, &index);
    if (result == VK_ERROR_OUT_OF_DATE_KHR) {
        stale_ = true;
        return {};
    }
    if (result == VK_SUBOPTIMAL_KHR) // this one can still be shown
        stale_ = true;
    else
        check_surface(result, "window");
    return index;
}

void Swapchain::present(uint32_t index) {
    VkPresentInfoKHR info{VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
    info.waitSemaphoreCount = 1;
    info.pWaitSemaphores = images_[index].done.address();
    info.swapchainCount = 1;
    info.pSwapchains = &swapchain_;
    info.pImageIndices = &index;
    const VkResult result = context_.present(info);
    if (result == VK_SUBOPTIMAL_KHR || result == VK_ERROR_OUT_OF_DATE_KHR)
        stale_ = true;
    else
        check_surface(result, "window");
}

} // namespace prelight::gpu
