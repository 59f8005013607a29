#include "words.hpp"
#include <pybind11/stl.h>

namespace prelight::python {

void bind_settings(py::module_& module) {
    py::class_<SettingNeed>(module, "SettingNeed", "What a setting needs to have an effect.")
        .def_readonly("key", &SettingNeed::key, "Another setting, or \"shading\" or \"msaa\".")
        .def_readonly("values", &SettingNeed::values, "That it may have.")
        .def_readonly("or_view", &SettingNeed::or_view, "Or this view is asked for; may be empty.")
        .def("__repr__",
             [](const SettingNeed& n) { return py::str("SettingNeed({!r}, values={})").format(n.key, n.values); });
    py::class_<SettingInfo>(module, "SettingInfo", "One setting of a renderer.")
        .def_readonly("key", &SettingInfo::key, "For Renderer(settings={key: value}).")
        .def_readonly("values", &SettingInfo::values, "Allowed words; one like \"0.1 … 64\" stands for a number.")
        .def_readonly("default_value", &SettingInfo::default_value, "A word.")
        .def_readonly("description", &SettingInfo::description, "One line.")
        .def_readonly("needs", &SettingInfo::needs, "A setting that is changed without all of them is refused.")
        .def("__repr__", [](const SettingInfo& s) {
            return py::str("SettingInfo({!r}, values={}, default_value={!r})").format(s.key, s.values, s.default_value);
        });
    py::class_<RendererInfo>(module, "RendererInfo", "An architecture that Renderer() can make.")
        .def_readonly("name", &RendererInfo::name, "For Renderer(name).")
        .def_readonly("description", &RendererInfo::description, "One line.")
        .def_readonly("settings", &RendererInfo::settings, "In the order in which they are listed elsewhere.")
        .def_readonly("views", &RendererInfo::views, "Buffers that Renderer(views=...) may ask for.")
        .def_readonly("presets", &RendererInfo::presets, "For Renderer(preset=...).")
        .def_readonly("preset_settings", &RendererInfo::preset_settings, "What each preset sets.")
        .def_readonly("needs_device", &RendererInfo::needs_device, "False: it runs on the CPU alone.")
        .def("__repr__",
             [](const RendererInfo& r) { return py::str("RendererInfo({!r}, {!r})").format(r.name, r.description); });
    module.def("renderers", &renderer_infos, "The architectures, with their settings, views and presets.");
}

} // namespace prelight::python
