#pragma once
#include <gpu/context.hpp>
#include <gpu/texture.hpp>
#include <prelight/scene.hpp>
#include <shared/frame.h>

namespace prelight::resident {

/// An environment map as materials read it: level by level as a rougher mirror shows it.
struct EnvironmentLevels {
    /// Each half as wide and high as the one before. Two maps in each, one above the other: the even steps of roughness
    /// above, the odd ones below; they begin at 0 and 1/8, and four steps double it.
    std::vector<Image> images;
    Image sky; ///< what the background shows: the map itself or its backdrop, 4,096 wide at most; one texel when it is
               ///< not seen
    glm::vec3 irradiance[9]{}; ///< spherical harmonics of what a white Lambert surface sends on
    double intensity = 1;      ///< factor on all of it
    double turns = 0;          ///< 0 … 1, Environment::rotation; it is in `irradiance`
};

/// Prefilters for 14 steps of roughness, 0 … 1 (Karis, "Real Shading in Unreal Engine 4", 2013: the viewer
/// looks along the normal). Null: one black texel. Throws Error as check_environment() does.
EnvironmentLevels prefilter(const Environment* environment);
shared::EnvironmentConstants environment_constants(const EnvironmentLevels& levels, double exposure);
/// Wraps round, ends at the poles.
gpu::UniqueSampler make_environment_sampler(const gpu::Context& context);

} // namespace prelight::resident
