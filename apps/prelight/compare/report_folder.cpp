#include "report_folder.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <platform/atomic_file.hpp>
#include <platform/process.hpp>
#include <platform/program/move_folder.hpp>
#include <platform/read_file.hpp>
#include <prelight/error.hpp>
#include <set>

namespace prelight::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& place, const std::string& reason) {
    throw Error(fmt::format("{}: {}", place.string(), reason));
}

using Json = nlohmann::json;

void add_pictures(std::set<std::string>& files, const Json& entry) {
    const auto pictures = entry.is_object() ? entry.find("pictures") : entry.end();
    if (!entry.is_object() || pictures == entry.end() || !pictures->is_object())
        return;
    for (const Json& file : *pictures)
        if (file.is_string())
            files.insert(file.get<std::string>());
}

/// What the report in the folder consists of, relative to it; nothing: there is none.
std::set<std::string> files_of_report(const fs::path& folder) {
    Json json;
    try {
        json = Json::parse(read_bytes(folder / "report.json", largest_file::figures), nullptr, false);
    } catch (const FileError&) {
        return {};
    }
    if (!json.is_object() || !json.contains("prelight_report"))
        return {};
    std::set<std::string> files{"index.html", "report.json", "pictures"};
    if (const auto reference = json.find("reference"); reference != json.end())
        add_pictures(files, *reference);
    if (const auto runs = json.find("runs"); runs != json.end() && runs->is_array())
        for (const Json& run : *runs)
            add_pictures(files, run);
    return files;
}

/// The first thing in the folder that is none of `known`: replacing the folder would remove it.
std::optional<std::string> stranger_in(const fs::path& folder, const std::set<std::string>& known) {
    for (fs::recursive_directory_iterator at(folder), end; at != end; ++at) {
        const std::string name = at->path().lexically_relative(folder).generic_string();
        const bool right_kind = name == "pictures" ? at->is_directory() && !at->is_symlink()
                                                   : at->symlink_status().type() == fs::file_type::regular;
        if (!known.contains(name) || !right_kind)
            return name;
    }
    return {};
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
    const std::optional<std::string> stranger = stranger_in(place, files_of_report(place));
    if (stranger)
        refuse(place,
               fmt::format("holds {}, which is of no earlier report; name a new folder, an empty one or one with "
                           "nothing but an earlier report",
                           *stranger));
}

} // namespace

ReportFolder::ReportFolder(const fs::path& place) : place_(fs::absolute(follow_links(place)).lexically_normal()) {
    if (place.empty())
        refuse(place, "not the name of a folder");
    if (!place_.has_filename()) // "report/"
        place_ = follow_links(place_.parent_path());
    check_place(place_);
    growing_ = place_.parent_path() / fmt::format(".prelight-{}.tmp", process_id());
    guard_.emplace(growing_);
    const auto lock = guard_->hold();
    std::error_code error;
    fs::remove_all(growing_, error); // of a process of this number that was killed
    if (!fs::create_directory(growing_, error) || !fs::create_directory(growing_ / "pictures", error))
        refuse(place, fmt::format("cannot be written ({})", error.message()));
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
    if (const std::error_code error = move_folder(growing_, place_))
        refuse(place_, fmt::format("cannot be replaced ({})", error.message()));
    // What lay there before now has the hidden name, and goes with this object.
}

} // namespace prelight::app
