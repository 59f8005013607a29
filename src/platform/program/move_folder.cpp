#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <platform/program/move_folder.hpp>

namespace prelight {
namespace {

namespace fs = std::filesystem;

std::error_code last_error() { return {errno, std::generic_category()}; }

std::error_code swap_folders(const fs::path& a, const fs::path& b) {
    if (renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0)
        return {};
    const fs::path third = a.string() + ".old";
    if (std::rename(b.c_str(), third.c_str()) != 0)
        return last_error();
    if (std::rename(a.c_str(), b.c_str()) != 0) {
        const std::error_code why = last_error();
        std::rename(third.c_str(), b.c_str()); // as it was
        return why;
    }
    std::error_code ignored; // the new one is in place
    fs::rename(third, a, ignored);
    return {};
}

} // namespace

std::error_code move_folder(const fs::path& from, const fs::path& to) {
    std::error_code ignored;
    if (fs::exists(to, ignored))
        return swap_folders(from, to);
    return std::rename(from.c_str(), to.c_str()) == 0 ? std::error_code() : last_error();
}

} // namespace prelight
