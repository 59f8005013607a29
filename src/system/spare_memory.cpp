#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <sys/resource.h>
#include <system/read_file.hpp>
#include <system/spare_memory.hpp>

namespace prelight {
namespace {

constexpr uint64_t unknown = std::numeric_limits<uint64_t>::max();

std::string kernel_text(const std::filesystem::path& file) {
    try {
        const std::vector<uint8_t> bytes = read_bytes(file, 1 << 20);
        return {bytes.begin(), bytes.end()};
    } catch (const FileError&) {
        return {};
    }
}

/// The number after `key`; nothing when there is none ("max").
std::optional<uint64_t> number_after(std::string_view text, std::string_view key) {
    const size_t at = text.find(key);
    if (at == std::string_view::npos)
        return {};
    text.remove_prefix(at + key.size());
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    uint64_t value = 0;
    if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc())
        return {};
    return value;
}

uint64_t left_of(std::optional<uint64_t> limit, std::optional<uint64_t> taken) {
    return limit ? *limit - std::min(*limit, taken.value_or(0)) : unknown;
}

/// Of the control group and all around it, as seen from inside a container too.
uint64_t left_of_group() {
    const std::string groups = kernel_text("/proc/self/cgroup");
    const size_t unified = groups.find("0::/");
    uint64_t left = unknown;
    const auto look = [&left](const std::filesystem::path& folder, const char* limit, const char* taken) {
        left = std::min(left, left_of(number_after(kernel_text(folder / limit), ""),
                                      number_after(kernel_text(folder / taken), "")));
    };
    if (unified != std::string::npos) {
        std::filesystem::path group = groups.substr(unified + 3, groups.find('\n', unified) - unified - 3);
        for (; group.has_relative_path(); group = group.parent_path())
            look("/sys/fs/cgroup" + group.string(), "memory.max", "memory.current");
    }
    look("/sys/fs/cgroup", "memory.max", "memory.current");
    look("/sys/fs/cgroup/memory", "memory.limit_in_bytes", "memory.usage_in_bytes");
    return left;
}

uint64_t left_of_limit(__rlimit_resource which, std::string_view status, std::string_view taken) {
    rlimit limit{};
    if (getrlimit(which, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return unknown;
    return left_of(limit.rlim_cur, number_after(status, taken).value_or(0) * 1024);
}

} // namespace

uint64_t spare_memory() {
    const auto available = number_after(kernel_text("/proc/meminfo"), "MemAvailable:");
    const std::string status = kernel_text("/proc/self/status");
    const uint64_t least = std::min({available ? *available * 1024 : unknown, left_of_group(),
                                     left_of_limit(RLIMIT_AS, status, "VmSize:"),
                                     left_of_limit(RLIMIT_DATA, status, "VmData:")});
    return least == unknown ? uint64_t(1) << 30 : least;
}

} // namespace prelight
