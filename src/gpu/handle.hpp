#pragma once
#include <utility>
#include <vulkan/vulkan_core.h>

namespace prelight::gpu {

/// Owns one Vulkan object of a device; `Destroy` is its vkDestroy… or vkFree… function.
template <class T, auto Destroy>
class Unique {
public:
    Unique() = default;
    Unique(VkDevice device, T handle) : device_(device), handle_(handle) {}
    Unique(Unique&& other) noexcept { swap(other); }
    Unique& operator=(Unique&& other) noexcept {
        swap(other);
        return *this;
    }
    ~Unique() {
        if (handle_)
            Destroy(device_, handle_, nullptr);
    }
    operator T() const { return handle_; }
    const T* address() const { return &handle_; }

private:
    void swap(Unique& other) {
        std::swap(device_, other.device_);
        std::swap(handle_, other.handle_);
    }
    VkDevice device_ = VK_NULL_HANDLE;
    T handle_ = VK_NULL_HANDLE;
};

using UniqueBuffer = Unique<VkBuffer, vkDestroyBuffer>;
using UniqueBufferView = Unique<VkBufferView, vkDestroyBufferView>;
using UniqueImage = Unique<VkImage, vkDestroyImage>;
using UniqueImageView = Unique<VkImageView, vkDestroyImageView>;
using UniqueSampler = Unique<VkSampler, vkDestroySampler>;
using UniqueSemaphore = Unique<VkSemaphore, vkDestroySemaphore>;
using UniqueCommandPool = Unique<VkCommandPool, vkDestroyCommandPool>;
using UniqueQueryPool = Unique<VkQueryPool, vkDestroyQueryPool>;
using UniqueDescriptorPool = Unique<VkDescriptorPool, vkDestroyDescriptorPool>;
using UniqueSetLayout = Unique<VkDescriptorSetLayout, vkDestroyDescriptorSetLayout>;
using UniquePipelineLayout = Unique<VkPipelineLayout, vkDestroyPipelineLayout>;
using UniquePipeline = Unique<VkPipeline, vkDestroyPipeline>;
using UniquePipelineCache = Unique<VkPipelineCache, vkDestroyPipelineCache>;
using UniqueShaderModule = Unique<VkShaderModule, vkDestroyShaderModule>;

} // namespace prelight::gpu
