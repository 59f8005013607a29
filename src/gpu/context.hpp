#pragma once
#include "device_selection.hpp"
#include "handle.hpp"
#include <array>
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <prelight/vulkan.hpp>
#include <string_view>
#include <vector>

namespace prelight::gpu {

class PipelineLibrary;

/// The Vulkan side of prelight::Device: one device, one queue for everything.
class Context final : public Device {
public:
    explicit Context(const DeviceOptions& options);
    /// Device::adopt().
    explicit Context(const vulkan::ExistingDevice& existing);
    ~Context() override;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    std::string name() const override { return chosen_.info.name; }
    std::string driver() const override { return chosen_.info.driver; }
    bool has_samples(uint32_t samples) const override;
    std::vector<std::string> validation_messages() const override { return instance_.log().messages(); }

    VkInstance instance() const { return instance_.handle(); }
    VkDevice device() const { return device_; }
    VkPhysicalDevice physical() const { return chosen_.physical; }
    VkQueue queue() const { return queue_; }
    uint32_t queue_family() const { return chosen_.queue_family; }
    /// Swapchains can be made on it.
    bool presents() const { return presents_; }
    /// The device as others would adopt it.
    const vulkan::ExistingDevice& handles() const { return handles_; }
    /// Timestamps wrap around within this mask; 0: the queue has none.
    uint64_t timestamp_mask() const { return chosen_.timestamp_mask; }
    VkPipelineCache pipeline_cache() const { return cache_; }
    PipelineLibrary& pipelines() const { return *pipelines_; }
    /// The device is this machine's processor.
    bool is_software() const { return chosen_.info.type == "software"; }
    const OptionalFeatures& features() const { return chosen_.optional; }
    /// Takes the device for one that ends loops earlier (OptionalFeatures::loop_turns), for renderers that are made
    /// later: shows with few lights what others get with many.
    void end_loops_after(uint32_t turns) { chosen_.optional.loop_turns = turns; }
    const VkPhysicalDeviceLimits& limits() const { return properties_.limits; }

    /// Index of a memory type out of `type_bits` that has all of `flags`; falls back to any allowed
    /// type when `flags` is only a wish (device local). Throws Error.
    uint32_t memory_type(uint32_t type_bits, VkMemoryPropertyFlags flags) const;
    VkMemoryPropertyFlags memory_flags(uint32_t type) const;
    /// Takes the device for one whose own memory the host does not see, in what is made later.
    void hide_device_memory() { device_memory_hidden_ = true; }
    /// True when images of the format can be used so, with optimal tiling.
    bool supports(VkFormat format, VkFormatFeatureFlags features) const;

    /// Records and submits commands, and waits until they are done.
    void run(std::string_view label, const std::function<void(VkCommandBuffer)>& record) const;
    /// What a submission waits for and signals beside the timeline.
    struct Semaphores {
        std::vector<vulkan::SemaphoreUse> wait, signal;
    };
    /// Submits one command buffer and waits for its end with the timeline semaphore. Throws Error.
    void submit_and_wait(VkCommandBuffer commands) const { wait(submit(commands)); }
    /// Submits one command buffer, and gives the value that the timeline semaphore has at its end.
    uint64_t submit(VkCommandBuffer commands) const { return submit(commands, Semaphores{}); }
    uint64_t submit(VkCommandBuffer commands, const Semaphores& semaphores) const;
    /// vkQueuePresentKHR.
    VkResult present(const VkPresentInfoKHR& info) const;
    /// Until all that was submitted to the queue is done, by whomever.
    void wait_idle() const noexcept;
    /// A test's: waits for the device and takes it for lost from then on.
    void lose();
    /// Waits until the timeline has come to `value`. Throws Error.
    void wait(uint64_t value) const;
    bool is_done(uint64_t value) const;

    /// Debug names and labels: nothing without VK_EXT_debug_utils.
    void set_name(VkObjectType type, uint64_t handle, std::string_view name) const;
    void begin_label(VkCommandBuffer commands, std::string_view name) const;
    void end_label(VkCommandBuffer commands) const;

    /// Commands up to the end are left out where the 32-bit number in the buffer is 0. Only with
    /// OptionalFeatures::conditional_rendering.
    void begin_conditional(VkCommandBuffer commands, VkBuffer buffer, uint64_t offset) const;
    void end_conditional(VkCommandBuffer commands) const;

    /// Device memory held now, and the most that was held at once.
    uint64_t device_bytes() const { return device_bytes_; }
    uint64_t device_bytes_peak() const { return device_bytes_peak_; }
    /// Allocation counts itself here.
    void memory_taken(uint64_t bytes) const;
    void memory_freed(uint64_t bytes) const { device_bytes_ -= bytes; }
    /// What has been made on this device so far; each owner counts what it makes. A steady frame adds
    /// nothing.
    enum class Kind : size_t { allocation, pipeline, buffer, image, descriptor_pool, count };
    uint64_t created(Kind kind) const { return created_[static_cast<size_t>(kind)]; }
    void count_created(Kind kind) const { ++created_[static_cast<size_t>(kind)]; }

private:
    /// The queue, whoever else uses it in another thread.
    class QueueLock;
    void create_device();
    /// What both ways to a device have in common, once it is there.
    void set_up();
    void load_functions();

    Instance instance_;
    Candidate chosen_;
    std::vector<uint32_t> hidden_formats_;
    bool device_memory_hidden_ = false;
    VkPhysicalDeviceProperties properties_{};
    VkPhysicalDeviceMemoryProperties memory_{};
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    bool owned_ = true;              ///< the device is this object's to destroy
    vulkan::ExistingDevice handles_; ///< with the queue's locks, where they are the caller's
    mutable std::mutex queue_mutex_; ///< the timeline's values follow the order of submissions
    mutable std::mutex run_mutex_;   ///< of `pool_`
    UniquePipelineCache cache_;
    std::unique_ptr<PipelineLibrary> pipelines_;
    std::filesystem::path cache_file_;
    UniqueCommandPool pool_;
    UniqueSemaphore timeline_;
    mutable uint64_t timeline_value_ = 0;
    std::atomic<bool> lost_ = false; ///< lose()
    bool presents_ = false;
    mutable std::atomic<uint64_t> device_bytes_ = 0, device_bytes_peak_ = 0;
    mutable std::array<std::atomic<uint64_t>, static_cast<size_t>(Kind::count)> created_{};
    PFN_vkSetDebugUtilsObjectNameEXT set_object_name_ = nullptr;
    PFN_vkCmdBeginDebugUtilsLabelEXT begin_label_ = nullptr;
    PFN_vkCmdEndDebugUtilsLabelEXT end_label_ = nullptr;
    PFN_vkCmdBeginConditionalRenderingEXT begin_conditional_ = nullptr;
    PFN_vkCmdEndConditionalRenderingEXT end_conditional_ = nullptr;
};

} // namespace prelight::gpu
