#pragma once
#include <compare>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace prelight {

/// What a name leads to: the file itself, or of one that is not there yet its folder and its name in it. Two names of
/// one file have one identity, through symbolic and hard links.
struct FileIdentity {
    uint64_t device = 0;
    uint64_t inode = 0;
    std::string name; ///< empty: the file is there
    auto operator<=>(const FileIdentity&) const = default;
};

/// Nothing: a device or a pipe, or a name that leads nowhere. Throws Error: links in a circle.
std::optional<FileIdentity> identity_of(const std::filesystem::path& path);

} // namespace prelight
