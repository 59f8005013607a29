#include "device_type.hpp"

namespace prelight::app {

std::string type_of(const Device& device) {
    for (const DeviceInfo& info : Device::list())
        if (info.name == device.name() && info.driver == device.driver())
            return info.type;
    return "other";
}

} // namespace prelight::app
