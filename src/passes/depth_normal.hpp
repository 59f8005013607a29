#pragma once
#include <gpu/pipeline.hpp>
#include <graph/frame_graph.hpp>
#include <resident/frame.hpp>

namespace prelight::passes {

enum class NormalEncoding { oct24, oct32, rgb10a2 };

/// How depth and normals are stored and read back: [L1] [L2] [L3].
struct SurfaceFormat {
    NormalEncoding normals = NormalEncoding::oct24;
    bool view_space = false;         ///< normals in view space instead of world space
    bool linear_depth = false;       ///< view depth in a colour target R32F instead of the attachment
    bool stencil = false;            ///< the depth attachment has stencil beside it
    bool position_from_ray = true;   ///< frustum ray, or the inverse view-projection matrix
    /// Specialisation constants of every shader that writes or reads these buffers.
    gpu::Constants constants() const;
};

/// Stage 1's result.
struct SurfaceBuffers {
    SurfaceFormat format;
    graph::ImageId depth;        ///< D32F attachment, or one with stencil; reversed
    graph::ImageId depth_source; ///< what later passes read: the attachment, or R32F
    graph::ImageId normal;
    graph::ImageId roughness;    ///< the normal target itself when it holds roughness
};

/// The depth attachment of a renderer: D32F, with `stencil` D32F_S8 or what the device has instead.
graph::ImageId make_depth(graph::FrameGraph& graph, VkExtent2D extent, bool stencil);

/// Depth, shading normals and roughness of the nearest surface, with MRT where the encoding has no
/// room for roughness.
SurfaceBuffers depth_normal_pass(graph::FrameGraph& graph, const resident::Frame& frame,
                                 const SurfaceFormat& format);

} // namespace prelight::passes
