#include "watch.hpp"

#include <platform/program/watchdog.hpp>

#include <chrono>
#include <thread>

namespace prelight::app {

FileWatch::FileWatch(std::vector<std::filesystem::path> files) : files_(std::move(files)), known_(look()) {}

std::optional<FileWatch::States> FileWatch::look() const {
    States states;
    for (const std::filesystem::path& file : files_) {
        std::error_code missing;
        State& state = states.emplace_back();
        state.time = std::filesystem::last_write_time(file, missing);
        if (!missing)
            state.size = std::filesystem::file_size(file, missing);
        if (missing)
            return {};
    }
    return states;
}

bool FileWatch::changed() {
    const std::optional<States> now = look();
    const bool settled = now && now == before_ && now != known_;
    before_ = now;
    if (settled)
        known_ = now;
    return settled;
}

void FileWatch::wait() {
    using namespace std::chrono_literals;
    const WatchdogPause pause;
    before_ = known_;
    do
        std::this_thread::sleep_for(200ms);
    while (!changed());
}

} // namespace prelight::app
