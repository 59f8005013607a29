#pragma once
#include "depth_normal.hpp"

namespace prelight::passes {

enum class FresnelModel { weighted, nv, mono, full };
enum class LightBufferFormat { rgba16f, packed_rgba16f, packed_rgba8 };

/// Which terms the light buffer sums, and where: [L4].
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

/// Stage 2's result; `specular` is the diffuse image itself when packed.
struct LightBuffer {
    graph::ImageId diffuse;
    graph::ImageId specular;
};

struct LightVolumeInputs {
    SurfaceBuffers surface;
    LightModel model;
    const gpu::Buffer* pair_counters = nullptr; ///< two uint32 a row of pixels; always bound
    bool count_pairs = false;
};

/// All lights into the light buffer, light by light: full-screen triangles [V1], spheres and cones
/// with depth test by camera position [V3], instanced [V5].
LightBuffer light_volume_pass(graph::FrameGraph& graph, const resident::Frame& frame,
                              const LightVolumeInputs& inputs);

/// The same draws, but each adds 1 to R, and 1 to G where the light contributes: for --view light-count.
graph::ImageId light_count_pass(graph::FrameGraph& graph, const resident::Frame& frame,
                                const LightVolumeInputs& inputs);

} // namespace prelight::passes
