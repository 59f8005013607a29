#pragma once
#include <gpu/pipeline.hpp>
#include <graph/frame_graph.hpp>
#include <resident/view.hpp>
#include <shared/bindings.h>
#include <span>
#include <string_view>

namespace prelight::passes {

enum class NormalEncoding : uint32_t {
    oct24 = NORMAL_OCT24,
    oct32 = NORMAL_OCT32,
    rgb10a2 = NORMAL_RGB10A2,
    rgb8 = NORMAL_RGB8,
    spherical = NORMAL_SPHERICAL,
    oct16 = NORMAL_OCT16,
    xy16f = NORMAL_XY16F,
};

/// What is to be known of an encoding. Its code stands in shaders/shared/normal_encoding.h.
struct NormalEncodingInfo {
    NormalEncoding encoding;
    const char* name;              ///< the value of `normals=`
    uint32_t bits;                 ///< that hold the normal
    std::vector<VkFormat> formats; ///< the target, and what takes its place where it is missing
};
/// In the order of the values of `normals=`; the first is the default.
std::span<const NormalEncodingInfo> normal_encodings();
/// Throws UsageError listing them.
const NormalEncodingInfo& find_normal_encoding(std::string_view name);

/// Where later passes read depth from: the attachment itself, or view depth in metres in a colour
/// target of this format.
enum class DepthSource : uint32_t {
    attachment = DEPTH_ATTACHMENT,
    r32f = DEPTH_R32F,
    r16f = DEPTH_R16F,
    rgba8 = DEPTH_RGBA8,
};

struct DepthSourceInfo {
    DepthSource source;
    const char* name; ///< the value of `depth=`
    VkFormat format;
};
/// The attachment, which is the default, and then the colour targets: where a device lacks one, the next
/// takes its place.
std::span<const DepthSourceInfo> depth_sources();
/// Throws UsageError listing them.
const DepthSourceInfo& find_depth_source(std::string_view name);

/// What else a G-buffer holds, and where: shaders/shared/gbuffer_layout.glsl.
enum class GBufferLayout : uint32_t { none = GBUFFER_NONE, wide = GBUFFER_WIDE, killzone2 = GBUFFER_KILLZONE2 };

/// How depth and normals are stored and read back.
struct SurfaceFormat {
    NormalEncoding normals = NormalEncoding::oct24;
    bool view_space = false; ///< normals in view space instead of world space
    DepthSource depth = DepthSource::attachment;
    bool stencil = false;              ///< the depth attachment has stencil beside it
    bool roughness_in_stencil = false; ///< where it is stored, instead of beside the normal
    bool position_from_ray = true;     ///< frustum ray, or the inverse view-projection matrix
    bool two_passes = false;           ///< geometry once for depth and once for normals, instead of MRT
    GBufferLayout gbuffer = GBufferLayout::none;
    bool ids = false; ///< an image of surface ids beside it (GpuSceneSettings::surface_ids); with the other defaults
    bool specular_antialiasing = false; ///< stored roughness grows with the spread of normals under a pixel
    /// Specialisation constants of every shader that writes or reads these buffers.
    gpu::Constants constants() const;
};

/// Stage 1's result.
struct SurfaceBuffers {
    SurfaceFormat format;        ///< as it became: of the next depth source where one is missing
    graph::ImageId depth;        ///< D32F attachment, or one with stencil; reversed
    graph::ImageId depth_source; ///< what later passes read: the attachment, or a colour target
    graph::ImageId normal;
    graph::ImageId roughness; ///< the normal target itself when it holds roughness, or stencil does
    graph::ImageId ids{};     ///< with SurfaceFormat::ids: RG32UI, the draw's number from 1 and its smooth group; or 0
};

/// The depth attachment of a renderer: D32F, with `stencil` D32F_S8 or what the device has instead.
graph::ImageId make_depth(graph::FrameGraph& graph, const gpu::Raster& raster, bool stencil);

/// Depth, shading normals and roughness of the nearest surface. At once, with MRT; or depth [and
/// linear depth] first, then normals [and roughness, where the encoding has no room for it] with depth
/// test EQUAL. Both give the same bytes.
SurfaceBuffers depth_normal_pass(graph::FrameGraph& graph, const resident::View& view, const SurfaceFormat& format);

/// A pass "geometry layers": blended objects into the same images, each where it is nearer than what is there and in
/// its own slot of the texels (resident::View::layers()). `surface` has ids.
void layer_geometry_pass(graph::FrameGraph& graph, const resident::View& view, const SurfaceBuffers& surface);

} // namespace prelight::passes
