#include "lighting.hpp"
#include <fmt/format.h>
#include <shared/bindings.h>

namespace prelight::passes {

namespace {

/// The next format is taken where the device cannot draw into one, or not blend in it.
graph::ImageId target(graph::FrameGraph& graph, const gpu::Context& context, const gpu::Raster& raster,
                      const std::string& name, LightBufferFormat format, bool wide) {
    if (wide)
        return graph.image(name, {VK_FORMAT_R32G32B32A32_SFLOAT, raster});
    switch (format) {
    case LightBufferFormat::r11g11b10f:
        if (context.supports(VK_FORMAT_B10G11R11_UFLOAT_PACK32, VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT))
            return graph.image(name, {VK_FORMAT_B10G11R11_UFLOAT_PACK32, raster});
        graph.note(fmt::format("{}: R11G11B10F does not blend on {}, RGBA16F is taken", name, context.name()));
        break;
    case LightBufferFormat::rgb10a2:
        return graph.image(name, raster, {VK_FORMAT_A2B10G10R10_UNORM_PACK32, VK_FORMAT_R8G8B8A8_UNORM});
    case LightBufferFormat::rgba8:
    case LightBufferFormat::packed_rgba8: return graph.image(name, {VK_FORMAT_R8G8B8A8_UNORM, raster});
    case LightBufferFormat::rgba16f:
    case LightBufferFormat::packed_rgba16f: break;
    }
    return graph.image(name, {VK_FORMAT_R16G16B16A16_SFLOAT, raster});
}

/// What the shader rounds to.
uint32_t storage_of(VkFormat format) {
    switch (format) {
    case VK_FORMAT_R8G8B8A8_UNORM: return STORAGE_UNORM8;
    case VK_FORMAT_A2B10G10R10_UNORM_PACK32: return STORAGE_UNORM10;
    case VK_FORMAT_B10G11R11_UFLOAT_PACK32: return STORAGE_FLOAT11;
    default: return STORAGE_FLOAT16;
    }
}

} // namespace

bool is_pair_of_halves(const LightModel& model) {
    return model.buffer == LightBufferFormat::rgba16f && model.specular != SpecularWay::fifth_channel;
}

bool is_light_pair(const graph::FrameGraph& graph, graph::ImageId image) {
    return graph.desc(image).format == VK_FORMAT_R32G32B32A32_UINT;
}

LightBuffer make_light_buffer(graph::FrameGraph& graph, const resident::View& view, const LightModel& model, bool pair,
                              bool wide, const SampleEdges* edges) {
    const bool both = edges && edges->lies_beneath();
    const gpu::Raster raster = both ? edges->whole_raster(view) : edges ? edges->raster : view.raster();
    const std::string of = edges && !both ? "sample " : "";
    LightBuffer out;
    if (pair) {
        out.diffuse = out.specular = graph.image(of + "light", {VK_FORMAT_R32G32B32A32_UINT, raster});
        out.target = {.variant = gpu::Variant::light_pair,
                      .images = {out.diffuse},
                      .constants = {{CONSTANT_LIGHT_STORAGE, STORAGE_FLOAT16}}};
        return out;
    }
    wide = wide && !model.fixed_point();
    out.diffuse = out.specular = target(graph, view.context(), raster, of + "diffuse light", model.buffer, wide);
    out.target.images = {out.diffuse};
    out.target.constants = {{CONSTANT_LIGHT_STORAGE, storage_of(graph.desc(out.diffuse).format)}};
    if (model.specular == SpecularWay::fifth_channel)
        out.specular = graph.image(of + "fifth channel", {model.fixed_point() ? VK_FORMAT_R8_UNORM
                                                          : wide              ? VK_FORMAT_R32_SFLOAT
                                                                              : VK_FORMAT_R16_SFLOAT,
                                                          raster});
    else if (model.packed())
        out.target.variant = gpu::Variant::one_target;
    else
        out.specular = target(graph, view.context(), raster, of + "specular light", model.buffer, wide);
    if (out.specular != out.diffuse)
        out.target.images.push_back(out.specular);
    return out;
}

graph::ImageId light_count_image(graph::FrameGraph& graph, const resident::View& view, graph::ImageId depth,
                                 bool stored) {
    const auto can = [&](VkFormat format) {
        return view.context().supports(format, stored ? VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT
                                                      : VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT);
    };
    const VkFormat wider = stored ? VK_FORMAT_R32G32B32A32_SFLOAT : VK_FORMAT_R16G16B16A16_SFLOAT;
    return graph.image("light count",
                       {can(VK_FORMAT_R32G32_SFLOAT) ? VK_FORMAT_R32G32_SFLOAT : wider, graph.raster(depth)});
}

LightTarget make_light_counts(graph::FrameGraph& graph, const resident::View& view, graph::ImageId depth, bool stored) {
    return {.variant = gpu::Variant::count_target, .images = {light_count_image(graph, view, depth, stored)}};
}

void declare_lighting(graph::FrameGraph& graph, graph::Pass& pass, const LightingInputs& inputs) {
    for (const graph::ImageId image : inputs.target.images)
        pass.colour(image, inputs.target.load);
    declare_lit_surface(graph, pass, inputs);
}

void declare_lit_surface(graph::FrameGraph& graph, graph::Pass& pass, const LightingInputs& inputs) {
    if (inputs.edges)
        pass.storage(INPUT_EDGE_PIXELS, inputs.edges->pixels, false)
            .storage(INPUT_LIT_BLOCKS, inputs.edges->tiles, false);
    pass.raster(graph.raster(inputs.surface.depth))
        .sample(INPUT_DEPTH, inputs.surface.depth_source)
        .sample(INPUT_NORMAL, inputs.surface.normal)
        .storage(INPUT_PAIR_COUNTERS, graph.buffer("pair counters", *inputs.pair_counters), inputs.count_pairs);
    if (inputs.surface.format.roughness_in_stencil)
        pass.sample_stencil(INPUT_ROUGHNESS, inputs.surface.depth);
    else
        pass.sample(INPUT_ROUGHNESS, inputs.surface.roughness);
    if (inputs.target.deferred())
        pass.sample(INPUT_MATERIAL, inputs.material).sample(INPUT_ALBEDO, inputs.albedo);
    if (inputs.target.deferred() && inputs.edges && !inputs.target.added) // else it is there already
        pass.sample(INPUT_COLOUR_BEFORE, inputs.own_light);
    if (!inputs.target.counts())
        declare_shadows(pass, inputs.shadows);
    if (inputs.edges && inputs.shadows) { // bound in any case; else nothing is read there
        const auto& at = inputs.shadows_at;
        pass.sample(INPUT_PIXEL_DEPTH, at ? at->depth_source : inputs.shadows.transmittance)
            .sample(INPUT_PIXEL_NORMAL, at ? at->normal : inputs.shadows.transmittance);
    }
}

gpu::ShaderKey lighting_shader(const LightingInputs& inputs, const char* file) {
    return {file, inputs.target.variant | gpu::when(inputs.target.added, gpu::Variant::added) |
                      gpu::when(!inputs.target.counts(), shadow_variant(inputs.shadows)) |
                      gpu::when(inputs.edges.has_value(), gpu::Variant::samples) |
                      gpu::when(inputs.surface.format.roughness_in_stencil, gpu::Variant::stencil_roughness)};
}

void add_light_constants(gpu::Constants& constants, const resident::View& view) {
    constants.emplace_back(CONSTANT_LIGHT_KINDS, view.lights().kinds());
    constants.emplace_back(CONSTANT_LIGHTS_AS_TEXELS, view.context().features().fast_texel_buffers);
    add_shadow_constants(constants, view);
}

gpu::Constants lighting_constants(const resident::View& view, const LightingInputs& inputs) {
    gpu::Constants constants = inputs.surface.format.constants();
    for (const gpu::Constants& more : {inputs.model.constants(), inputs.target.constants})
        constants.insert(constants.end(), more.begin(), more.end());
    constants.emplace_back(CONSTANT_COUNT_PAIRS, inputs.count_pairs);
    add_light_constants(constants, view);
    if (inputs.edges)
        for (const auto& constant : inputs.edges->constants())
            constants.push_back(constant);
    if (inputs.shadows_at && inputs.shadows)
        constants.emplace_back(CONSTANT_SHADOWS_AT_PIXEL, true);
    if (inputs.lists)
        for (const auto& constant : light_list_constants(*inputs.lists))
            constants.push_back(constant);
    return constants;
}

gpu::GraphicsPipelineDesc lighting_pipeline(const resident::View& view, const graph::PassInterface& interface,
                                            const LightingInputs& inputs, const char* fragment) {
    gpu::GraphicsPipelineDesc desc;
    desc.fragment = lighting_shader(inputs, fragment);
    desc.constants = lighting_constants(view, inputs);
    desc.attachments = interface.attachments;
    desc.sets = {view.layout(), interface.inputs};
    return desc;
}

} // namespace prelight::passes
