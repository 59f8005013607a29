#pragma once
#include "gbuffer.hpp"

namespace prelight::passes {

// Transparency in half of a pixel's samples: what is blended is drawn as if it were opaque, the nearest surface of it,
// into two of four samples (shaders/shared/half_samples.h). It has depth, normal and light of its own there, and
// resolving the picture lays it over what the other two show. After a remark in the discussion of Quandt's "Light
// Pre-Pass Round 2": LittleBigPlanet got a layer out of the samples of 2× multisampling.

/// A pass "blended surfaces": depth, normal and roughness of the nearest blended surface before what `surface` holds,
/// in the samples that are its. `surface` has four samples a pixel and reads depth from the attachment.
void half_surfaces_pass(graph::FrameGraph& graph, const resident::View& view, const SurfaceBuffers& surface);

/// The same of a G-buffer, all its targets.
void half_geometry_pass(graph::FrameGraph& graph, const resident::View& view, const GBuffer& gbuffer);

/// A pass "blended coverage" for a picture whose light comes from that G-buffer: their alpha, as the resolve reads it.
/// `drawn`: set to the number of draws when it is recorded.
void half_coverage_pass(graph::FrameGraph& graph, const resident::View& view, const GBuffer& gbuffer,
                        graph::ImageId picture, uint64_t* drawn);

} // namespace prelight::passes
