#pragma once
#include "cache_file.hpp"
#include "handle.hpp"

namespace prelight::gpu {

/// Where the cache of this device and driver lies: in cache_folder(); empty when there is none.
std::filesystem::path pipeline_cache_file(const VkPhysicalDeviceProperties& properties);

/// Reads the file; a missing or damaged one gives an empty cache. Drivers accept random bytes in silence, so that a
/// damaged file has to be found by the frame around them.
UniquePipelineCache load_pipeline_cache(VkDevice device, const std::filesystem::path& file);
/// Writes it; failure is silent.
void save_pipeline_cache(VkDevice device, VkPipelineCache cache, const std::filesystem::path& file);

} // namespace prelight::gpu
