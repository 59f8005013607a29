#pragma once
#include <platform/program/interrupt.hpp>

#include <filesystem>
#include <functional>
#include <optional>

namespace prelight::app {

/// A folder that appears whole or not at all: it grows under a hidden name beside its place, takes its
/// place by `publish`, and is removed when that never comes, an interrupt included.
class ReportFolder {
public:
    /// `place` may be nothing, an empty folder, or an earlier report, which `publish` will replace;
    /// anything else is refused, since replacing removes it. Throws Error naming `place`.
    explicit ReportFolder(const std::filesystem::path& place);
    ~ReportFolder();
    ReportFolder(const ReportFolder&) = delete;
    ReportFolder& operator=(const ReportFolder&) = delete;

    /// Lets `save` write into the folder, whose present path it receives.
    void write(const std::function<void(const std::filesystem::path&)>& save);
    void publish();

private:
    std::filesystem::path place_, growing_;
    std::optional<RemovedOnInterrupt> guard_;
};

} // namespace prelight::app
