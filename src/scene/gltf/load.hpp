#pragma once
#include <cstdint>
#include <filesystem>
#include <prelight/scene_io.hpp>
#include <span>
#include <string>

namespace prelight::gltf {

/// `load_gltf` of bytes in memory: for the fuzzer and for tests. `file` is the name in messages,
/// `folder` where relative URIs lead.
Scene load(std::span<const uint8_t> bytes, const std::string& file, const std::filesystem::path& folder,
           const LoadOptions& options = {});

} // namespace prelight::gltf
