#include <atomic>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fmt/format.h>
#include <platform/atomic_file.hpp>
#include <platform/program/interrupt.hpp>
#include <prelight/error.hpp>
#include <unistd.h>

namespace prelight {
namespace {

// A signal handler can reach nothing but static storage. It may run in any thread (a driver has
// some of its own), hence atomics in place of a signal mask.
static_assert(std::atomic<int>::is_always_lock_free);
std::atomic<int> writing = 0;
std::atomic<int> waiting = 0;
/// Where a RemovedOnInterrupt listens; −1: nobody does.
std::atomic<int> listener = -1;

/// Ends the process by the signal itself, so that a shell sees why.
void die_by(int signal) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

/// write() is one of the few calls that a signal handler may make.
bool tell_listener(unsigned char byte) {
    const int descriptor = listener;
    return descriptor >= 0 && write(descriptor, &byte, 1) == 1;
}

extern "C" void on_interrupt(int signal) {
    if (tell_listener(static_cast<unsigned char>(signal)))
        return;
    const bool again = waiting.exchange(signal) != 0; // whoever asks twice does not wait for a slow disk
    if (writing == 0 || again) {
        remove_temporary_files();
        die_by(signal);
    }
}

} // namespace

void handle_interrupts() {
    // A write that fails for these reasons then says so itself.
    for (const int signal : {SIGPIPE, SIGXFSZ})
        std::signal(signal, SIG_IGN);
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

WriteGuard::WriteGuard() { ++writing; }

WriteGuard::~WriteGuard() {
    if (--writing == 0 && waiting != 0)
        die_by(waiting);
}

bool is_writing() { return writing != 0; }

bool is_interrupted() { return waiting != 0; }

RemovedOnInterrupt::RemovedOnInterrupt(std::filesystem::path folder) : folder_(std::move(folder)), crash_(folder_) {
    int ends[2] = {-1, -1};
    if (pipe2(ends, O_CLOEXEC) != 0)
        throw Error(fmt::format("{}: no pipe for signals", folder_.string()));
    wakes_ = ends[0];
    thread_ = std::thread([this] { wait_for_signal(); });
    listener = ends[1];
}

RemovedOnInterrupt::~RemovedOnInterrupt() {
    const int end = listener.exchange(-1); // from here on a signal ends the program at once
    const unsigned char none = 0;          // no signal: the thread ends
    if (write(end, &none, 1) != 1)
        std::abort(); // a pipe with room for 65,536 bytes
    thread_.join();
    close(end);
    close(wakes_);
}

void RemovedOnInterrupt::wait_for_signal() {
    unsigned char signal = 0;
    if (read(wakes_, &signal, 1) != 1 || signal == 0)
        return;
    const auto lock = hold();
    remove_temporary_files();
    std::error_code ignored; // nothing more can be done about what stays
    std::filesystem::remove_all(folder_, ignored);
    die_by(signal);
}

} // namespace prelight
