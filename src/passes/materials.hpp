#pragma once
#include "lighting.hpp"

namespace prelight::passes {

struct MaterialInputs {
    graph::ImageId depth;
    LightBuffer light;
    LightModel model;
};

/// Stage 3: every object once more with its own material, depth test EQUAL, light from the light
/// buffer. The result is scene-linear, exposed, RGBA16F.
graph::ImageId material_pass(graph::FrameGraph& graph, const resident::Frame& frame,
                             const MaterialInputs& inputs);

/// The base colour of what is seen, for --view albedo.
graph::ImageId albedo_pass(graph::FrameGraph& graph, const resident::Frame& frame,
                           const MaterialInputs& inputs);

} // namespace prelight::passes
