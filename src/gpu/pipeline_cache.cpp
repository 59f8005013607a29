#include "pipeline_cache.hpp"
#include "check.hpp"
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <system/read_file.hpp>
#include <unistd.h>

namespace prelight::gpu {
namespace {

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
std::vector<uint8_t> read_if_there(const std::filesystem::path& file) {
    try {
        return read_bytes(file, largest_file::pipeline_cache);
    } catch (const FileError&) {
        return {};
    }
}

} // namespace

std::filesystem::path pipeline_cache_file(const VkPhysicalDeviceProperties& properties) {
    std::filesystem::path folder;
    if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg && *xdg)
        folder = xdg;
    else if (const char* home = std::getenv("HOME"); home && *home)
        folder = std::filesystem::path(home) / ".cache";
    else
        return {};
    std::string id;
    for (const uint8_t byte : properties.pipelineCacheUUID)
        id += fmt::format("{:02x}", byte);
    return folder / "prelight" / fmt::format("pipelines-{}.bin", id);
}

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
    if (std::memcmp(frame.magic, expected.magic, sizeof frame.magic) != 0 ||
        frame.length != payload.size() || frame.checksum != fnv1a(payload))
        return {};
    return payload;
}

UniquePipelineCache load_pipeline_cache(VkDevice device, const std::filesystem::path& file) {
    const std::vector<uint8_t> bytes = read_if_there(file);
    const auto payload = open_cache(std::as_bytes(std::span(bytes)));
    VkPipelineCacheCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
    info.initialDataSize = payload.size();
    info.pInitialData = payload.data();
    VkPipelineCache cache = VK_NULL_HANDLE;
    if (vkCreatePipelineCache(device, &info, nullptr, &cache) != VK_SUCCESS) {
        info.initialDataSize = 0; // the driver refuses its own old bytes
        check(vkCreatePipelineCache(device, &info, nullptr, &cache), "pipeline cache");
    }
    return {device, cache};
}

void save_pipeline_cache(VkDevice device, VkPipelineCache cache, const std::filesystem::path& file) {
    size_t size = 0;
    if (file.empty() || vkGetPipelineCacheData(device, cache, &size, nullptr) != VK_SUCCESS)
        return;
    std::vector<std::byte> payload(size);
    if (vkGetPipelineCacheData(device, cache, &size, payload.data()) != VK_SUCCESS)
        return;
    payload.resize(size);
    std::error_code ignored;
    std::filesystem::create_directories(file.parent_path(), ignored);
    const std::filesystem::path temporary = file.string() + fmt::format(".{}", getpid());
    const std::vector<std::byte> sealed = seal_cache(payload);
    std::ofstream out(temporary, std::ios::binary);
    out.write(reinterpret_cast<const char*>(sealed.data()), static_cast<std::streamsize>(sealed.size()));
    out.close();
    if (out)
        std::filesystem::rename(temporary, file, ignored);
    if (!out || ignored)
        std::filesystem::remove(temporary, ignored);
}

} // namespace prelight::gpu
