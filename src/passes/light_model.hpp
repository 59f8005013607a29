#pragma once
#include <gpu/pipeline.hpp>
#include <prelight/renderer.hpp>

namespace prelight::passes {

enum class FresnelModel { weighted, nv, mono, full };
enum class LightBufferFormat { rgba16f, packed_rgba16f, packed_rgba8 };

/// Which terms the light passes sum, and where the light buffer keeps them: [L4].
struct LightModel {
    Shading shading = Shading::ggx;
    FresnelModel fresnel = FresnelModel::weighted;
    LightBufferFormat buffer = LightBufferFormat::rgba16f;
    bool step_gate = false;         ///< [phong] specular-gate=step
    bool reflection_vector = false; ///< [phong] R·V instead of N·H
    bool ambient_as_light = false;
    bool packed() const { return buffer != LightBufferFormat::rgba16f; }
    gpu::Constants constants() const;
};

} // namespace prelight::passes
