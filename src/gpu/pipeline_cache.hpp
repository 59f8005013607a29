#pragma once
#include "handle.hpp"
#include <filesystem>
#include <span>
#include <vector>

namespace prelight::gpu {

/// Where the cache of this device and driver lies: $XDG_CACHE_HOME (or ~/.cache)/prelight/. Empty
/// when neither variable is set.
std::filesystem::path pipeline_cache_file(const VkPhysicalDeviceProperties& properties);

/// The file's own frame around the driver's bytes: magic, length, FNV-1a checksum. Drivers accept
/// random bytes in silence, so that a damaged file has to be found here.
std::vector<std::byte> seal_cache(std::span<const std::byte> payload);
/// The payload, or nothing when the frame is damaged.
std::span<const std::byte> open_cache(std::span<const std::byte> file);

/// Reads the file; a missing or damaged one gives an empty cache.
UniquePipelineCache load_pipeline_cache(VkDevice device, const std::filesystem::path& file);
/// Writes it (temporary name, then rename); failure is silent: a cache is only a help.
void save_pipeline_cache(VkDevice device, VkPipelineCache cache, const std::filesystem::path& file);

} // namespace prelight::gpu
