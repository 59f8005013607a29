#include "report_folder.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <prelight/error.hpp>
#include <system/read_file.hpp>
#include <unistd.h>

namespace prelight::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& place, const std::string& reason) {
    throw Error(fmt::format("{}: {}", place.string(), reason));
}

/// Whether all that is in the folder was written by `compare`.
bool is_report(const fs::path& folder) {
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename();
        if (name != "index.html" && name != "report.json" && name != "pictures")
            return false;
    }
    try {
        const auto json = nlohmann::json::parse(read_bytes(folder / "report.json", largest_file::figures), nullptr, false);
        return json.is_object() && json.contains("prelight_report");
    } catch (const FileError&) {
        return false;
    }
}

void check_place(const fs::path& place) {
    std::error_code error;
    const fs::file_status status = fs::status(place, error);
    if (!fs::exists(status))
        return;
    if (!fs::is_directory(status))
        refuse(place, "is there and is no folder");
    if (fs::is_empty(place, error) && !error)
        return;
    if (error)
        refuse(place, "cannot be read");
    if (!is_report(place))
        refuse(place, "holds other files; name a new folder, an empty one or an earlier report");
}

/// Swaps the two folders at once where the file system can, else by way of a third name.
bool swap_folders(const fs::path& a, const fs::path& b) {
    if (renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0)
        return true;
    const fs::path third = a.string() + ".old";
    if (std::rename(b.c_str(), third.c_str()) != 0)
        return false;
    if (std::rename(a.c_str(), b.c_str()) != 0) {
        const int why = errno;
        std::rename(third.c_str(), b.c_str()); // as it was
        errno = why;
        return false;
    }
    std::error_code ignored; // the new one is in place
    fs::rename(third, a, ignored);
    return true;
}

} // namespace

ReportFolder::ReportFolder(const fs::path& place) : place_(fs::absolute(place).lexically_normal()) {
    if (place.empty())
        refuse(place, "not the name of a folder");
    if (!place_.has_filename()) // "report/"
        place_ = place_.parent_path();
    check_place(place_);
    growing_ = place_.parent_path() / fmt::format(".{}.{}.tmp", place_.filename().string(), getpid());
    guard_.emplace(growing_);
    const auto lock = guard_->hold();
    std::error_code error;
    if (!fs::create_directory(growing_, error) || !fs::create_directory(growing_ / "pictures", error))
        refuse(place, fmt::format("cannot be written ({})",
                                  error ? error.message() : growing_.string() + " exists"));
}

ReportFolder::~ReportFolder() {
    {
        const auto lock = guard_->hold();
        std::error_code ignored;
        fs::remove_all(growing_, ignored);
    }
    guard_.reset();
}

void ReportFolder::write(const std::function<void(const fs::path&)>& save) {
    const auto lock = guard_->hold();
    save(growing_);
}

void ReportFolder::publish() {
    const auto lock = guard_->hold();
    check_place(place_); // hours may have passed
    std::error_code error;
    const bool done = fs::exists(place_, error) ? swap_folders(growing_, place_)
                                                : std::rename(growing_.c_str(), place_.c_str()) == 0;
    if (!done)
        refuse(place_, fmt::format("cannot be replaced ({})", std::strerror(errno)));
    // What lay there before now has the hidden name, and goes with this object.
}

} // namespace prelight::app
