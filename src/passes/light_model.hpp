#pragma once
#include <gpu/pipeline.hpp>
#include <prelight/renderer.hpp>

namespace prelight::passes {

enum class FresnelModel { weighted, nv, mono, full };
/// Pairs (diffuse and specular) and Engel's equation 8.5.2 in one target ("packed").
enum class LightBufferFormat { rgba16f, r11g11b10f, rgb10a2, rgba8, packed_rgba16f, packed_rgba8 };
/// The five ways to a material's own shininess, in the order of SPECULAR_….
enum class SpecularWay { stored, luv, fifth_channel, luminance, bent };

/// Which terms the light passes sum, and where the light buffer keeps them.
struct LightModel {
    Shading shading = Shading::ggx;
    FresnelModel fresnel = FresnelModel::weighted;
    LightBufferFormat buffer = LightBufferFormat::rgba16f;
    SpecularWay specular = SpecularWay::stored;
    bool step_gate = false;         ///< [phong] specular-gate=step
    bool reflection_vector = false; ///< [phong] R·V instead of N·H
    bool ambient_as_light = false;
    bool specular_antialiasing =
        false; ///< forward passes; elsewhere it is done where the surface is stored (SurfaceFormat)
    bool packed() const {
        return buffer == LightBufferFormat::packed_rgba16f || buffer == LightBufferFormat::packed_rgba8;
    }
    /// Codes of 0 … 1 times a scale, not floats.
    bool fixed_point() const {
        return buffer == LightBufferFormat::rgb10a2 || buffer == LightBufferFormat::rgba8 ||
               buffer == LightBufferFormat::packed_rgba8;
    }
    /// Alpha can hold the weighted Fresnel term of a pair.
    bool has_alpha() const { return buffer != LightBufferFormat::r11g11b10f && buffer != LightBufferFormat::rgb10a2; }
    /// Ambient light is a draw of its own, blended; LUV takes it in when it is written.
    bool ambient_blended() const { return ambient_as_light && specular != SpecularWay::luv; }
    gpu::Constants constants() const;
};

} // namespace prelight::passes
