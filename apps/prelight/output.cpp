#include "output.hpp"

#include "standard_streams.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <image/atomic_file.hpp>
#include <map>
#include <optional>
#include <prelight/error.hpp>
#include <sys/stat.h>

namespace prelight::app {
namespace {

namespace fs = std::filesystem;

/// What a name leads to: the file itself, or of one that is not there yet its folder and its name in it.
struct Identity {
    dev_t device = 0;
    ino_t inode = 0;
    std::string name; ///< empty: the file is there
    auto operator<=>(const Identity&) const = default;
};

/// Nothing: a device or a pipe, or a name that leads nowhere.
std::optional<Identity> identity_of(const fs::path& path) {
    struct stat status = {};
    if (stat(path.c_str(), &status) == 0) {
        if (S_ISCHR(status.st_mode) || S_ISFIFO(status.st_mode))
            return {};
        return Identity{status.st_dev, status.st_ino, {}};
    }
    const fs::path target = follow_links(path);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    if (stat(folder.c_str(), &status) != 0)
        return {};
    return Identity{status.st_dev, status.st_ino, target.filename().string()};
}

} // namespace

void check_writable(const fs::path& path) {
    if (is_standard_stream(path))
        return;
    const WriteGuard guard;
    const AtomicFile probe(path); // never committed, so it goes again
}

void check_distinct(std::span<const fs::path> outputs, std::span<const fs::path> inputs) {
    std::map<Identity, const fs::path*> written; // a sequence has thousands
    for (const fs::path& output : outputs) {
        const std::optional<Identity> identity = output.empty() ? std::nullopt : identity_of(output);
        if (!identity)
            continue;
        const auto [same, is_new] = written.emplace(*identity, &output);
        if (!is_new)
            throw UsageError(*same->second == output ? fmt::format("{}: named for two outputs", output.string())
                                                     : fmt::format("{}: is the same file as {}: named for two outputs",
                                                                   output.string(), same->second->string()));
    }
    for (const fs::path& input : inputs) {
        const std::optional<Identity> identity = input.empty() ? std::nullopt : identity_of(input);
        const auto same = identity && identity->name.empty() ? written.find(*identity) : written.end();
        if (same == written.end())
            continue;
        const fs::path& name = *same->second;
        throw UsageError(name == input ? fmt::format("{}: is read by this run and cannot be its output", name.string())
                                       : fmt::format("{}: is the same file as {}, which this run reads", name.string(),
                                                     input.string()));
    }
}

void check_outside(const fs::path& folder, std::span<const fs::path> inputs) {
    std::error_code error;
    const fs::path place = fs::weakly_canonical(folder, error);
    for (const fs::path& input : inputs) {
        const fs::path file = input.empty() || error ? fs::path() : fs::weakly_canonical(input, error);
        const auto [rest, ignored] = std::mismatch(place.begin(), place.end(), file.begin(), file.end());
        if (!file.empty() && rest == place.end())
            throw UsageError(fmt::format("{}: holds {}, which this run reads", folder.string(), input.string()));
    }
}

void save_text(std::string_view text, const fs::path& path) {
    if (is_standard_stream(path))
        return write_standard_output(std::as_bytes(std::span(text)));
    const WriteGuard guard;
    AtomicFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

} // namespace prelight::app
