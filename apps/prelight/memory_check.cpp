#include "memory_check.hpp"

#include "watchdog.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <prelight/error.hpp>
#include <sys/resource.h>
#include <unistd.h>

namespace prelight::app {
namespace {

namespace fs = std::filesystem;

constexpr uint64_t mebi = 1 << 20;
/// A software device with its compiler, measured with a frame of 64x36: what it writes to, and what it reserves.
constexpr uint64_t driver_bytes = 90 * mebi, driver_reserves = 330 * mebi;
/// Images of a frame with those that the host reads, a pixel and sample (1280x720 to 3840x2160).
constexpr uint64_t bytes_per_sample = 48;

/// A whole file of one number; nothing where it says "max" or is not there.
std::optional<uint64_t> number_in(const fs::path& file) {
    std::ifstream stream(file);
    uint64_t number = 0;
    return stream >> number ? std::optional(number) : std::nullopt;
}

/// The number after `key` in a file of lines.
std::optional<uint64_t> number_after(const fs::path& file, std::string_view key) {
    std::ifstream stream(file);
    for (std::string word; stream >> word;)
        if (uint64_t number = 0; word == key && stream >> number)
            return number;
    return {};
}

uint64_t less(uint64_t limit, uint64_t used) {
    return limit > used ? limit - used : 0;
}

void add_process_limits(std::vector<MemoryRoom>& rooms) {
    std::ifstream statm("/proc/self/statm");
    uint64_t size = 0, resident = 0, shared = 0, text = 0, library = 0, data = 0;
    if (!(statm >> size >> resident >> shared >> text >> library >> data))
        return;
    const auto page = static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
    rlimit limit = {};
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
        rooms.push_back({less(limit.rlim_cur, size * page), "ulimit -v", true});
    if (getrlimit(RLIMIT_DATA, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
        rooms.push_back({less(limit.rlim_cur, data * page), "ulimit -d"});
}

/// A group's limit holds for all groups in it; files in memory that nobody uses make room.
void add_group(std::vector<MemoryRoom>& rooms, fs::path folder, const fs::path& root, const char* most,
               const char* used, const char* unused) {
    for (; folder.native().size() >= root.native().size(); folder = folder.parent_path()) {
        const auto limit = number_in(folder / most), taken = number_in(folder / used);
        if (limit && taken && *limit < uint64_t(1) << 60)
            rooms.push_back({less(*limit + number_after(folder / "memory.stat", unused).value_or(0), *taken),
                             "the memory limit of this control group"});
    }
}

void add_control_groups(std::vector<MemoryRoom>& rooms) {
    const fs::path root = "/sys/fs/cgroup";
    std::ifstream stream("/proc/self/cgroup");
    for (std::string line; std::getline(stream, line);) {
        const size_t name = line.find(':') + 1, path = line.find(':', name) + 1;
        if (name == 0 || path == 0)
            continue;
        if (path == name + 1) // version 2 has one hierarchy, without a name
            add_group(rooms, root / line.substr(path + 1), root, "memory.max", "memory.current", "inactive_file");
        else if (line.substr(name, path - name - 1) == "memory")
            add_group(rooms, root / "memory" / line.substr(path + 1), root / "memory", "memory.limit_in_bytes",
                      "memory.usage_in_bytes", "total_inactive_file");
    }
}

std::string in_mebi(uint64_t bytes) {
    return fmt::format("{} MiB", (bytes + mebi / 2) / mebi);
}

template <class T>
uint64_t size_of(const std::vector<T>& values) {
    return values.size() * sizeof(T);
}

} // namespace

std::vector<MemoryRoom> memory_rooms() {
    std::vector<MemoryRoom> rooms;
    add_process_limits(rooms);
    add_control_groups(rooms);
    const auto available = number_after("/proc/meminfo", "MemAvailable:");
    if (available)
        rooms.push_back({(*available + number_after("/proc/meminfo", "SwapFree:").value_or(0)) * 1024, "this machine"});
    return rooms;
}

void check_memory(const std::string& what, uint64_t bytes, uint64_t reserved) {
    for (const MemoryRoom& room : memory_rooms())
        if (const uint64_t wanted = room.reserved ? std::max(bytes, reserved) : bytes; room.bytes < wanted)
            throw Error(fmt::format("out of memory: {} needs about {}{}, {} leaves {}", what, in_mebi(wanted),
                                    room.reserved ? " of address space" : "", room.limit, in_mebi(room.bytes)));
}

std::unique_ptr<Device> open_device(const DeviceOptions& options, uint32_t width, uint32_t height, uint32_t msaa) {
    const uint64_t frame = uint64_t(width) * height;
    constexpr uint64_t largest = uint64_t(1) << 32; // beyond it the renderer says what its limit is
    const uint64_t images = frame <= largest ? frame * msaa * bytes_per_sample : 0;
    check_memory(fmt::format("a frame of {}x{}", width, height), driver_bytes + images, driver_reserves + images);
    start_watchdog();
    return Device::create(options);
}

void check_memory_for(const Scene& scene) {
    uint64_t bytes = 0;
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& primitive : mesh.primitives)
            bytes += size_of(primitive.positions) + size_of(primitive.normals) + size_of(primitive.indices) +
                     size_of(primitive.tangents) + size_of(primitive.texcoords[0]) + size_of(primitive.texcoords[1]);
    for (const auto& image : scene.images)
        bytes += size_of(image.rgba) / 3 * 4; // with its mip levels
    check_memory(fmt::format("{} on the device", scene.name), bytes, bytes);
}

} // namespace prelight::app
