#include <atomic>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <platform/program/crash.hpp>
#include <platform/program/interrupt.hpp>
#include <platform/program/watchdog.hpp>
#include <string>
#include <sys/resource.h>
#include <thread>

namespace prelight {
namespace {

std::atomic<int> pauses = 0; // of the whole process, as what is watched is

double seconds_of(const timeval& time) { return double(time.tv_sec) + double(time.tv_usec) * 1e-6; }

/// What only a process that does something adds to.
struct Work {
    double cpu = 0; ///< seconds
    long transfers = 0;

    static Work now() {
        rusage usage = {};
        getrusage(RUSAGE_SELF, &usage);
        return {seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime),
                usage.ru_majflt + usage.ru_inblock + usage.ru_oublock};
    }
    /// The watchdog's own looks cost less than a hundredth of this in a minute.
    bool more_than(const Work& before) const { return cpu > before.cpu + 0.02 || transfers != before.transfers; }
};

/// The line of a /proc file that begins with `key`, without it.
std::string proc_line(const std::filesystem::path& file, const std::string& key) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);)
        if (line.starts_with(key))
            return line.substr(key.size());
    return {};
}

bool is_traced() {
    const std::string tracer = proc_line("/proc/self/status", "TracerPid:");
    return tracer.find_first_of("123456789") != std::string::npos;
}

/// A thread that waits for a disk or a file server cannot be blamed.
bool waits_for_disk() {
    std::error_code error;
    for (std::filesystem::directory_iterator at("/proc/self/task", error), end; !error && at != end;
         at.increment(error))
        if (proc_line(at->path() / "status", "State:").find('D') == 1)
            return true;
    return false;
}

void watch(unsigned patience) {
    Work last = Work::now();
    for (unsigned idle = 0;;) {
        std::this_thread::sleep_for(std::chrono::seconds(1));
        const Work now = Work::now();
        if (now.more_than(last) || pauses != 0 || is_writing()) {
            last = now;
            idle = 0;
        } else if (++idle >= patience) {
            if (!is_traced() && !waits_for_disk())
                end_by_crash("stands still: no processor time used for a while, the driver waits for itself");
            idle = 0;
        }
    }
}

} // namespace

void start_watchdog(unsigned seconds) {
    static std::atomic<bool> started = false;
    if (const char* text = std::getenv("PRELIGHT_STANDSTILL"))
        std::from_chars(text, text + std::strlen(text), seconds);
    if (seconds == 0 || started.exchange(true))
        return;
    try {
        std::thread(watch, seconds).detach();
    } catch (const std::system_error&) {
        // No thread to be had: the work itself will say so.
    }
}

WatchdogPause::WatchdogPause() { ++pauses; }

WatchdogPause::~WatchdogPause() { --pauses; }

} // namespace prelight
