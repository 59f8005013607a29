#pragma once
#include <gpu/instance.hpp>
#include <prelight/vulkan.hpp>
#include <string>
#include <vector>

namespace prelight {

/// Another program's Vulkan: instance (under core and synchronization validation), device and queue, made without any
/// help of Prelight's but wanted_features().
class OwnVulkan {
public:
    /// `swiftshader`: on that driver instead of lavapipe. `change`: what the device is made without, or with.
    explicit OwnVulkan(bool swiftshader = false, const std::function<void(vulkan::DeviceFeatures&)>& change = {});
    ~OwnVulkan();
    OwnVulkan(const OwnVulkan&) = delete;
    OwnVulkan& operator=(const OwnVulkan&) = delete;
    static bool has_swiftshader();

    const vulkan::ExistingDevice& handles() const { return handles_; }
    VkDevice device() const { return handles_.device; }
    /// Of validation, once more with those that come when all is destroyed.
    std::vector<std::string> messages() const { return instance_->log().messages(); }
    std::vector<std::string> destroy();
    /// Records, submits and waits, with nothing but the order of the queue between this and what was submitted before.
    void run(const std::function<void(VkCommandBuffer)>& record) const;
    VkSemaphore make_timeline() const;
    uint64_t value_of(VkSemaphore timeline) const;
    void signal(VkSemaphore timeline, uint64_t value) const;

private:
    std::optional<gpu::Instance> instance_;
    vulkan::ExistingDevice handles_;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    mutable std::vector<VkSemaphore> semaphores_;
};

/// An image of that program's, to draw into.
class OwnImage {
public:
    OwnImage(const OwnVulkan& vulkan, VkFormat format, uint32_t width, uint32_t height);
    ~OwnImage();
    OwnImage(const OwnImage&) = delete;
    OwnImage& operator=(const OwnImage&) = delete;
    vulkan::Target target() const;
    /// Its texels, which lie in this layout and are left in it.
    std::vector<std::byte> read(VkImageLayout layout, uint32_t texel_bytes) const;

private:
    VkDeviceMemory allocate(const VkMemoryRequirements& requirements, VkMemoryPropertyFlags flags) const;
    const OwnVulkan& vulkan_;
    VkFormat format_;
    VkExtent2D extent_;
    VkImage image_ = VK_NULL_HANDLE;
    VkImageView view_ = VK_NULL_HANDLE;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
};

} // namespace prelight
