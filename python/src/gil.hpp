#pragma once
#include <pybind11/pybind11.h>

namespace prelight::python {

/// While it lives other Python threads run.
class WithoutGil {
public:
    WithoutGil();
    ~WithoutGil();
    WithoutGil(const WithoutGil&) = delete;
    WithoutGil& operator=(const WithoutGil&) = delete;

private:
    PyThreadState* state_;
};

/// What takes long. It touches no Python object.
template <class Work>
auto without_gil(Work&& work) {
    const WithoutGil released;
    return work();
}

/// Called when the interpreter is about to end: lets calls of other threads come to their end, and none begin.
void end_calls();

} // namespace prelight::python
