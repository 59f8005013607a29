#pragma once
#include <span>
#include <string_view>
#include <utility>

namespace prelight::gpu {

/// The fragment shaders in shaders/ and all of shaders/shared/ as they were when this was built:
/// {path as #include names it, text}.
std::span<const std::pair<std::string_view, std::string_view>> glsl_sources();

} // namespace prelight::gpu
