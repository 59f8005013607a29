#include "materials.hpp"
#include "surface_draws.hpp"
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

graph::ImageId draw(graph::FrameGraph& graph, const resident::Frame& frame, const MaterialInputs& inputs,
                    const char* name, uint32_t output, VkFormat format = VK_FORMAT_R16G16B16A16_SFLOAT) {
    const graph::ImageId target = graph.image(name, {format, frame.extent()});
    graph::Pass& pass = graph.pass(output == MATERIAL_OUTPUT_SHADED ? "material" : name);
    pass.colour(target, graph::Load::clear)
        .depth_test(inputs.depth)
        .sample(INPUT_DIFFUSE_LIGHT, inputs.light.diffuse)
        .sample(INPUT_SPECULAR_LIGHT, inputs.light.specular);
    gpu::Constants constants = inputs.model.constants();
    constants.emplace_back(CONSTANT_MATERIAL_OUTPUT, output);
    const std::string shader = inputs.model.shading == Shading::ggx ? "material_metallic_roughness.frag"
                                                                    : "material_blinn_phong.frag";
    draw_surfaces(pass, frame,
                  {.name = "material",
                   .fragment = shader,
                   .constants = constants,
                   .depth = gpu::DepthTest::equal,
                   .keeps_alpha_mask = false});
    return target;
}

} // namespace

graph::ImageId material_pass(graph::FrameGraph& graph, const resident::Frame& frame,
                             const MaterialInputs& inputs) {
    return draw(graph, frame, inputs, "linear", MATERIAL_OUTPUT_SHADED);
}

graph::ImageId light_sum_pass(graph::FrameGraph& graph, const resident::Frame& frame,
                              const MaterialInputs& inputs, bool specular) {
    return draw(graph, frame, inputs, specular ? "specular-sum" : "diffuse-sum",
                specular ? MATERIAL_OUTPUT_SPECULAR_SUM : MATERIAL_OUTPUT_DIFFUSE_SUM,
                VK_FORMAT_R32G32B32A32_SFLOAT);
}

graph::ImageId albedo_pass(graph::FrameGraph& graph, const resident::Frame& frame,
                           const MaterialInputs& inputs) {
    return draw(graph, frame, inputs, "albedo", MATERIAL_OUTPUT_ALBEDO);
}

} // namespace prelight::passes
