#pragma once
#include <cstdint>
#include <vector>

namespace prelight::gltf {

/// glTF's primitive modes.
enum class Mode { points, lines, line_loop, line_strip, triangles, strip, fan };

/// Triangle list of a list, strip or fan of indices, wound as glTF 2.0, 3.7.2.1 says. Left-over
/// indices that make no whole triangle are dropped.
std::vector<uint32_t> triangle_list(std::vector<uint32_t> indices, Mode mode);

/// The distinct values of `indices`, increasing; `indices` then become places in that list. The
/// cost depends on the indices alone, however many vertices there are.
std::vector<uint32_t> compact(std::vector<uint32_t>& indices);

} // namespace prelight::gltf
