#include "lit_layers.hpp"
#include "blended.hpp"
#include "light_pass.hpp"
#include <shared/bindings.h>

namespace prelight::passes {

LitLayers::LitLayers(graph::FrameGraph& graph, const resident::View& view, const Inputs& inputs)
    : inputs_(inputs), format_{.depth = DepthSource::r32f, .specular_antialiasing = inputs.specular_antialiasing},
      normal_(graph.image("layer normal", {VK_FORMAT_R8G8B8A8_UNORM, view.raster()})),
      // The layer's depth itself is 1 where it is empty, and lights look for 0.
      linear_depth_(graph.image("layer linear depth", {VK_FORMAT_R32_SFLOAT, view.raster()})),
      light_(make_light_buffer(graph, view, inputs.model, !inputs.wide && compute_walks(view, inputs.lists.shading),
                               inputs.wide)) {
    light_.target.lit_before = std::make_shared<gpu::Buffer>();
}

void LitLayers::add(graph::FrameGraph& graph, const resident::View& view, const std::string& name, graph::ImageId depth,
                    graph::ImageId colour, uint64_t* drawn) {
    graph::Pass& pass = graph.pass(name + " normal");
    pass.colour(normal_, graph::Load::clear).colour(linear_depth_, graph::Load::clear).depth_test(depth);
    draw_blended(pass, view,
                 {.name = "layer normal",
                  .fragment = {"depth_normal.frag", gpu::Variant::depth_target},
                  .constants = format_.constants(),
                  .depth = gpu::DepthTest::equal,
                  .keeps_alpha_mask = false,
                  .vertex = gpu::Variant::no_textures,
                  .draws = resident::DrawClass::blended});
    LightingInputs lighting{.surface = {format_, depth, linear_depth_, normal_, normal_},
                            .model = inputs_.model,
                            .target = light_.target,
                            .shadows = inputs_.shadows,
                            .pair_counters = inputs_.pair_counters,
                            .count_pairs = inputs_.count_pairs,
                            .write_once = true};
    lighting.lists = screen_light_lists(graph, view, name + " light", lighting, inputs_.lists);
    light_pass(graph, view, name + " light", lighting);
    blended_material_pass(graph, view, {.depth = depth, .light = light_, .model = inputs_.model}, name, colour, drawn);
}

} // namespace prelight::passes
