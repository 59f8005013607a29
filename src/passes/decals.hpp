#pragma once
#include "depth_normal.hpp"
#include "gbuffer.hpp"
#include "surface_draws.hpp"

namespace prelight::passes {

/// What decals make of the surfaces that are seen; none where the world has no decals. Half floats; the last channel
/// of the first three is the share of the surface's own value that is left:
///     base colour = own · colour.a + colour.rgb       normal = normalize(own · normal.a + normal.rgb)
///     metallic    = own · colour.a + metallic.r       roughness = own · roughness.g + roughness.r
struct DecalBuffer {
    graph::ImageId colour{}, normal{}, roughness{}, metallic{};
    explicit operator bool() const { return bool(colour); }
};

/// A pass "decals": every decal's box over the surfaces that lie in it, lowest first. It reads depth and normals.
DecalBuffer decal_pass(graph::FrameGraph& graph, const resident::View& view, const SurfaceBuffers& surface);

/// Makes `pass` read the buffer; nothing without one. Its draws are SurfaceDraws with Desc::decals = decal_use().
void declare_decals(graph::Pass& pass, const DecalBuffer& decals);
inline SurfaceDraws::Decals decal_use(const DecalBuffer& decals) {
    return decals ? SurfaceDraws::Decals::read : SurfaceDraws::Decals::none;
}

/// A pass "decal-normal": objects that decals reach once more into the targets of normals and roughness.
/// Nothing without a buffer.
void decal_normal_pass(graph::FrameGraph& graph, const resident::View& view, const SurfaceBuffers& surface,
                       const DecalBuffer& decals);

/// A pass "decal-geometry": those objects once more into a G-buffer, before lights are added. Nothing without a buffer.
void decal_geometry_pass(graph::FrameGraph& graph, const resident::View& view, const GBuffer& gbuffer,
                         const DecalBuffer& decals);

/// For architectures without a buffer of normals: depth and normals by a pass of their own, and the decals on them;
/// nothing where the world has none.
DecalBuffer decals_of_own(graph::FrameGraph& graph, const resident::View& view);

} // namespace prelight::passes
