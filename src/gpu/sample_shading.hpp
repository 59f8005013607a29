#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace prelight::gpu {

/// How often a fragment shader runs where a pixel has several samples.
enum class SampleShading {
    fragment, ///< once for all samples that a triangle covers of a pixel
    sample    ///< once a sample
};

/// SPIR-V of a fragment shader that runs once a sample: its interpolated inputs take the decoration Sample, for some
/// drivers interpolate to the pixel's centre even where they shade every sample. Flat ones stay.
std::vector<uint32_t> with_sample_inputs(std::span<const uint32_t> code);

/// SPIR-V of a fragment shader whose gl_SampleMaskIn is what the depth test leaves of a triangle's coverage, tested
/// before it runs: it discards nothing and writes no depth. Needs OptionalFeatures::post_depth_coverage.
std::vector<uint32_t> with_post_depth_coverage(std::span<const uint32_t> code);

} // namespace prelight::gpu
