#pragma once
#include <filesystem>

namespace prelight {

/// A signal that would end the program (a driver does not check every allocation, for one), std::terminate, and a
/// run that stands still all end the same way: one line on stderr, temporary files removed, exit status 1. Call
/// once, at the start. Under a sanitizer signals stay the sanitizer's.
void handle_crashes();

/// Ends the program that way now. Calls only what a signal handler may.
[[noreturn]] void end_by_crash(const char* reason) noexcept;

/// While one lives, a crash removes a folder, its files, and its folders' files. At most one at a time.
class RemovedOnCrash {
public:
    explicit RemovedOnCrash(const std::filesystem::path& folder);
    ~RemovedOnCrash();
    RemovedOnCrash(const RemovedOnCrash&) = delete;
    RemovedOnCrash& operator=(const RemovedOnCrash&) = delete;
};

} // namespace prelight
