#pragma once
#include <filesystem>
#include <optional>

namespace prelight::app {

/// Notices that a file's time or size has changed, by asking a few times a second.
class FileWatch {
public:
    explicit FileWatch(std::filesystem::path file);
    /// Returns when the file has changed since the last call and has then kept still for one poll,
    /// so that a writer has most likely finished. A file that is gone is waited for.
    void wait();

private:
    struct State {
        std::filesystem::file_time_type time;
        uintmax_t size = 0;
        bool operator==(const State&) const = default;
    };
    std::optional<State> look() const; ///< nothing: no such file now

    std::filesystem::path file_;
    std::optional<State> known_;
};

} // namespace prelight::app
