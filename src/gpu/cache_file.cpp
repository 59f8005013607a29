#include "cache_file.hpp"
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <platform/process.hpp>
#include <platform/read_file.hpp>

namespace prelight::gpu {
namespace {

namespace fs = std::filesystem;

struct Frame {
    char magic[8] = {'P', 'R', 'E', 'L', 'P', 'S', 'O', '1'};
    uint64_t length = 0;
    uint64_t checksum = 0;
};

uint64_t fnv1a(std::span<const std::byte> bytes) {
    uint64_t hash = 0xcbf29ce484222325u;
    for (const std::byte b : bytes)
        hash = (hash ^ static_cast<uint64_t>(b)) * 0x100000001b3u;
    return hash;
}

/// Nothing when it is not there or is no file.
std::vector<std::byte> read_if_there(const fs::path& file) {
    try {
        const FileBytes bytes = read_bytes(file, largest_file::pipeline_cache);
        const std::span<const std::byte> same = std::as_bytes(std::span(bytes));
        return {same.begin(), same.end()};
    } catch (const FileError&) {
        return {};
    }
}

} // namespace

fs::path cache_folder() {
    const fs::path folder = user_cache_folder();
    return folder.empty() ? folder : folder / "prelight";
}

void CacheKey::add(std::string_view bytes) {
    for (const char byte : bytes) {
        a_ = (a_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
        b_ = (b_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
    }
}

std::string CacheKey::text() const { return fmt::format("{:016x}{:016x}", a_, b_); }

std::vector<std::byte> seal_cache(std::span<const std::byte> payload) {
    Frame frame;
    frame.length = payload.size();
    frame.checksum = fnv1a(payload);
    std::vector<std::byte> file(sizeof frame + payload.size());
    std::memcpy(file.data(), &frame, sizeof frame);
    if (!payload.empty())
        std::memcpy(file.data() + sizeof frame, payload.data(), payload.size());
    return file;
}

std::span<const std::byte> open_cache(std::span<const std::byte> file) {
    Frame frame;
    const Frame expected;
    if (file.size() < sizeof frame)
        return {};
    std::memcpy(&frame, file.data(), sizeof frame);
    const auto payload = file.subspan(sizeof frame);
    if (std::memcmp(frame.magic, expected.magic, sizeof frame.magic) != 0 || frame.length != payload.size() ||
        frame.checksum != fnv1a(payload))
        return {};
    return payload;
}

std::vector<std::byte> read_cache(const fs::path& file) {
    const std::vector<std::byte> bytes = file.empty() ? std::vector<std::byte>{} : read_if_there(file);
    const auto payload = open_cache(bytes);
    return {payload.begin(), payload.end()};
}

void write_cache(const fs::path& file, std::span<const std::byte> payload) {
    static std::atomic<uint32_t> written = 0; // several threads may write
    std::error_code ignored;
    fs::create_directories(file.parent_path(), ignored);
    const fs::path temporary = file.string() + fmt::format(".{}-{}", process_id(), written++);
    const std::vector<std::byte> sealed = seal_cache(payload);
    std::ofstream out(temporary, std::ios::binary);
    out.write(reinterpret_cast<const char*>(sealed.data()), static_cast<std::streamsize>(sealed.size()));
    out.close();
    if (out)
        fs::rename(temporary, file, ignored);
    if (!out || ignored)
        fs::remove(temporary, ignored);
}

void trim_cache(const fs::path& folder, size_t most) {
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        std::error_code gone; // another process trims too
        if (const auto time = at->last_write_time(gone); !gone)
            files.emplace_back(time, at->path());
    }
    std::ranges::sort(files);
    for (size_t i = 0; i + most < files.size(); ++i)
        fs::remove_all(files[i].second, error);
}

} // namespace prelight::gpu
