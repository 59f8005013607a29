// Light pre-pass (Engel, ShaderX7 8.5; Lee's prelighting; Quandt's Round 2): depth and normals, then
// all lights into the light buffer, then every object once more with its own material.
#include "light_prepass.hpp"
#include "light_buffer_renderer.hpp"
#include "settings/draw_settings.hpp"
#include "settings/light_culling_settings.hpp"
#include "settings/light_model_settings.hpp"
#include "settings/light_prepass_presets.hpp"
#include "settings/occlusion_settings.hpp"
#include "settings/sample_settings.hpp"
#include "settings/shadow_settings.hpp"
#include "settings/texture_settings.hpp"
#include "settings/transparency_settings.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <gpu/context.hpp>
#include <passes/decals.hpp>
#include <passes/depth_only.hpp>
#include <passes/forward.hpp>
#include <passes/half_samples.hpp>
#include <passes/view.hpp>
#include <prelight/error.hpp>

namespace prelight {
namespace {

enum class FewLights { light_buffer, forward };
constexpr Choice<FewLights> few_lights_words[] = {{"light-buffer", FewLights::light_buffer},
                                                  {"forward", FewLights::forward}};
constexpr ChoiceSetting<FewLights> few_lights_setting{
    "few-lights", few_lights_words, "light-buffer",
    "up to eight lights: as more are, or forward: by materials, after depth alone, without a light buffer"};

passes::SurfaceFormat surface_format(const Settings& settings) {
    return {.normals = passes::find_normal_encoding(settings.get("normals")).encoding,
            .view_space = settings.is("normal-space", "view"),
            .depth = passes::find_depth_source(settings.get("depth")).source,
            .stencil = settings.is("light-culling", "stencil") || settings.is("roughness", "stencil"),
            .roughness_in_stencil = settings.is("roughness", "stencil"),
            .position_from_ray = settings.is("position", "ray"),
            .two_passes = settings.is("geometry", "two-passes"),
            .specular_antialiasing = settings.is("specular-antialiasing", "on")};
}

/// The first way to a specular power of the material's own, in stencil, where the device's fragments can write it and
/// lights do not.
void choose_roughness(Settings& settings, const Device& device) {
    if (!settings.is("roughness", "stencil"))
        return;
    if (settings.is("light-culling", "stencil"))
        throw UsageError(
            "--set roughness=stencil: light-culling=stencil marks lights there (any other value does not)");
    if (dynamic_cast<const gpu::Context&>(device).features().stencil_export)
        return;
    settings.fall_back("roughness", "normal",
                       device.name() + " has no VK_EXT_shader_stencil_export that can be relied on");
}

class LightPrepass final : public LightBufferRenderer {
public:
    using LightBufferRenderer::LightBufferRenderer;

private:
    resident::ViewSettings view_settings() const override {
        resident::ViewSettings view = DeviceRenderer::view_settings();
        add_light_settings(view);
        return view;
    }

    LayerLight layer_light(graph::FrameGraph& graph, const resident::View& view) override {
        const passes::ScreenListOptions lists = screen_list_options(settings());
        if (!fills_light_buffer(view))
            return {.obstacle = "there is none of opaque surfaces"};
        if (!resident::builds_lists(view.culling()))
            return {.obstacle = "light-culling=" + settings().get("light-culling") + " lists no lights of a layer"};
        if (view.surface_raster().samples > 1)
            return {.obstacle = "each pixel has several samples"};
        if (!passes::is_pair_of_halves(model()) || model().specular != passes::SpecularWay::stored ||
            model().ambient_as_light || lists.contents != passes::ListContents::built)
            return {.obstacle = "the light buffer is not as surfaces in front of others need it"};
        return {passes::LitLayers::Inputs{.model = model(),
                                          .specular_antialiasing = settings().is("specular-antialiasing", "on"),
                                          .shadows = shadows(graph, view),
                                          .pair_counters = &pair_counters(),
                                          .count_pairs = options().count_pairs,
                                          .wide = light_sums().wide(),
                                          .lists = lists}};
    }

    /// Whether anything but lights and the materials themselves asks what the surfaces are like, or for a light buffer.
    bool needs_surfaces(const resident::View& view) const {
        const auto shows_surfaces = [](const std::string& name) { return name != "final" && name != "linear"; };
        return own_passes().any_before_materials() || model().fixed_point() || occludes() || reuses_shadows(view) ||
               blended().in_half_samples() || !view.scene().decals().empty() ||
               settings().is("antialiasing", "edge-blur") || std::ranges::any_of(options().views, shows_surfaces);
    }

    static bool reuses_shadows(const resident::View& view) { return view.shadows() && view.shadows()->options().reuse; }

    /// Whether materials walk so many lights themselves, where nothing needs surfaces.
    bool walks_in_materials(size_t lights) const {
        return settings().value(few_lights_setting) == FewLights::forward && lights <= FORWARD_MOST_LIGHTS;
    }

    bool fills_light_buffer(const resident::View& view) const {
        return needs_surfaces(view) || (has_light(view) && !walks_in_materials(view.lights().placed().size()));
    }

    bool draws_as_many(size_t before, size_t lights) const override {
        return walks_in_materials(before) == walks_in_materials(lights);
    }

    /// Depth and materials: no light, no light buffer to fill, nobody to read normals. A picture of a file without
    /// lights, under its environment, then waits for four pipelines instead of a dozen.
    Outputs build_unlit(graph::FrameGraph& graph, const resident::View& view) {
        const passes::SurfaceBuffers drawn = passes::depth_only_surfaces(graph, view);
        const passes::MaterialInputs materials{.depth = drawn.depth,
                                               .light = black_light(graph, view),
                                               .model = model(),
                                               .sample_shading = material_shading(settings())};
        return picture_outputs(graph, view, drawn, [&](passes::Display display) {
            return passes::material_pass(graph, view, materials, display);
        });
    }

    /// Depth, and materials that walk all lights: for so few that filling a light buffer is the larger part of its
    /// cost.
    Outputs build_few_lights(graph::FrameGraph& graph, const resident::View& view) {
        const passes::SurfaceBuffers drawn = passes::depth_only_surfaces(graph, view);
        passes::ForwardInputs inputs{.name = "material and lights", .depth = drawn.depth, .model = model()};
        inputs.model.specular_antialiasing = settings().is("specular-antialiasing", "on");
        inputs.shadows = shadows(graph, view);
        inputs.pair_counters = &pair_counters();
        inputs.count_pairs = options().count_pairs;
        inputs.sample_shading = material_shading(settings());
        return picture_outputs(graph, view, drawn, [&](passes::Display display) {
            inputs.colour = passes::picture_image(graph, view, view.surface_raster(), display);
            inputs.display = display;
            passes::forward_few_pass(graph, view, inputs);
            return inputs.colour;
        });
    }

    Outputs build(graph::FrameGraph& graph, const resident::View& view) override {
        if (!fills_light_buffer(view))
            return has_light(view) ? build_few_lights(graph, view) : build_unlit(graph, view);
        if (has_light(view) && walks_in_materials(view.lights().placed().size()))
            graph.note(
                "few-lights=forward: with decals, ssao, edge-blur, half-samples, shadow-memory=reuse, other views "
                "than final and linear, and passes of the program's own before materials, lights fill a light "
                "buffer");
        const auto drawn = passes::depth_normal_pass(graph, view, surface_format(settings()));
        const auto decals = passes::decal_pass(graph, view, drawn);
        passes::decal_normal_pass(graph, view, drawn, decals);
        own_passes(vulkan::Stage::after_surfaces, graph, view, drawn);
        const bool halves = blended().in_half_samples();
        if (halves) {
            blended().count_layers(graph, view, drawn.depth);
            passes::half_surfaces_pass(graph, view, drawn);
        }
        const passes::SampledSurfaces surfaces = sampled(graph, view, drawn);
        const LightStage stage = light_stage(graph, view, surfaces);
        own_passes_after_light(graph, view, surfaces.pixels, stage.light);
        passes::MaterialInputs materials{.depth = drawn.depth,
                                         .light = stage.light,
                                         .model = model(),
                                         .decals = decals,
                                         .sample_shading = material_shading(settings()),
                                         .edges = stage.edges,
                                         .sample_light = stage.sample_light,
                                         .half_samples = halves};
        const auto visibility = this->visibility(graph, view, surfaces.pixels);
        if (occludes())
            materials.visibility = visibility;
        Outputs outputs = picture_outputs(graph, view, drawn, [&](passes::Display display) {
            const graph::ImageId picture = passes::material_pass(graph, view, materials, display);
            if (halves)
                passes::half_material_pass(graph, view, materials, picture, blended().count_draws());
            return picture;
        });
        add_light_views(outputs, graph, view, stage, visibility);
        add_material_views(outputs, graph, view, surfaces.pixels, materials);
        add_surface_samples(outputs, graph, view, drawn);
        if (wants("edges"))
            outputs["edges"] = passes::edges_view_pass(graph, view, surfaces);
        return outputs;
    }
};

} // namespace

RendererInfo light_prepass_info() {
    std::vector<std::string> normals, depths;
    for (const passes::NormalEncodingInfo& encoding : passes::normal_encodings())
        normals.emplace_back(encoding.name);
    for (const passes::DepthSourceInfo& source : passes::depth_sources())
        depths.emplace_back(source.name);
    RendererInfo info{
        .name = "light-prepass",
        .description = "depth and normals, then all lights into a light buffer, then materials",
        .settings =
            {{"normals", normals, normals[0], "encoding of the normal buffer"},
             {"normal-space", {"world", "view"}, "world", "space of the stored normals"},
             {"roughness",
              {"normal", "stencil"},
              "normal",
              "where lights find a surface's roughness or specular power: stored with its normal, or in stencil"},
             {"depth", depths, depths[0],
              "what later passes read depth from: the attachment, or view depth in a colour target"},
             {"geometry", {"mrt", "two-passes"}, "mrt", "depth and normals at once, or depth first and then normals"},
             {"position", {"ray", "matrix"}, "ray", "position from depth: frustum ray or inverse matrix"},
             specular_antialiasing_setting(),
             msaa_light_setting(true),
             msaa_shadows_setting(),
             msaa_material_setting(),
             light_of_layers_setting(),
             few_lights_setting.info(),
             texture_filter_setting(),
             antialiasing_setting()},
        .views = {"final", "linear", "depth", "normal", "roughness", "diffuse-light", "specular-light", "diffuse-sum",
                  "specular-sum", "albedo", "light-count", "ambient-occlusion", "edges", "layers"},
        .presets = {"engel", "round2", "prelighting"},
        .preset_settings = light_prepass_presets(),
        .preset_shading = {{"engel", Shading::phong}, {"round2", Shading::phong}, {"prelighting", Shading::phong}}};
    for (const auto& more : {light_culling_settings(), draw_settings(true), shadow_settings(true), occlusion_settings(),
                             volume_settings(), light_model_settings(), transparency_settings(true)})
        info.settings.insert(info.settings.end(), more.begin(), more.end());
    return info;
}

std::unique_ptr<Renderer> make_light_prepass(Device& device, const RenderOptions& options) {
    Settings settings(light_prepass_info(), options);
    choose_shadow_memory(settings);
    choose_light_culling(settings, device);
    choose_roughness(settings, device);
    const passes::LightModel model = light_model(settings, settings.shading());
    resolve_sample_settings(settings, dynamic_cast<const gpu::Context&>(device), options.msaa);
    choose_shadow_memory(settings); // what the model is written by may have changed the way
    return std::make_unique<LightPrepass>(device, options, std::move(settings), model);
}

} // namespace prelight
