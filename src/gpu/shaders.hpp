#pragma once
#include <cstdint>
#include <prelight/error.hpp>
#include <span>
#include <string_view>

namespace prelight::gpu {

/// SPIR-V of a file in shaders/, by its name ("depth_normal.frag"), embedded at build time.
/// Throws Error for a name that this build does not hold.
std::span<const uint32_t> find_shader(std::string_view name);

} // namespace prelight::gpu
