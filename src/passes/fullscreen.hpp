#pragma once
#include <gpu/pipeline.hpp>
#include <graph/frame_graph.hpp>
#include <resident/view.hpp>

namespace prelight::passes {

/// Gives `pass` a full-screen triangle with this fragment shader.
void draw_fullscreen(graph::Pass& pass, const resident::View& view, const gpu::ShaderKey& fragment,
                     const gpu::Constants& constants, gpu::Blend blend = gpu::Blend::none,
                     gpu::DepthTest depth = gpu::DepthTest::none);

} // namespace prelight::passes
