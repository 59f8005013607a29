#include "device_box.hpp"
#include <pybind11/stl.h>

namespace prelight::python {
namespace {

std::shared_ptr<DeviceBox> make_device(const std::string& select, bool validate) {
    return without_gil([&] {
        auto box = std::make_shared<DeviceBox>();
        box->device = Device::create({.select = select, .validate = validate});
        return box;
    });
}

template <class Question>
auto asked(DeviceBox& box, Question question) {
    return without_gil([&] {
        const std::lock_guard lock(box.mutex);
        return question(*box.device);
    });
}

} // namespace

std::shared_ptr<DeviceBox> default_device() {
    static std::weak_ptr<DeviceBox> shared; // only with the GIL
    if (auto box = shared.lock())
        return box;
    auto box = make_device("auto", false);
    if (auto other = shared.lock()) // of another thread, meanwhile
        return other;
    shared = box;
    return box;
}

void bind_devices(py::module_& module) {
    py::class_<DeviceInfo>(module, "DeviceInfo", "A Vulkan device of this machine.")
        .def_readonly("index", &DeviceInfo::index, "For Device(select=...).")
        .def_readonly("name", &DeviceInfo::name, "As its driver says.")
        .def_readonly("driver", &DeviceInfo::driver, "Name and version.")
        .def_readonly("type", &DeviceInfo::type, "discrete, integrated, virtual, software or other.")
        .def_readonly("usable", &DeviceInfo::usable, "Whether Prelight runs on it.")
        .def_readonly("why_not", &DeviceInfo::why_not, "Empty where it does.")
        .def_readonly("features", &DeviceInfo::features, "Optional features that are there.")
        .def_readonly("missing", &DeviceInfo::missing, "Optional features that are not.")
        .def_readonly("chosen", &DeviceInfo::chosen, "Whether \"auto\" takes it.")
        .def("__repr__", [](const DeviceInfo& d) {
            return py::str("DeviceInfo({}, {!r}, type={!r}, usable={})").format(d.index, d.name, d.type, d.usable);
        });
    module.def(
        "devices", [] { return without_gil([] { return Device::list(); }); }, "The Vulkan devices of this machine.");
    py::class_<DeviceBox, std::shared_ptr<DeviceBox>>(module, "Device",
                                                      "A Vulkan 1.3 device. Renderers that are given none share one. "
                                                      "Threads may use it at the same time: they wait for "
                                                      "each other.")
        .def(py::init(&make_device), py::arg("select") = "auto", py::kw_only(), py::arg("validate") = false,
             "select: auto, cpu, a number of devices(), or a part of a name. validate: core and synchronization "
             "validation. "
             "Raises Error.")
        .def_property_readonly(
            "name", [](DeviceBox& box) { return box.device->name(); }, "As its driver says.")
        .def_property_readonly(
            "driver", [](DeviceBox& box) { return box.device->driver(); }, "Name and version.")
        .def(
            "has_samples", [](DeviceBox& box, uint32_t samples) { return box.device->has_samples(samples); },
            py::arg("samples"), "Whether renderers on it can draw so many samples a pixel (msaa).")
        .def_property_readonly(
            "validation_messages",
            [](DeviceBox& box) { return asked(box, [](Device& device) { return device.validation_messages(); }); },
            "What validation has said so far, one line each; empty is right.")
        .def("__repr__", [](DeviceBox& box) {
            return py::str("Device({!r}, driver={!r})").format(box.device->name(), box.device->driver());
        });
}

} // namespace prelight::python
