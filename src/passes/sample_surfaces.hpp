#pragma once
#include "depth_normal.hpp"
#include <gpu/buffer.hpp>
#include <gpu/frames_in_flight.hpp>
#include <memory>

namespace prelight::passes {

/// Which pixels have their samples lit by themselves.
enum class SampleLight {
    edges,   ///< those whose samples do not share a surface
    samples, ///< all that show one
    pixel    ///< none: one light for all samples
};

/// Where the samples of edge pixels lie in the sample light buffer (shaders/shared/edge_samples.glsl).
struct SampleEdges {
    /// R32_UINT, or R32G32B32A32_UINT where the sample light buffer is large: which samples of a pixel share surfaces,
    /// 0: it is no edge; and of an edge, where its surfaces begin in the sample light buffer.
    graph::ImageId flags;
    std::shared_ptr<const gpu::Buffer> tile_buffer;
    graph::BufferId tiles;   ///< its id: LitBlocks, then the block of each tile of 8 × 8 texels
    graph::BufferId pixels;  ///< what fills each texel: a pixel of the block, and some of its samples
    gpu::Raster raster;      ///< of the sample light buffer
    uint32_t first_row = 0;  ///< of texels; above it lies the light buffer, in the same image
    uint32_t tile_count = 0; ///< that it has room for
    uint32_t row = 0;        ///< tiles of it along x
    uint32_t samples = 1;
    bool every_sample = false; ///< is a surface of its own
    /// Of shaders that find samples in it.
    gpu::Constants constants() const;
    /// The sample light buffer goes beneath the light buffer of `view`, if one image can hold both.
    void lay_beneath(const resident::View& view);
    bool lies_beneath() const { return first_row > 0; }
    /// Of an image with both.
    gpu::Raster whole_raster(const resident::View& view) const;
};

/// Surfaces with several samples a pixel, and one a pixel out of them; both are the same with one sample.
struct SampledSurfaces {
    SurfaceBuffers samples;
    SurfaceBuffers pixels;
    std::optional<SampleEdges> edges; ///< none: all of a pixel's samples are lit as one
    /// With `edges`: a light's shadow is that at the pixel's one surface, for all its samples that the light reaches;
    /// where it does not reach that surface, at each sample's own.
    bool shadows_per_pixel = false;
};

/// The rest of a G-buffer: RT0, RT2 and RT3.
struct GBufferColours {
    graph::ImageId light, material, albedo;
};

/// What is known of the frames that are done about how many pixels are edges.
class EdgeCounter {
public:
    explicit EdgeCounter(const gpu::Context& context);
    /// Room for tiles in the sample light buffer of the graph that is built next, at most `all`. No frame is in flight.
    uint32_t room(uint32_t all);
    /// Reads what a frame that is done has counted, before another takes the slot. True where there was too little
    /// room.
    bool take(uint32_t slot);

private:
    friend SampledSurfaces sampled_surfaces(graph::FrameGraph&, const resident::View&, const SurfaceBuffers&,
                                            SampleLight, EdgeCounter&, GBufferColours*);
    gpu::PerFrame<gpu::Buffer> counts_;
    uint32_t needed_ = 0, room_ = 0, all_ = 0; ///< tiles
    bool warming_ = false;                     ///< a warm-up has counted pixels that nobody drew
};

/// Passes "sample-surfaces", and "sample-edges" where edges are lit by themselves. `surface` has several samples a
/// pixel, depth in its attachment, and roughness in a colour target. `colours`: with several samples, and with one a
/// pixel afterwards.
SampledSurfaces sampled_surfaces(graph::FrameGraph& graph, const resident::View& view, const SurfaceBuffers& surface,
                                 SampleLight light, EdgeCounter& counter, GBufferColours* colours = nullptr);

} // namespace prelight::passes
