#pragma once
#include <gpu/pipeline.hpp>
#include <graph/frame_graph.hpp>
#include <map>
#include <optional>
#include <resident/view.hpp>

namespace prelight::passes {

/// Draws objects of a frame with one fragment shader: one pipeline for each set of material features
/// that the world uses. What all passes over the geometry have in common.
class SurfaceDraws {
public:
    /// Objects that decals reach: drawn like others, with the shader's variant DECALS (declare_decals()), or with it
    /// and no other object.
    enum class Decals { none, read, only };
    struct Desc {
        std::string name;
        gpu::ShaderKey fragment;          ///< with `depth_only`: the shader of masked materials
        gpu::ShaderKey own_fragment = {}; ///< the stage for materials with a shader of their own; empty: `fragment`
        gpu::Constants constants;
        gpu::DepthTest depth = gpu::DepthTest::write_nearer;
        bool keeps_alpha_mask = true; ///< false: the mask is not asked again, the depth test decides
        gpu::Blend blend = gpu::Blend::none;
        uint32_t push_bytes = 0; ///< push constants of every draw, in the fragment shader
        /// Of surface.vert: MOTION (GpuSceneSettings::motion); SURFACE_IDS (GpuSceneSettings::surface_ids); NO_WORLD
        /// and NO_NORMAL where the fragment shader reads no point and no normal; NO_TEXTURES where it has that variant
        /// too, for materials without textures.
        gpu::Variants vertex = {};
        /// What has an alpha mask is shaded once a sample wherever the mask is asked, and so is what reads decals or
        /// the depth behind it.
        gpu::SampleShading sample_shading = gpu::SampleShading::fragment;
        bool post_depth_coverage = false; ///< gpu::GraphicsPipelineDesc::post_depth_coverage, where a device can
        uint32_t sample_mask = ~0u;       ///< gpu::GraphicsPipelineDesc::sample_mask
        bool depth_only = false;          ///< materials without mask get positions and no shader
        /// Every material gets positions, and `fragment`, which reads nothing of it.
        bool positions_only = false;
        Decals decals = Decals::none;
        /// Soft objects fade before what is opaque: the shader has the variant SOFT and reads INPUT_DEPTH_BEHIND.
        bool softens = false;
        /// Blended objects have the decals that lie on them, View::layer_decals(): variant LAYER_DECALS.
        bool layer_decals = false;
        /// Those that are drawn; other than opaque ones one by one, with draw(). Of transmissive ones `vertex` may have
        /// TRANSMISSION.
        resident::DrawClass draws = resident::DrawClass::opaque;
    };
    /// What is bound in a command buffer, so that it is not bound again. One for all SurfaceDraws that
    /// record into a pass in turn.
    struct Bound {
        const gpu::GraphicsPipeline* pipeline = nullptr;
        const gpu::GraphicsPipeline* pushed = nullptr; ///< that record() has pushed constants for
        uint32_t material = no_image;
        VkBuffer indices = VK_NULL_HANDLE;
        std::optional<std::pair<VkCullModeFlags, bool>> faces; ///< those left out; mirrored
    };
    /// Which faces of an object, where its material shows both.
    enum class Faces { all, back, front };
    /// Whether the pass comes after the frame's first one over the geometry: it may leave out what that one hid.
    static bool is_later(gpu::DepthTest depth) {
        return depth == gpu::DepthTest::equal || depth == gpu::DepthTest::behind_or_at;
    }
    SurfaceDraws(const resident::View& view, const graph::PassInterface& interface, const Desc& desc);
    /// Every visible object once, in the draws that the frame's DrawOptions make of them.
    void record(const graph::PassContext& pass, std::span<const std::byte> push = {}) const;
    /// Vertex buffers, before the first draw() of a pass.
    void bind_geometry(const graph::PassContext& pass) const;
    /// One object of Geometry::draws by itself; false, and nothing, where the camera cannot see it, or where the pass
    /// does not draw its kind.
    bool draw(const graph::PassContext& pass, Bound& bound, uint32_t draw, std::span<const std::byte> push = {},
              Faces faces = Faces::all) const;

private:
    /// What chooses a pipeline: the material's shader, and its FEATURE_… bits.
    using Key = std::pair<uint32_t, uint32_t>;
    Key key(const resident::Draw& draw) const;
    bool left_out(const resident::Draw& draw) const;
    void set_shaders(gpu::GraphicsPipelineDesc& pipeline, const Desc& desc, Key key) const;
    bool same_state(const resident::Draw& a, const resident::Draw& b) const;
    /// Where a draw's indices and its command stand.
    struct Source {
        VkBuffer indices = VK_NULL_HANDLE, commands = VK_NULL_HANDLE;
        bool device = false; ///< only the device knows the command
        bool operator==(const Source&) const = default;
    };
    Source source(bool trimmed, bool device_trimmed) const;
    void bind_state(const graph::PassContext& pass, Bound& bound, const resident::Draw& draw, VkBuffer indices,
                    Faces faces = Faces::all) const;
    void draw_indirect(const graph::PassContext& pass, VkBuffer commands, size_t first, size_t end) const;
    void draw_batch(const graph::PassContext& pass, const Source& source, size_t batch) const;
    const resident::View& view_;
    uint32_t features_kept_;
    bool depth_only_, positions_only_;
    bool only_decals_;
    resident::DrawClass class_;
    bool layer_decals_;
    bool later_, counts_, skips_; ///< the pass counts pixels, or leaves out what has none
    std::map<Key, gpu::GraphicsPipeline> pipelines_;
};

/// Says what draws with this depth test read beside attachments; draw_surfaces() does it by itself.
void declare_surfaces(graph::FrameGraph& graph, graph::Pass& pass, const resident::View& view, gpu::DepthTest depth);

/// Makes `pass` draw every object of the frame once.
void draw_surfaces(graph::FrameGraph& graph, graph::Pass& pass, const resident::View& view,
                   const SurfaceDraws::Desc& desc);

} // namespace prelight::passes
