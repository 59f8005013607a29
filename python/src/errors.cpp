#include "module.hpp"
#include <prelight/error.hpp>

namespace prelight::python {
namespace {

// Never freed: an exception may be thrown while the interpreter ends.
PyObject *error_class = nullptr, *device_lost_class = nullptr, *usage_error_class = nullptr;

PyObject* make_exception(py::module_& module, const char* name, const char* doc, const py::object& bases) {
    const std::string full = std::string("prelight.") + name;
    PyObject* made = PyErr_NewExceptionWithDoc(full.c_str(), doc, bases.ptr(), nullptr);
    if (!made)
        throw py::error_already_set();
    module.attr(name) = py::handle(made);
    return made;
}

void translate(std::exception_ptr thrown) {
    try {
        std::rethrow_exception(thrown);
    } catch (const DeviceLost& error) {
        PyErr_SetString(device_lost_class, error.what());
    } catch (const UsageError& error) {
        PyErr_SetString(usage_error_class, error.what());
    } catch (const Error& error) {
        PyErr_SetString(error_class, error.what());
    }
}

} // namespace

void bind_errors(py::module_& module) {
    error_class = make_exception(module, "Error",
                                 "The work failed: a bad file, no memory, a device that gives up. The text is one line "
                                 "that names the file or object, and the reason.",
                                 py::reinterpret_borrow<py::object>(PyExc_RuntimeError));
    device_lost_class = make_exception(module, "DeviceLost",
                                       "The device stopped working. Nothing that was made on it can be used any more; "
                                       "another Device may well be made.",
                                       py::reinterpret_borrow<py::object>(error_class));
    usage_error_class =
        make_exception(module, "UsageError",
                       "The request itself was wrong: an unknown name, a value out of range, an array of "
                       "another shape. Also a ValueError.",
                       py::make_tuple(py::handle(error_class), py::handle(PyExc_ValueError)));
    py::register_exception_translator(&translate);
}

} // namespace prelight::python
