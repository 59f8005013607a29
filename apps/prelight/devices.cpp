#include "commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <prelight/device.hpp>
#include <prelight/error.hpp>

namespace prelight::app {

void run(const DevicesCommand&) {
    const std::vector<DeviceInfo> devices = Device::list();
    bool any = false;
    for (const DeviceInfo& device : devices) {
        fmt::print("{} {}: {} ({})\n", device.chosen ? "*" : " ", device.index, device.name, device.type);
        fmt::print("     driver:   {}\n", device.driver);
        if (!device.usable)
            fmt::print("     unusable: {}\n", device.why_not);
        if (device.chosen)
            fmt::print("     taken:    {}\n", device.why_chosen);
        if (!device.features.empty())
            fmt::print("     has:      {}\n", fmt::join(device.features, ", "));
        if (!device.missing.empty())
            fmt::print("     lacks:    {}\n", fmt::join(device.missing, ", "));
        any = any || device.chosen;
    }
    if (!any)
        throw Error("devices: none of the Vulkan devices can be used (Debian's software driver is in "
                    "the package mesa-vulkan-drivers)");
    fmt::print("* is what --device auto takes.\n");
}

} // namespace prelight::app
