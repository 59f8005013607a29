#include "watch.hpp"

#include "watchdog.hpp"

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

void FileWatch::wait() {
    using namespace std::chrono_literals;
    const WatchdogPause pause;
    std::optional<States> before = known_;
    for (;;) {
        std::this_thread::sleep_for(200ms);
        const std::optional<States> now = look();
        if (now && now == before && now != known_) {
            known_ = now;
            return;
        }
        before = now;
    }
}

} // namespace prelight::app
