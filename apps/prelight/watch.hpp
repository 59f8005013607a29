#pragma once
#include <filesystem>
#include <optional>
#include <vector>

namespace prelight::app {

/// Notices that the time or size of one of some files has changed, by asking a few times a second.
class FileWatch {
public:
    explicit FileWatch(std::vector<std::filesystem::path> files);
    /// Returns when a file has changed since the last call and all have then kept still for one poll,
    /// so that a writer has most likely finished. A file that is gone is waited for.
    void wait();
    /// The same without waiting: for who asks a few times a second.
    bool changed();

private:
    struct State {
        std::filesystem::file_time_type time;
        uintmax_t size = 0;
        bool operator==(const State&) const = default;
    };
    using States = std::vector<State>;
    std::optional<States> look() const; ///< nothing: one of them is not there now

    std::vector<std::filesystem::path> files_;
    std::optional<States> known_, before_; ///< what was told, and what was seen last
};

} // namespace prelight::app
