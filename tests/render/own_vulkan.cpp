#include "own_vulkan.hpp"
#include <cstdlib>
#include <filesystem>
#include <gpu/check.hpp>
#include <prelight/error.hpp>

namespace prelight {
namespace {

constexpr const char* swiftshader_file = "/usr/lib/chromium/vk_swiftshader_icd.json";

} // namespace

bool OwnVulkan::has_swiftshader() { return std::filesystem::exists(swiftshader_file); }

OwnVulkan::OwnVulkan(bool swiftshader, const std::function<void(vulkan::DeviceFeatures&)>& change) {
    if (swiftshader)
        setenv("VK_DRIVER_FILES", swiftshader_file, 1);
    instance_.emplace(true);
    handles_.instance = instance_->handle();
    for (VkPhysicalDevice physical : instance_->physical_devices()) {
        VkPhysicalDeviceProperties properties{};
        vkGetPhysicalDeviceProperties(physical, &properties);
        if (properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU)
            handles_.physical_device = physical;
    }
    unsetenv("VK_DRIVER_FILES");
    handles_.debug_utils = true;
    handles_.enabled = vulkan::wanted_features(handles_.physical_device);
    if (change)
        change(handles_.enabled);
    const float priority = 1;
    VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queue.queueCount = 1; // of family 0: software drivers have no other
    queue.pQueuePriorities = &priority;
    VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, handles_.enabled.chain()};
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = static_cast<uint32_t>(handles_.enabled.extensions.size());
    info.ppEnabledExtensionNames = handles_.enabled.extensions.data();
    gpu::check(vkCreateDevice(handles_.physical_device, &info, nullptr, &handles_.device), "device");
    vkGetDeviceQueue(handles_.device, 0, 0, &handles_.queue);
    VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    gpu::check(vkCreateCommandPool(handles_.device, &pool, nullptr, &pool_), "command pool");
}

std::vector<std::string> OwnVulkan::destroy() {
    if (handles_.device) {
        for (VkSemaphore semaphore : semaphores_)
            vkDestroySemaphore(handles_.device, semaphore, nullptr);
        vkDestroyCommandPool(handles_.device, pool_, nullptr);
        vkDestroyDevice(handles_.device, nullptr); // validation tells what is left on it
    }
    handles_.device = VK_NULL_HANDLE;
    return messages();
}

OwnVulkan::~OwnVulkan() { destroy(); }

void OwnVulkan::run(const std::function<void(VkCommandBuffer)>& record) const {
    VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocate.commandPool = pool_;
    allocate.commandBufferCount = 1;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    gpu::check(vkAllocateCommandBuffers(device(), &allocate, &commands), "command buffer");
    const VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    vkBeginCommandBuffer(commands, &begin);
    record(commands);
    vkEndCommandBuffer(commands);
    VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    gpu::check(vkQueueSubmit(handles_.queue, 1, &submit, VK_NULL_HANDLE), "submit");
    gpu::check(vkQueueWaitIdle(handles_.queue), "wait");
    vkFreeCommandBuffers(device(), pool_, 1, &commands);
}

VkSemaphore OwnVulkan::make_timeline() const {
    VkSemaphoreTypeCreateInfo type{VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO};
    type.semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE;
    const VkSemaphoreCreateInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO, &type, 0};
    gpu::check(vkCreateSemaphore(device(), &info, nullptr, &semaphores_.emplace_back()), "semaphore");
    return semaphores_.back();
}

uint64_t OwnVulkan::value_of(VkSemaphore timeline) const {
    uint64_t value = 0;
    gpu::check(vkGetSemaphoreCounterValue(device(), timeline, &value), "semaphore");
    return value;
}

void OwnVulkan::signal(VkSemaphore timeline, uint64_t value) const {
    VkSemaphoreSignalInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_SIGNAL_INFO};
    info.semaphore = timeline;
    info.value = value;
    gpu::check(vkSignalSemaphore(device(), &info), "semaphore");
}

OwnImage::OwnImage(const OwnVulkan& vulkan, VkFormat format, uint32_t width, uint32_t height)
    : vulkan_(vulkan), format_(format), extent_{width, height} {
    VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {width, height, 1};
    info.mipLevels = info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    gpu::check(vkCreateImage(vulkan.device(), &info, nullptr, &image_), "image");
    VkMemoryRequirements requirements{};
    vkGetImageMemoryRequirements(vulkan.device(), image_, &requirements);
    memory_ = allocate(requirements, 0);
    vkBindImageMemory(vulkan.device(), image_, memory_, 0);
    VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    view.image = image_;
    view.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view.format = format;
    view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    gpu::check(vkCreateImageView(vulkan.device(), &view, nullptr, &view_), "view");
}

OwnImage::~OwnImage() {
    vkDestroyImageView(vulkan_.device(), view_, nullptr);
    vkDestroyImage(vulkan_.device(), image_, nullptr);
    vkFreeMemory(vulkan_.device(), memory_, nullptr);
}

VkDeviceMemory OwnImage::allocate(const VkMemoryRequirements& requirements, VkMemoryPropertyFlags flags) const {
    VkPhysicalDeviceMemoryProperties all{};
    vkGetPhysicalDeviceMemoryProperties(vulkan_.handles().physical_device, &all);
    VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    info.allocationSize = requirements.size;
    while (!(requirements.memoryTypeBits & (1u << info.memoryTypeIndex)) ||
           (all.memoryTypes[info.memoryTypeIndex].propertyFlags & flags) != flags)
        ++info.memoryTypeIndex;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    gpu::check(vkAllocateMemory(vulkan_.device(), &info, nullptr, &memory), "memory");
    return memory;
}

vulkan::Target OwnImage::target() const {
    return {.image = image_, .view = view_, .format = format_, .extent = extent_};
}

std::vector<std::byte> OwnImage::read(VkImageLayout layout, uint32_t texel_bytes) const {
    VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    info.size = uint64_t(extent_.width) * extent_.height * texel_bytes;
    info.usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    VkBuffer buffer = VK_NULL_HANDLE;
    gpu::check(vkCreateBuffer(vulkan_.device(), &info, nullptr, &buffer), "buffer");
    VkMemoryRequirements requirements{};
    vkGetBufferMemoryRequirements(vulkan_.device(), buffer, &requirements);
    VkDeviceMemory memory =
        allocate(requirements, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    vkBindBufferMemory(vulkan_.device(), buffer, memory, 0);
    vulkan_.run([&](VkCommandBuffer commands) {
        VkBufferImageCopy region{};
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        region.imageExtent = {extent_.width, extent_.height, 1};
        vkCmdCopyImageToBuffer(commands, image_, layout, buffer, 1, &region);
    });
    void* mapped = nullptr;
    vkMapMemory(vulkan_.device(), memory, 0, VK_WHOLE_SIZE, 0, &mapped);
    const auto* bytes = static_cast<const std::byte*>(mapped);
    std::vector<std::byte> texels(bytes, bytes + info.size);
    vkDestroyBuffer(vulkan_.device(), buffer, nullptr);
    vkFreeMemory(vulkan_.device(), memory, nullptr);
    return texels;
}

} // namespace prelight
