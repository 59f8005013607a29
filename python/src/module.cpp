#include "module.hpp"
#include "words.hpp"
#include <prelight/version.hpp>

namespace prelight::python {
namespace {

void bind_all(py::module_& module) {
    module.doc() = "The compiled part of prelight; import prelight instead.";
    const py::object name = module.attr("__name__");
    module.attr("__name__") = "prelight"; // where users find the classes
    bind_errors(module);
    bind_words<LightKind>(module);
    bind_words<Falloff>(module);
    bind_words<ProjectionKind>(module);
    bind_words<AlphaMode>(module);
    bind_words<Shading>(module);
    bind_words<Tonemap>(module);
    bind_images(module);
    bind_cameras(module);
    bind_lights(module);
    bind_materials(module);
    bind_meshes(module);
    bind_worlds(module);
    bind_scenes(module);
    bind_devices(module);
    bind_settings(module);
    bind_stats(module);
    bind_reference(module);
    bind_renderers(module);
    module.def(
        "version", [] { return std::string(version()); },
        "The version of the library that runs, \"MAJOR.MINOR.PATCH\".");
    module.attr("__name__") = name;
    py::module_::import("atexit").attr("register")(py::cpp_function(&end_calls));
}

} // namespace
} // namespace prelight::python

PYBIND11_MODULE(_prelight, module) { prelight::python::bind_all(module); }
