#pragma once
#include "context.hpp"
#include <optional>
#include <prelight/error.hpp>
#include <vector>

namespace prelight::gpu {

/// VK_ERROR_SURFACE_LOST_KHR: the window needs another surface.
class SurfaceLost : public Error {
public:
    using Error::Error;
};

/// The images of a window. They hold display-encoded bytes as they are (a UNORM format).
class Swapchain {
public:
    /// Takes the surface over. Throws Error when the device cannot show pictures there.
    Swapchain(const Context& context, VkSurfaceKHR surface);
    ~Swapchain();
    Swapchain(const Swapchain&) = delete;
    Swapchain& operator=(const Swapchain&) = delete;

    /// Makes the images anew for a window of this size, pixels; all work on them has to be done. Without any where the
    /// window has none (minimised): extent() is 0 × 0 then. Throws SurfaceLost, Error.
    void make(VkExtent2D window);
    /// Index of the next image, which may be used after `ready`; absent: they have to be made anew first.
    /// Throws SurfaceLost, Error.
    std::optional<uint32_t> acquire(VkSemaphore ready);
    /// Shows the image after done(index). Throws SurfaceLost, Error.
    void present(uint32_t index);

    VkExtent2D extent() const { return extent_; }
    VkFormat format() const { return format_.format; }
    VkImage image(uint32_t index) const { return images_[index].image; }
    VkImageView view(uint32_t index) const { return images_[index].view; }
    VkSemaphore done(uint32_t index) const { return images_[index].done; }
    /// The window is not what the images were made for.
    bool stale() const { return stale_; }
    /// A test's: the surface is lost now.
    void lose() { lost_ = true; }

private:
    struct WindowImage {
        VkImage image = VK_NULL_HANDLE;
        UniqueImageView view;
        UniqueSemaphore done;
    };
    void choose_format();
    void check_surface(VkResult result, const char* what) const;

    const Context& context_;
    VkSurfaceKHR surface_ = VK_NULL_HANDLE;
    VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
    VkSurfaceFormatKHR format_{};
    VkExtent2D extent_{};
    std::vector<WindowImage> images_;
    bool stale_ = true, lost_ = false;
};

UniqueSemaphore make_semaphore(const Context& context, std::string_view name);

} // namespace prelight::gpu
