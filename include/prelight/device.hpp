#pragma once
#include <cstdint>
#include <memory>
#include <prelight/export.hpp>
#include <string>
#include <vector>

namespace prelight {

namespace vulkan {
struct ExistingDevice;
}

/// What `prelight devices` prints of one Vulkan device.
struct DeviceInfo {
    uint32_t index = 0;                ///< in Device::list(), as DeviceOptions::select takes it
    std::string name;                  ///< as the driver gives it
    std::string driver;                ///< its name and version
    std::string type;                  ///< discrete, integrated, virtual, software, other
    bool usable = false;               ///< it has all that renderers need
    std::string why_not;               ///< empty when usable
    std::vector<std::string> features; ///< optional features that are there
    std::vector<std::string> missing;  ///< optional features that are not
    bool chosen = false;               ///< `auto` takes this one
    std::string why_chosen;            ///< a phrase; empty for the others
};

/// Which device is opened, and how.
struct DeviceOptions {
    std::string select = "auto"; ///< auto, cpu, an index, or a part of a name
    bool validate = false;       ///< core and synchronization validation; see validation_messages
    /// VkFormat values to treat as missing: shows what a device without them gets.
    std::vector<uint32_t> hidden_formats = {};
    /// The same of optional extensions, by name.
    std::vector<std::string> hidden_extensions = {};
    /// Instance extensions that a window system asks for: with any, the device can also present to a window.
    std::vector<std::string> window_extensions = {};
};

/// A Vulkan 1.3 device with its queue, allocator and caches. The Vulkan side is in src/gpu. Renderers on one device may
/// each be used in a thread of their own.
class PRELIGHT_API Device {
public:
    /// All Vulkan devices of this machine, usable or not. Throws Error when no instance can be made.
    static std::vector<DeviceInfo> list();
    /// Opens one. Throws UsageError when none is called so, Error when it cannot be used.
    static std::unique_ptr<Device> create(const DeviceOptions& options);
    /// Works on a device and a queue of the program's own (prelight/vulkan.hpp), and destroys nothing that it has not
    /// made. All of it lives longer than this. Throws Error: a handle that is missing, a queue or a feature that will
    /// not do. validation_messages() stays empty: messages are the program's.
    static std::unique_ptr<Device> adopt(const vulkan::ExistingDevice& device);
    virtual ~Device() = default;
    /// As DeviceInfo::name.
    virtual std::string name() const = 0;
    /// As DeviceInfo::driver.
    virtual std::string driver() const = 0;
    /// Whether renderers on it can draw this many samples a pixel: RenderOptions::msaa.
    virtual bool has_samples(uint32_t samples) const = 0;
    /// Messages that validation has given so far, one line each; empty is right.
    virtual std::vector<std::string> validation_messages() const = 0;
};

} // namespace prelight
