#include "context.hpp"
#include "check.hpp"
#include "device_features.hpp"
#include "pipeline_cache.hpp"
#include "pipeline_library.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <prelight/renderer.hpp>

namespace prelight {

std::vector<DeviceInfo> Device::list() {
    const gpu::Instance instance(false);
    std::vector<DeviceInfo> infos;
    std::vector<gpu::Candidate> all = gpu::candidates(instance);
    const bool any = std::any_of(all.begin(), all.end(), [](const auto& c) { return c.info.usable; });
    if (any)
        all = gpu::select_device(instance, "auto");
    for (const gpu::Candidate& candidate : all)
        infos.push_back(candidate.info);
    return infos;
}

std::unique_ptr<Device> Device::create(const DeviceOptions& options) { return std::make_unique<gpu::Context>(options); }

std::unique_ptr<Device> Device::adopt(const vulkan::ExistingDevice& device) {
    return std::make_unique<gpu::Context>(device);
}

vulkan::ExistingDevice vulkan::handles(const Device& device) {
    return dynamic_cast<const gpu::Context&>(device).handles();
}

namespace gpu {
namespace {

/// Throws Error where a handle is missing or does not belong to the others.
const vulkan::ExistingDevice& checked(const vulkan::ExistingDevice& given) {
    if (!given.instance || !given.physical_device || !given.device || !given.queue)
        throw UsageError("Device::adopt(): instance, physical device, device and queue are all needed");
    if (!given.lock_queue != !given.unlock_queue)
        throw UsageError("Device::adopt(): lock_queue and unlock_queue come together");
    const std::vector<VkPhysicalDevice> all = Instance(given.instance, false).physical_devices();
    if (std::find(all.begin(), all.end(), given.physical_device) == all.end())
        throw UsageError("Device::adopt(): the physical device is not one of the instance's");
    return given;
}

Candidate take_adopted(const vulkan::ExistingDevice& given) {
    Candidate candidate = examine(given.physical_device, 0, given.queue_family);
    if (!candidate.info.usable)
        throw Error(fmt::format("{}: {}", candidate.info.name, candidate.info.why_not));
    if (const std::string lacks = keep_enabled(candidate.optional, given.enabled); !lacks.empty())
        throw Error(fmt::format("{}: the device was made without {} (vulkan::wanted_features() has all that is needed)",
                                candidate.info.name, lacks));
    candidate.info.chosen = true;
    return candidate;
}

Candidate take_chosen(const std::vector<Candidate>& all) {
    return *std::find_if(all.begin(), all.end(), [](const Candidate& c) { return c.info.chosen; });
}

} // namespace

Context::Context(const DeviceOptions& options)
    : instance_(options.validate, options.window_extensions),
      chosen_(take_chosen(select_device(instance_, options.select))), hidden_formats_(options.hidden_formats) {
    const auto hides = [&](const char* extension) {
        const auto& hidden = options.hidden_extensions;
        return std::find(hidden.begin(), hidden.end(), extension) != hidden.end();
    };
    chosen_.optional.conditional_rendering &= !hides(VK_EXT_CONDITIONAL_RENDERING_EXTENSION_NAME);
    chosen_.optional.stencil_export &= !hides(VK_EXT_SHADER_STENCIL_EXPORT_EXTENSION_NAME);
    chosen_.optional.post_depth_coverage &= !hides(VK_EXT_POST_DEPTH_COVERAGE_EXTENSION_NAME);
    presents_ = !options.window_extensions.empty();
    create_device();
    vkGetDeviceQueue(device_, queue_family(), 0, &queue_);
    set_up();
    set_name(VK_OBJECT_TYPE_QUEUE, reinterpret_cast<uint64_t>(queue_), "graphics queue");
    handles_.instance = instance();
    handles_.physical_device = physical();
    handles_.device = device_;
    handles_.queue = queue_;
    handles_.queue_family = queue_family();
    handles_.debug_utils = instance_.debug_utils();
    handles_.lock_queue = [this] { queue_mutex_.lock(); };
    handles_.unlock_queue = [this] { queue_mutex_.unlock(); };
}

Context::Context(const vulkan::ExistingDevice& existing)
    : instance_(checked(existing).instance, existing.debug_utils), chosen_(take_adopted(existing)),
      device_(existing.device), queue_(existing.queue), owned_(false), handles_(existing) {
    const auto& extensions = existing.enabled.extensions;
    presents_ =
        std::ranges::any_of(extensions, [](std::string_view one) { return one == VK_KHR_SWAPCHAIN_EXTENSION_NAME; });
    set_up();
}

void Context::set_up() {
    vkGetPhysicalDeviceProperties(physical(), &properties_);
    vkGetPhysicalDeviceMemoryProperties(physical(), &memory_);
    load_functions();
    cache_file_ = pipeline_cache_file(properties_);
    cache_ = load_pipeline_cache(device_, cache_file_);
    pipelines_ = std::make_unique<PipelineLibrary>();

    VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    pool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
    pool.queueFamilyIndex = queue_family();
    VkCommandPool pool_handle = VK_NULL_HANDLE;
    check(vkCreateCommandPool(device_, &pool, nullptr, &pool_handle), "command pool");
    pool_ = {device_, pool_handle};

    VkSemaphoreTypeCreateInfo type{VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO};
    type.semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE;
    const VkSemaphoreCreateInfo semaphore{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO, &type, 0};
    VkSemaphore semaphore_handle = VK_NULL_HANDLE;
    check(vkCreateSemaphore(device_, &semaphore, nullptr, &semaphore_handle), "timeline semaphore");
    timeline_ = {device_, semaphore_handle};
}

/// The caller's own lock comes second, so that no two threads of Prelight's wait in it.
class Context::QueueLock {
public:
    explicit QueueLock(const Context& context) : context_(context), lock_(context.queue_mutex_) {
        if (!context_.owned_ && context_.handles_.lock_queue)
            context_.handles_.lock_queue();
    }
    ~QueueLock() {
        if (!context_.owned_ && context_.handles_.unlock_queue)
            context_.handles_.unlock_queue();
    }
    QueueLock(const QueueLock&) = delete;
    QueueLock& operator=(const QueueLock&) = delete;

private:
    const Context& context_;
    std::scoped_lock<std::mutex> lock_;
};

Context::~Context() {
    wait_idle();
    save_pipeline_cache(device_, cache_, cache_file_);
    pipelines_.reset();
    cache_ = {};
    pool_ = {};
    timeline_ = {};
    if (owned_)
        vkDestroyDevice(device_, nullptr);
}

void Context::create_device() {
    handles_.enabled = features_to_enable(features());
    if (presents_)
        handles_.enabled.extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    const float priority = 1;
    VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queue.queueFamilyIndex = queue_family();
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, handles_.enabled.chain()};
    info.enabledExtensionCount = static_cast<uint32_t>(handles_.enabled.extensions.size());
    info.ppEnabledExtensionNames = handles_.enabled.extensions.data();
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    check(vkCreateDevice(physical(), &info, nullptr, &device_), name());
}

void Context::load_functions() {
    if (features().conditional_rendering) {
        begin_conditional_ = reinterpret_cast<PFN_vkCmdBeginConditionalRenderingEXT>(
            vkGetDeviceProcAddr(device_, "vkCmdBeginConditionalRenderingEXT"));
        end_conditional_ = reinterpret_cast<PFN_vkCmdEndConditionalRenderingEXT>(
            vkGetDeviceProcAddr(device_, "vkCmdEndConditionalRenderingEXT"));
    }
    if (!instance_.debug_utils())
        return;
    const auto load = [&](const char* function) { return vkGetInstanceProcAddr(instance_.handle(), function); };
    set_object_name_ = reinterpret_cast<PFN_vkSetDebugUtilsObjectNameEXT>(load("vkSetDebugUtilsObjectNameEXT"));
    begin_label_ = reinterpret_cast<PFN_vkCmdBeginDebugUtilsLabelEXT>(load("vkCmdBeginDebugUtilsLabelEXT"));
    end_label_ = reinterpret_cast<PFN_vkCmdEndDebugUtilsLabelEXT>(load("vkCmdEndDebugUtilsLabelEXT"));
}

bool Context::has_samples(uint32_t samples) const {
    const VkSampleCountFlags known = limits().framebufferColorSampleCounts & limits().framebufferDepthSampleCounts &
                                     limits().sampledImageColorSampleCounts & limits().sampledImageDepthSampleCounts;
    return samples == 1 || (std::find(sample_counts.begin(), sample_counts.end(), samples) != sample_counts.end() &&
                            (known & samples) && features().sample_rate_shading);
}

uint32_t Context::memory_type(uint32_t type_bits, VkMemoryPropertyFlags flags) const {
    for (const VkMemoryPropertyFlags wanted :
         {flags, flags & ~VkMemoryPropertyFlags(VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT)})
        for (uint32_t i = 0; i < memory_.memoryTypeCount; ++i)
            if ((type_bits & (1u << i)) && (memory_.memoryTypes[i].propertyFlags & wanted) == wanted)
                return i;
    throw Error(name() + ": no memory type fits");
}

VkMemoryPropertyFlags Context::memory_flags(uint32_t type) const {
    const VkMemoryPropertyFlags flags = memory_.memoryTypes[type].propertyFlags;
    const bool hidden = device_memory_hidden_ && (flags & VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    return hidden ? flags & ~VkMemoryPropertyFlags(VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT) : flags;
}

bool Context::supports(VkFormat format, VkFormatFeatureFlags wanted) const {
    if (std::find(hidden_formats_.begin(), hidden_formats_.end(), static_cast<uint32_t>(format)) !=
        hidden_formats_.end())
        return false;
    VkFormatProperties properties{};
    vkGetPhysicalDeviceFormatProperties(physical(), format, &properties);
    return (properties.optimalTilingFeatures & wanted) == wanted;
}

void Context::run(std::string_view label, const std::function<void(VkCommandBuffer)>& record) const {
    const std::scoped_lock lock(run_mutex_);
    VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocate.commandPool = pool_;
    allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocate.commandBufferCount = 1;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    check(vkAllocateCommandBuffers(device_, &allocate, &commands), "command buffer");
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(commands, &begin), label);
    begin_label(commands, label);
    record(commands);
    end_label(commands);
    check(vkEndCommandBuffer(commands), label);
    submit_and_wait(commands);
    vkFreeCommandBuffers(device_, pool_, 1, &commands);
}

uint64_t Context::submit(VkCommandBuffer commands, const Semaphores& semaphores) const {
    VkCommandBufferSubmitInfo buffer{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
    buffer.commandBuffer = commands;
    std::vector<VkSemaphoreSubmitInfo> waits, signals;
    const auto add = [](std::vector<VkSemaphoreSubmitInfo>& infos, const vulkan::SemaphoreUse& use) {
        VkSemaphoreSubmitInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO};
        info.semaphore = use.semaphore;
        info.value = use.value;
        info.stageMask = use.stages;
        infos.push_back(info);
    };
    add(signals, {.semaphore = timeline_});
    for (const vulkan::SemaphoreUse& use : semaphores.signal)
        add(signals, use);
    for (const vulkan::SemaphoreUse& use : semaphores.wait)
        add(waits, use);
    VkSubmitInfo2 submit{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
    submit.waitSemaphoreInfoCount = static_cast<uint32_t>(waits.size());
    submit.pWaitSemaphoreInfos = waits.data();
    submit.commandBufferInfoCount = 1;
    submit.pCommandBufferInfos = &buffer;
    submit.signalSemaphoreInfoCount = static_cast<uint32_t>(signals.size());
    submit.pSignalSemaphoreInfos = signals.data();
    const QueueLock lock(*this);
    signals[0].value = timeline_value_ + 1;
    check(lost_ ? VK_ERROR_DEVICE_LOST : vkQueueSubmit2(queue_, 1, &submit, VK_NULL_HANDLE), name());
    return ++timeline_value_;
}

VkResult Context::present(const VkPresentInfoKHR& info) const {
    const QueueLock lock(*this);
    return vkQueuePresentKHR(queue_, &info);
}

void Context::wait_idle() const noexcept {
    const QueueLock lock(*this);
    vkQueueWaitIdle(queue_);
}

void Context::lose() {
    wait_idle();
    lost_ = true;
}

void Context::wait(uint64_t value) const {
    VkSemaphoreWaitInfo wait{VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO};
    wait.semaphoreCount = 1;
    wait.pSemaphores = timeline_.address();
    wait.pValues = &value;
    check(lost_ ? VK_ERROR_DEVICE_LOST : vkWaitSemaphores(device_, &wait, UINT64_MAX), name());
}

bool Context::is_done(uint64_t value) const {
    uint64_t now = 0;
    check(vkGetSemaphoreCounterValue(device_, timeline_, &now), name());
    return now >= value;
}

void Context::memory_taken(uint64_t bytes) const {
    const uint64_t held = device_bytes_ += bytes;
    uint64_t peak = device_bytes_peak_;
    while (held > peak && !device_bytes_peak_.compare_exchange_weak(peak, held)) {
    }
    count_created(Kind::allocation);
}

void Context::set_name(VkObjectType type, uint64_t handle, std::string_view text) const {
    if (!set_object_name_)
        return;
    const std::string terminated(text);
    VkDebugUtilsObjectNameInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT};
    info.objectType = type;
    info.objectHandle = handle;
    info.pObjectName = terminated.c_str();
    set_object_name_(device_, &info);
}

void Context::begin_conditional(VkCommandBuffer commands, VkBuffer buffer, uint64_t offset) const {
    VkConditionalRenderingBeginInfoEXT info{VK_STRUCTURE_TYPE_CONDITIONAL_RENDERING_BEGIN_INFO_EXT};
    info.buffer = buffer;
    info.offset = offset;
    begin_conditional_(commands, &info);
}

void Context::end_conditional(VkCommandBuffer commands) const { end_conditional_(commands); }

void Context::begin_label(VkCommandBuffer commands, std::string_view text) const {
    if (!begin_label_)
        return;
    const std::string terminated(text);
    VkDebugUtilsLabelEXT label{VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT};
    label.pLabelName = terminated.c_str();
    begin_label_(commands, &label);
}

void Context::end_label(VkCommandBuffer commands) const {
    if (end_label_)
        end_label_(commands);
}

} // namespace gpu
} // namespace prelight
