#pragma once
#include <memory>
#include <mutex>
#include <string>
#include <vector>
#include <vulkan/vulkan_core.h>

namespace prelight::gpu {

/// Messages of the validation layers, kept in the order they came.
class MessageLog {
public:
    void add(std::string message);
    std::vector<std::string> messages() const;

private:
    mutable std::mutex mutex_;
    std::vector<std::string> messages_;
};

/// The Vulkan instance, with core and synchronization validation when asked for. The layer is taken
/// from VK_LAYER_PATH when the user has set it, else from the manifest that the build wrote for the
/// newer layer in Debian's chromium-common, else from the system.
class Instance {
public:
    /// Throws Error when there is no loader or driver, when validation is asked for and no
    /// validation layer is installed, or when one of `extensions` is missing.
    explicit Instance(bool validate, const std::vector<std::string>& extensions = {});
    /// One that somebody else has made and will destroy. `debug_utils`: it has VK_EXT_debug_utils.
    Instance(VkInstance existing, bool debug_utils) : instance_(existing), owned_(false), debug_utils_(debug_utils) {}
    ~Instance();
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;

    VkInstance handle() const { return instance_; }
    bool debug_utils() const { return debug_utils_; }
    const MessageLog& log() const { return *log_; }
    std::vector<VkPhysicalDevice> physical_devices() const;

private:
    void create_messenger();
    std::unique_ptr<MessageLog> log_ = std::make_unique<MessageLog>();
    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    bool owned_ = true;
    bool debug_utils_ = false;
};

} // namespace prelight::gpu
