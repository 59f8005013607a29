#pragma once
#include <gpu/shader_stage.hpp>
#include <graph/frame_graph.hpp>
#include <memory>
#include <resident/view.hpp>

namespace prelight::passes {

inline constexpr VkFormat shadow_format = VK_FORMAT_D32_SFLOAT;
inline constexpr VkFormat transmittance_format = VK_FORMAT_R16G16B16A16_SFLOAT;
inline constexpr VkFormat extremes_format = VK_FORMAT_R32G32_SFLOAT;

struct ShadowCounts;
struct HeldMaps;
/// What a pass that evaluates lights needs to know of shadows; default: there are none.
struct Shadows {
    graph::ImageId atlas{}; ///< depth of all tiles: resident::ShadowPlan says which lies where
    /// Beside it, of blended surfaces: the share of light that they leave, and the depth of the nearest to the light
    /// (TransparentShadows::filtered); else of one texel, which nothing is read from.
    graph::ImageId transmittance{};
    /// Of its cells: shadow_extremes_pass(). Of one texel where lookups do not ask.
    graph::ImageId extremes{};
    ShadowCounts* counts = nullptr;
    std::shared_ptr<HeldMaps> held = nullptr; ///< which maps both hold, for all who draw into them
    /// The passes themselves draw each light's maps before the light, into the same memory for all of them
    /// (shadow-memory=reuse, Lee's way).
    bool reused = false;
    /// The shadow of resident::ShadowPlan::sun() waits in the G-buffer: sun_occlusion_pass().
    bool sun_stored = false;
    explicit operator bool() const { return bool(atlas); }
};

/// What the last frame drew, written when it is recorded.
struct ShadowCounts {
    uint64_t tiles_drawn = 0, tiles_reused = 0, casters_drawn = 0;
};

/// Shadow maps: a pass "shadows" that draws the tiles of View::shadows() into one depth image, each with the
/// casters that its light may see. Both faces of every triangle cast, masked ones where they are not masked out.
/// A tile that the image holds already is left as it is. Blended surfaces cast as TransparentShadows says; with
/// `filtered`, and where there are any, a pass "transparent shadows" draws them into an image of their own. With
/// ShadowOptions::reuse there is no such pass: see Shadows::reused. With ShadowFilter::pcf "shadow extremes"
/// follows them. Nothing without shadows. `counts` lives as long as the graph.
Shadows shadow_pass(graph::FrameGraph& graph, const resident::View& view, ShadowCounts& counts);

/// Makes `pass` read the atlas; nothing without shadows.
void declare_shadows(graph::Pass& pass, const Shadows& shadows);
/// Adds the constants of shaders that are compiled with SHADOWS.
void add_shadow_constants(gpu::Constants& constants, const resident::View& view);
/// What such a shader is compiled with.
gpu::Variants shadow_variant(const Shadows& shadows);

} // namespace prelight::passes
