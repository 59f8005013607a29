#include "materials.hpp"
#include "blended.hpp"
#include "layer_draws.hpp"
#include "resolve.hpp"
#include <shared/bindings.h>
#include <shared/half_samples.h>

namespace prelight::passes {
namespace {

bool is_half(const graph::FrameGraph& graph, graph::ImageId image) {
    return graph.desc(image).format == VK_FORMAT_R16G16B16A16_SFLOAT;
}

/// All but the target as inputs of `pass`; what draws with them.
SurfaceDraws::Desc declare(graph::FrameGraph& graph, graph::Pass& pass, const resident::View& view,
                           const MaterialInputs& inputs, uint32_t output, gpu::Constants constants) {
    pass.depth_test(inputs.depth);
    const bool bits =
        view.context().is_software() && is_half(graph, inputs.light.diffuse) && is_half(graph, inputs.light.specular);
    const auto sample = bits ? &graph::Pass::sample_bits : &graph::Pass::sample;
    (pass.*sample)(INPUT_DIFFUSE_LIGHT, inputs.light.diffuse);
    (pass.*sample)(INPUT_SPECULAR_LIGHT, inputs.light.specular);
    if (inputs.edges) {
        pass.sample(INPUT_SAMPLE_DEPTH, inputs.depth).sample(INPUT_EDGE_FLAGS, inputs.edges->flags);
        (pass.*sample)(INPUT_SAMPLE_DIFFUSE, inputs.sample_light.diffuse);
        (pass.*sample)(INPUT_SAMPLE_SPECULAR, inputs.sample_light.specular);
    }
    if (inputs.lit_surfaces)
        pass.sample(INPUT_SURFACE_IDS, inputs.lit_surfaces->ids)
            .sample(INPUT_LIGHT_DEPTH, inputs.lit_surfaces->depth)
            .storage(INPUT_UNMATCHED, graph.buffer("unmatched pixels", *inputs.unmatched),
                     output == MATERIAL_OUTPUT_SHADED);
    declare_decals(pass, inputs.decals);
    for (const auto& constant : inputs.model.constants())
        constants.push_back(constant);
    constants.emplace_back(CONSTANT_MATERIAL_OUTPUT, output);
    if (inputs.edges)
        for (const auto& constant : inputs.edges->constants())
            constants.push_back(constant);
    const bool ggx = inputs.model.shading == Shading::ggx;
    const bool at_nv = ggx && inputs.model.fresnel != FresnelModel::weighted; // wants the normal once more
    const bool occluded = inputs.visibility.has_value();
    if (occluded)
        pass.sample(INPUT_OCCLUSION, *inputs.visibility);
    const bool all_of_a_point = view.scene().environment() || occluded; // normal and viewer
    using gpu::Variant;
    const gpu::Variants ids = gpu::when(inputs.lit_surfaces.has_value(), Variant::surface_ids);
    const gpu::Variants texels =
        ids | gpu::when(inputs.edges.has_value(), Variant::sample_light) |
        (is_light_pair(graph, inputs.light.diffuse) ? Variant::light_pair : gpu::when(bits, Variant::light_bits));
    const gpu::Variants own = texels | gpu::when(occluded, Variant::occlusion);
    const std::string material = ggx ? "" : "blinn_phong";
    const gpu::ShaderKey whole("material.frag", own | Variant::own_material, ggx ? "metallic_roughness" : material);
    const gpu::ShaderKey lean("material.frag", texels | gpu::when(!at_nv, Variant::only_weighted), material);
    return {.name = "material",
            .fragment = all_of_a_point ? whole : lean,
            .own_fragment = {"material.frag", own},
            .constants = constants,
            .depth = gpu::DepthTest::equal,
            .keeps_alpha_mask = false,
            .vertex = ids | gpu::when(!at_nv && !all_of_a_point, Variant::no_world | Variant::no_normal) |
                      gpu::when(!all_of_a_point, Variant::no_textures),
            .sample_shading = inputs.sample_shading,
            .post_depth_coverage = inputs.edges.has_value(),
            .decals = decal_use(inputs.decals)};
}

void draw(graph::FrameGraph& graph, const resident::View& view, const MaterialInputs& inputs, const std::string& name,
          graph::ImageId target, uint32_t output, Display display = {}) {
    graph::Pass& pass = graph.pass(name);
    pass.colour(target, graph::Load::clear, {0, 0, 0, display ? 1.0f : 0.0f});
    draw_surfaces(graph, pass, view,
                  declare(graph, pass, view, inputs, output, display_constants(display, graph.desc(target).format)));
}

/// For what is blended.
MaterialInputs without_what_lies_on_opaque(MaterialInputs inputs) {
    inputs.decals = {};
    inputs.visibility = {};
    return inputs;
}

void draw_over(graph::FrameGraph& graph, const resident::View& view, MaterialInputs inputs, const resident::View& slots,
               const std::string& name, graph::ImageId target, uint32_t output, uint64_t* drawn = nullptr) {
    inputs = without_what_lies_on_opaque(std::move(inputs));
    graph::Pass& pass = graph.pass(name);
    pass.colour(target, graph::Load::keep).blends();
    SurfaceDraws::Desc desc =
        declare(graph, pass, view, inputs, output, display_constants({}, graph.desc(target).format));
    desc.name = name;
    desc.depth = gpu::DepthTest::behind_or_at;
    desc.blend = gpu::Blend::by_alpha;
    desc.layer_decals = view.layer_decals() != nullptr;
    desc.softens = view.scene().softens();
    if (desc.softens)
        pass.sample(INPUT_DEPTH_BEHIND, inputs.depth);
    for (gpu::ShaderKey* shader : {&desc.fragment, &desc.own_fragment})
        shader->variants |= gpu::Variant::layer;
    draw_layers(pass, view, std::move(desc), slots, drawn);
}

/// Of a view, which shows what is opaque.
Resolved resolved(const MaterialInputs& inputs) { return inputs.half_samples ? Resolved::opaque : Resolved::all; }

} // namespace

graph::ImageId material_pass(graph::FrameGraph& graph, const resident::View& view, const MaterialInputs& inputs,
                             Display display) {
    const graph::ImageId target = picture_image(graph, view, view.surface_raster(), display);
    draw(graph, view, inputs, "material", target, MATERIAL_OUTPUT_SHADED, display);
    return target;
}

void blended_material_pass(graph::FrameGraph& graph, const resident::View& view, const MaterialInputs& inputs,
                           const std::string& name, graph::ImageId target, uint64_t* drawn) {
    graph::Pass& pass = graph.pass(name);
    pass.colour(target, graph::Load::keep).blends();
    SurfaceDraws::Desc desc =
        declare(graph, pass, view, inputs, MATERIAL_OUTPUT_SHADED, display_constants({}, graph.desc(target).format));
    desc.blend = gpu::Blend::by_alpha;
    desc.draws = resident::DrawClass::blended;
    draw_blended(pass, view, desc, BlendedOrder::layer, drawn);
}

void half_material_pass(graph::FrameGraph& graph, const resident::View& view, MaterialInputs inputs,
                        graph::ImageId target, uint64_t* drawn) {
    inputs = without_what_lies_on_opaque(std::move(inputs));
    graph::Pass& pass = graph.pass("blended");
    pass.colour(target, graph::Load::keep);
    gpu::Constants constants = display_constants({}, graph.desc(target).format);
    constants.emplace_back(CONSTANT_HALF_SAMPLES, true);
    SurfaceDraws::Desc desc = declare(graph, pass, view, inputs, MATERIAL_OUTPUT_SHADED, std::move(constants));
    desc.name = pass.name();
    desc.sample_mask = HALF_SAMPLES_BLENDED;
    desc.sample_shading = gpu::SampleShading::sample; // as half_surfaces_pass() drew them
    desc.draws = resident::DrawClass::blended;
    draw_blended(pass, view, desc, BlendedOrder::layer, drawn);
}

graph::ImageId light_sum_pass(graph::FrameGraph& graph, const resident::View& view, const MaterialInputs& inputs,
                              bool specular) {
    const char* name = specular ? "specular-sum" : "diffuse-sum";
    const graph::ImageId target = graph.image(name, {VK_FORMAT_R32G32B32A32_SFLOAT, view.surface_raster()});
    draw(graph, view, inputs, name, target, specular ? MATERIAL_OUTPUT_SPECULAR_SUM : MATERIAL_OUTPUT_DIFFUSE_SUM);
    return resolve_pass(graph, view, target, resolved(inputs));
}

void clear_unmatched_pass(graph::FrameGraph& graph, const gpu::Buffer& unmatched) {
    graph.pass("material counts")
        .copy_to(graph.buffer("unmatched pixels", unmatched))
        .record([&unmatched](const graph::PassContext& context) {
            vkCmdFillBuffer(context.commands, unmatched.handle(), 0, VK_WHOLE_SIZE, 0);
        });
}

void layer_pass(graph::FrameGraph& graph, const resident::View& view, MaterialInputs inputs,
                const resident::View& slots, graph::ImageId target, uint64_t* drawn) {
    draw_over(graph, view, std::move(inputs), slots, "blended layers", target, MATERIAL_OUTPUT_SHADED, drawn);
}

graph::ImageId unmatched_view_pass(graph::FrameGraph& graph, const resident::View& view, const MaterialInputs& inputs,
                                   const resident::View* slots) {
    const graph::ImageId target = graph.image("unmatched", {VK_FORMAT_R16G16B16A16_SFLOAT, view.surface_raster()});
    draw(graph, view, inputs, "unmatched", target, MATERIAL_OUTPUT_UNMATCHED);
    if (slots)
        draw_over(graph, view, inputs, *slots, "unmatched layers", target, MATERIAL_OUTPUT_UNMATCHED);
    return target;
}

graph::ImageId albedo_pass(graph::FrameGraph& graph, const resident::View& view, const MaterialInputs& inputs) {
    const graph::ImageId target = graph.image("albedo", {VK_FORMAT_R16G16B16A16_SFLOAT, view.surface_raster()});
    draw(graph, view, inputs, "albedo", target, MATERIAL_OUTPUT_ALBEDO);
    return resolve_pass(graph, view, target, resolved(inputs));
}

} // namespace prelight::passes
