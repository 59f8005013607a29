#include "gil.hpp"
#include <atomic>
#include <chrono>
#include <thread>

// An interpreter that ends does not wait for daemon threads. Two things must not happen: that one still draws when the
// driver's own exit handlers run, and that Python ends one by pthread_exit() where it wants the GIL back, which no
// frame of C++ between survives. So it is waited for what runs in the library, and threads that come back stay here.
namespace prelight::python {
namespace {

std::atomic<int> calls = 0;
std::atomic<bool> ending = false;
std::thread::id last_thread; ///< the one that ends the interpreter; written before `ending`

[[noreturn]] void stay() {
    for (;;)
        std::this_thread::sleep_for(std::chrono::hours(1));
}

bool must_stay() { return ending && std::this_thread::get_id() != last_thread; }

} // namespace

WithoutGil::WithoutGil() : state_(PyEval_SaveThread()) {
    ++calls;
    if (must_stay()) {
        --calls;
        stay();
    }
}

WithoutGil::~WithoutGil() {
    --calls;
    if (must_stay())
        stay();
    try {
        PyEval_RestoreThread(state_);
    } catch (...) { // the C library unwinds a thread that the interpreter ends while it waits for the GIL
        stay();
    }
}

void end_calls() {
    last_thread = std::this_thread::get_id();
    ending = true;
    PyThreadState* const state = PyEval_SaveThread();
    while (calls > 0)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    PyEval_RestoreThread(state);
}

} // namespace prelight::python
