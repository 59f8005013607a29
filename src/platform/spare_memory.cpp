#include <algorithm>
#include <charconv>
#include <optional>
#include <platform/read_file.hpp>
#include <platform/spare_memory.hpp>
#include <string_view>
#include <sys/resource.h>

namespace prelight {
namespace {

namespace fs = std::filesystem;

std::string kernel_text(const fs::path& file) {
    try {
        const FileBytes bytes = read_bytes(file, 1 << 20);
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

uint64_t less(uint64_t limit, uint64_t used) { return limit > used ? limit - used : 0; }

void add_process_limits(std::vector<MemoryRoom>& rooms) {
    const std::string status = kernel_text("/proc/self/status");
    const auto add = [&](__rlimit_resource which, const char* taken, const char* name, bool reserved) {
        rlimit limit{};
        if (getrlimit(which, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
            rooms.push_back({less(limit.rlim_cur, number_after(status, taken).value_or(0) * 1024), name, reserved});
    };
    add(RLIMIT_AS, "VmSize:", "ulimit -v", true);
    add(RLIMIT_DATA, "VmData:", "ulimit -d", false);
}

/// A group's limit holds for all groups in it; files in memory that nobody uses make room.
void add_group(std::vector<MemoryRoom>& rooms, fs::path folder, const fs::path& root, const char* most,
               const char* used, const char* unused) {
    for (; folder.native().size() >= root.native().size(); folder = folder.parent_path()) {
        const auto limit = number_after(kernel_text(folder / most), ""),
                   taken = number_after(kernel_text(folder / used), "");
        if (limit && taken && *limit < uint64_t(1) << 60)
            rooms.push_back(
                {less(*limit + number_after(kernel_text(folder / "memory.stat"), unused).value_or(0), *taken),
                 "the memory limit of this control group"});
    }
}

void add_control_groups(std::vector<MemoryRoom>& rooms) {
    const fs::path root = "/sys/fs/cgroup";
    const std::string groups = kernel_text("/proc/self/cgroup");
    for (std::string_view text = groups; !text.empty();) { // NUMBER:NAMES:/PATH
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        const size_t name = line.find(':') + 1, path = line.find(':', name) + 1;
        if (name == 0 || path == 0)
            continue;
        const std::string_view inner = line.substr(std::min(path + 1, line.size()));
        if (path == name + 1) // version 2 has one hierarchy, without a name
            add_group(rooms, root / inner, root, "memory.max", "memory.current", "\ninactive_file");
        else if (line.substr(name, path - name - 1) == "memory")
            add_group(rooms, root / "memory" / inner, root / "memory", "memory.limit_in_bytes", "memory.usage_in_bytes",
                      "total_inactive_file");
    }
}

} // namespace

std::vector<MemoryRoom> memory_rooms() {
    std::vector<MemoryRoom> rooms;
    add_process_limits(rooms);
    add_control_groups(rooms);
    const std::string machine = kernel_text("/proc/meminfo");
    if (const auto available = number_after(machine, "MemAvailable:"))
        rooms.push_back({(*available + number_after(machine, "SwapFree:").value_or(0)) * 1024, "this machine"});
    return rooms;
}

uint64_t spare_memory() {
    const std::vector<MemoryRoom> rooms = memory_rooms();
    const auto least =
        std::min_element(rooms.begin(), rooms.end(), [](const auto& a, const auto& b) { return a.bytes < b.bytes; });
    return least == rooms.end() ? uint64_t(1) << 30 : least->bytes;
}

} // namespace prelight
