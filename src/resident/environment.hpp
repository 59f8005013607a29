#pragma once
#include <gpu/context.hpp>
#include <gpu/texture.hpp>
#include <prelight/scene.hpp>
#include <shared/frame.h>

namespace prelight::resident {

/// An environment map as materials read it: level by level as a rougher mirror shows it.
struct EnvironmentLevels {
    std::vector<Image> images; ///< each half as wide and high as the one before; the last is the roughest
    glm::vec3 irradiance[9]{}; ///< spherical harmonics of what a white Lambert surface sends on
};

/// Prefilters for roughness 0 … 1 in equal steps (Karis, "Real Shading in Unreal Engine 4", 2013: the viewer
/// looks along the normal). Null: one black texel. Throws Error for an image that is not twice as wide as high
/// or holds what is no radiance.
EnvironmentLevels prefilter(const Environment* environment);
shared::EnvironmentConstants environment_constants(const EnvironmentLevels& levels, double exposure);
/// Wraps round, ends at the poles.
gpu::UniqueSampler make_environment_sampler(const gpu::Context& context);

} // namespace prelight::resident
