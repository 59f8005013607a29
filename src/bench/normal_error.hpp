#pragma once
#include <gpu/context.hpp>
#include <passes/depth_normal.hpp>
#include <glm/vec4.hpp>

namespace prelight::bench {

/// At least `count` unit vectors, always the same: first the 26 axes, edges and corners of a cube, where
/// encodings change sign or fold; then a spiral with the golden angle, in which each owns the same
/// area of the sphere. w: a roughness, 0.089 … 1. The number is a multiple of BENCH_WIDTH.
std::vector<glm::vec4> directions(uint32_t count);

/// What became of directions in a real target.
struct EncodedNormals {
    VkFormat format = VK_FORMAT_UNDEFINED;
    std::vector<std::byte> stored;  ///< the target's texels
    std::vector<glm::vec4> decoded; ///< xyz as the light pass reads it; w: roughness, 0 without
};

/// Encodes on the device into the encoding's target and decodes from it. `directions`: a multiple
/// of BENCH_WIDTH of them. Throws Error.
EncodedNormals through_target(const gpu::Context& context, const passes::NormalEncodingInfo& encoding,
                              std::span<const glm::vec4> directions);

} // namespace prelight::bench
