#include <cstdlib>
#include <fmt/format.h>
#include <platform/process.hpp>
#include <sys/stat.h>
#include <unistd.h>

namespace prelight {

int process_id() { return getpid(); }

std::filesystem::path program_file() {
    std::error_code none;
    return std::filesystem::read_symlink("/proc/self/exe", none);
}

std::string program_identity() {
    struct stat status = {}; // of the file itself: its name may be another's by now
    if (stat("/proc/self/exe", &status) != 0)
        return "?";
    return fmt::format("{} {} {} {} {}", status.st_dev, status.st_ino, status.st_size, status.st_mtim.tv_sec,
                       status.st_mtim.tv_nsec);
}

void set_environment_default(const char* name, const std::string& value) { setenv(name, value.c_str(), 0); }

std::filesystem::path user_cache_folder() {
    if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg && *xdg)
        return xdg;
    if (const char* home = std::getenv("HOME"); home && *home)
        return std::filesystem::path(home) / ".cache";
    return {};
}

} // namespace prelight
