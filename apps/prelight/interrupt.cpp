#include "interrupt.hpp"

#include <atomic>
#include <csignal>

namespace prelight::app {
namespace {

// A signal handler can reach nothing but static storage. It may run in any thread (a driver has
// some of its own), hence atomics in place of a signal mask.
static_assert(std::atomic<int>::is_always_lock_free);
std::atomic<int> writing = 0;
std::atomic<int> waiting = 0;

/// Ends the process by the signal itself, so that a shell sees why.
void die_by(int signal) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

extern "C" void on_interrupt(int signal) {
    waiting = signal;
    if (writing == 0)
        die_by(signal);
}

} // namespace

void handle_interrupts() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction before = {};
        sigaction(signal, nullptr, &before);
        if (before.sa_handler == SIG_IGN) // as under nohup
            continue;
        struct sigaction action = {};
        action.sa_handler = on_interrupt;
        action.sa_flags = SA_RESTART;
        sigaction(signal, &action, nullptr);
    }
}

WriteGuard::WriteGuard() {
    ++writing;
}

WriteGuard::~WriteGuard() {
    if (--writing == 0 && waiting != 0)
        die_by(waiting);
}

} // namespace prelight::app
