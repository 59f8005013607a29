#pragma once
#include "lighting.hpp"
#include "tonemap.hpp"

namespace prelight::passes {

/// Deferred shading's buffers. What each channel holds: shaders/shared/gbuffer_layout.glsl.
struct GBuffer {
    SurfaceBuffers surface;               ///< depth, and RT1
    graph::ImageId light;                 ///< RT0: light so far, divided by ViewSettings::light_scale
    graph::ImageId motion;                ///< RT2; shaders/shared/motion_encoding.h
    graph::ImageId albedo;                ///< RT3
    bool ambient_apart = false;           ///< as in GBufferFormat
    graph::ImageId ambient{}, mirrored{}; ///< RT4 and RT5, only where ambient_apart
    /// The geometry pass's targets and its shader.
    std::vector<graph::ImageId> targets() const;
    gpu::ShaderKey fragment() const { return {"gbuffer_fill.frag", gpu::when(ambient_apart, gpu::Variant::occlusion)}; }
    LightTarget light_target() const { return {gpu::Variant::deferred_target, {light}, graph::Load::keep}; }
};

struct GBufferFormat {
    GBufferLayout layout = GBufferLayout::wide; ///< not `none`
    bool light_in_bytes = false;                ///< RT0 in RGBA8 instead of RGBA16F
    bool position_from_ray = true;
    bool stencil = false;               ///< killzone2 has it always
    bool specular_antialiasing = false; ///< as in SurfaceFormat
    bool wide_light = false;            ///< RT0 in RGBA32F, for many lights that blending adds up
    bool ambient_apart = false;         ///< ambient light waits in targets of its own for ambient_light_pass()
    uint32_t samples = 1;               ///< of a pixel; several for the wide layout
    uint32_t reduction = 1;             ///< pixels of the frame, along an axis, for each of the buffers'
    const char* pass = "geometry";      ///< its name
};

/// The geometry pass: every object once, into four targets and depth. Ambient and emissive light, and
/// the colour of unlit surfaces, stand in RT0 afterwards; lights are added to it. Motion needs
/// ViewSettings::motion.
GBuffer gbuffer_pass(graph::FrameGraph& graph, const resident::View& view, const GBufferFormat& format);

/// Adds to RT0 the ambient light that the geometry pass laid aside, where `visibility` (ambient_occlusion_passes())
/// lets it through.
void ambient_light_pass(graph::FrameGraph& graph, const resident::View& view, const GBuffer& gbuffer,
                        graph::ImageId visibility);

/// Light of edge pixels' samples, as RT0 has that of pixels.
struct SampleColours {
    SampleEdges edges;
    graph::ImageId light;
    gpu::Raster raster; ///< of the picture
};

/// RT0 → scene-linear and exposed, or with `display` the finished picture. Where bytes have clipped RGB, its intensity
/// channel gives back the luminance, up to eight times as much. `samples`: the picture has several, and those of edge
/// pixels their own light.
graph::ImageId light_resolve_pass(graph::FrameGraph& graph, const resident::View& view, const GBuffer& gbuffer,
                                  Display display = {}, const SampleColours* samples = nullptr);

} // namespace prelight::passes
