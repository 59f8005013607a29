#pragma once
#include "module.hpp"
#include <memory>
#include <mutex>
#include <prelight/device.hpp>

namespace prelight::python {

/// A device, and with it all its renderers, belong to one thread at a time. Who locks it has released the GIL, and
/// releases it before he takes the GIL again.
struct DeviceBox {
    std::unique_ptr<Device> device;
    std::mutex mutex;
};

/// The device that renderers share who are not told one; made when the first of them is, gone with the last.
std::shared_ptr<DeviceBox> default_device();

} // namespace prelight::python
