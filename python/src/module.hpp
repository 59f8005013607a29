#pragma once
#include "gil.hpp"

namespace prelight::python {

namespace py = pybind11;

// Each defines what its file is about. Types come before the functions that name them, so that signatures in
// docstrings read as Python.
void bind_errors(py::module_& module);
void bind_images(py::module_& module);
void bind_cameras(py::module_& module);
void bind_lights(py::module_& module);
void bind_materials(py::module_& module);
void bind_meshes(py::module_& module);
void bind_worlds(py::module_& module);
void bind_scenes(py::module_& module);
void bind_devices(py::module_& module);
void bind_settings(py::module_& module);
void bind_stats(py::module_& module);
void bind_reference(py::module_& module);
void bind_renderers(py::module_& module);

} // namespace prelight::python
