#include "watch.hpp"

#include <chrono>
#include <thread>

namespace prelight::app {

FileWatch::FileWatch(std::filesystem::path file) : file_(std::move(file)), known_(look()) {}

std::optional<FileWatch::State> FileWatch::look() const {
    std::error_code missing;
    State state;
    state.time = std::filesystem::last_write_time(file_, missing);
    if (!missing)
        state.size = std::filesystem::file_size(file_, missing);
    return missing ? std::nullopt : std::optional(state);
}

void FileWatch::wait() {
    using namespace std::chrono_literals;
    std::optional<State> before = known_;
    for (;;) {
        std::this_thread::sleep_for(200ms);
        const std::optional<State> now = look();
        if (now && now == before && now != known_) {
            known_ = now;
            return;
        }
        before = now;
    }
}

} // namespace prelight::app
