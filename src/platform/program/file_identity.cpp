#include <platform/atomic_file.hpp>
#include <platform/program/file_identity.hpp>
#include <sys/stat.h>

namespace prelight {

std::optional<FileIdentity> identity_of(const std::filesystem::path& path) {
    struct stat status = {};
    if (stat(path.c_str(), &status) == 0) {
        if (S_ISCHR(status.st_mode) || S_ISFIFO(status.st_mode))
            return {};
        return FileIdentity{status.st_dev, status.st_ino, {}};
    }
    const std::filesystem::path target = follow_links(path);
    const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : ".";
    if (stat(folder.c_str(), &status) != 0)
        return {};
    return FileIdentity{status.st_dev, status.st_ino, target.filename().string()};
}

} // namespace prelight
