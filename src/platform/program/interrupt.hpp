#pragma once
#include <filesystem>
#include <mutex>
#include <platform/program/crash.hpp>
#include <thread>

namespace prelight {

/// Ctrl-C and the like end the program at once, but not while a file is being written: then right
/// after, or when they come a second time. A closed pipe or a limit of a file's size ends nothing: the write
/// fails. Call once, before the first WriteGuard.
void handle_interrupts();

/// While one lives, an interrupt waits. When the last one goes, a waiting interrupt ends the
/// program.
class WriteGuard {
public:
    WriteGuard();
    ~WriteGuard();
    WriteGuard(const WriteGuard&) = delete;
    WriteGuard& operator=(const WriteGuard&) = delete;
};

/// True while a WriteGuard lives.
bool is_writing();

/// True when an interrupt waits for a WriteGuard: nothing new should be written.
bool is_interrupted();

/// While one lives, an interrupt or a crash removes a folder with all that is in it and then ends the program at
/// once, whatever the program is doing. At most one at a time.
class RemovedOnInterrupt {
public:
    /// Throws Error when it cannot be set up.
    explicit RemovedOnInterrupt(std::filesystem::path folder);
    ~RemovedOnInterrupt();
    RemovedOnInterrupt(const RemovedOnInterrupt&) = delete;
    RemovedOnInterrupt& operator=(const RemovedOnInterrupt&) = delete;

    /// An interrupt waits while this is held: for every change in the folder, or of it.
    [[nodiscard]] std::unique_lock<std::mutex> hold() { return std::unique_lock(mutex_); }

private:
    void wait_for_signal();

    std::filesystem::path folder_;
    RemovedOnCrash crash_;
    std::mutex mutex_;
    int wakes_ = -1; ///< the end of a pipe that the signal handler's byte comes from
    std::thread thread_;
};

} // namespace prelight
