#include "lighting.hpp"
#include <shared/bindings.h>

namespace prelight::passes {

LightBuffer make_light_buffer(graph::FrameGraph& graph, const resident::Frame& frame, const LightModel& model) {
    const bool bytes = model.buffer == LightBufferFormat::packed_rgba8;
    const VkFormat format = bytes ? VK_FORMAT_R8G8B8A8_UNORM : VK_FORMAT_R16G16B16A16_SFLOAT;
    LightBuffer out;
    out.diffuse = out.specular = graph.image("diffuse light", {format, frame.extent()});
    out.target.images = {out.diffuse};
    if (model.packed()) {
        out.target.variant = "+packed";
    } else {
        out.specular = graph.image("specular light", {format, frame.extent()});
        out.target.images.push_back(out.specular);
    }
    return out;
}

LightTarget make_light_counts(graph::FrameGraph& graph, const resident::Frame& frame) {
    return {.variant = "+count",
            .images = {graph.image("light count", {VK_FORMAT_R16G16B16A16_SFLOAT, frame.extent()})}};
}

void declare_lighting(graph::FrameGraph& graph, graph::Pass& pass, const LightingInputs& inputs) {
    for (const graph::ImageId image : inputs.target.images)
        pass.colour(image, inputs.target.load);
    pass.sample(INPUT_DEPTH, inputs.surface.depth_source)
        .sample(INPUT_NORMAL, inputs.surface.normal)
        .sample(INPUT_ROUGHNESS, inputs.surface.roughness)
        .storage(INPUT_PAIR_COUNTERS, graph.buffer("pair counters", *inputs.pair_counters), inputs.count_pairs);
}

gpu::GraphicsPipelineDesc lighting_pipeline(const resident::Frame& frame, const graph::PassInterface& interface,
                                            const LightingInputs& inputs, const std::string& shader) {
    gpu::GraphicsPipelineDesc desc;
    desc.fragment = shader + inputs.target.variant + ".frag";
    desc.constants = inputs.surface.format.constants();
    const gpu::Constants model = inputs.model.constants();
    desc.constants.insert(desc.constants.end(), model.begin(), model.end());
    desc.constants.insert(desc.constants.end(), {{CONSTANT_COUNT_PAIRS, inputs.count_pairs},
                                                 {CONSTANT_SEED_FALLOFF, frame.seed_falloff()}});
    desc.colour_formats = interface.colour_formats;
    desc.depth_format = interface.depth_format;
    desc.stencil_format = interface.stencil_format;
    desc.sets = {frame.layout(), interface.inputs};
    return desc;
}

} // namespace prelight::passes
