#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace prelight::gpu {

/// How often a fragment shader runs where a pixel has several samples.
enum class SampleShading {
    fragment,       ///< once for all samples that a triangle covers of a pixel
    owned_fragment, ///< likewise; gl_SampleMaskIn has the samples that pass the depth test (post_depth_coverage)
    sample          ///< once a sample
};

/// SPIR-V of a fragment shader made to run so. `sample`: its interpolated inputs take the decoration Sample, for some
/// drivers interpolate to the pixel's centre even where they shade every sample. `owned_fragment`: depth tests come
/// first, and coverage after them; the shader may not discard.
std::vector<uint32_t> with_sample_shading(std::span<const uint32_t> code, SampleShading shading);

} // namespace prelight::gpu
