#pragma once
#include <glm/vec4.hpp>
#include <gpu/context.hpp>
#include <passes/depth_normal.hpp>

namespace prelight::bench {

/// At least `count` unit vectors, always the same: first the 26 axes, edges and corners of a cube, where
/// encodings change sign or fold; then a spiral with the golden angle, in which each owns the same
/// area of the sphere. w: a roughness, 0.089 … 1. The number is a multiple of BENCH_WIDTH.
std::vector<glm::vec4> directions(uint32_t count);

/// What became of values in a real target.
struct Stored {
    VkFormat format = VK_FORMAT_UNDEFINED;
    std::vector<std::byte> texels;
    std::vector<glm::vec4> decoded; ///< as the light pass reads them
};

/// Encodes directions (with a roughness in w, which comes back 0 where the encoding does not hold it) on the
/// device into the encoding's target, and decodes from it. As many as a multiple of BENCH_WIDTH. Throws
/// Error.
Stored through_normal_target(const gpu::Context& context, const passes::NormalEncodingInfo& encoding,
                             std::span<const glm::vec4> directions);
/// The same with view depths in x, metres; `info` is not the attachment's.
Stored through_depth_target(const gpu::Context& context, const passes::DepthSourceInfo& info,
                            std::span<const glm::vec4> depths);

} // namespace prelight::bench
