#include "pipeline_cache.hpp"
#include "check.hpp"
#include <fmt/format.h>

namespace prelight::gpu {

std::filesystem::path pipeline_cache_file(const VkPhysicalDeviceProperties& properties) {
    const std::filesystem::path folder = cache_folder();
    if (folder.empty())
        return {};
    std::string id;
    for (const uint8_t byte : properties.pipelineCacheUUID)
        id += fmt::format("{:02x}", byte);
    return folder / fmt::format("pipelines-{}.bin", id);
}

UniquePipelineCache load_pipeline_cache(VkDevice device, const std::filesystem::path& file) {
    const std::vector<std::byte> payload = read_cache(file);
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
    write_cache(file, payload);
}

} // namespace prelight::gpu
