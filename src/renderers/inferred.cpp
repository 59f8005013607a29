// Inferred lighting (Kircher and Lawrance, "Inferred Lighting: Fast dynamic lighting and shadows for opaque and
// translucent objects", SIGGRAPH Game Papers 2009): the light pre-pass with its light at a lower resolution, where
// blended objects have texels of their own, and materials that find the light of their own surface there.
#include "inferred.hpp"
#include "light_buffer_renderer.hpp"
#include "settings/draw_settings.hpp"
#include "settings/inferred_settings.hpp"
#include "settings/light_culling_settings.hpp"
#include "settings/light_model_settings.hpp"
#include "settings/occlusion_settings.hpp"
#include "settings/shadow_settings.hpp"
#include "settings/texture_settings.hpp"
#include <fmt/format.h>
#include <passes/depth_only.hpp>
#include <passes/view.hpp>
#include <prelight/error.hpp>

namespace prelight {
namespace {

class Inferred final : public LightBufferRenderer {
public:
    Inferred(Device& device, const RenderOptions& options, Settings settings, const passes::LightModel& model)
        : LightBufferRenderer(device, options, std::move(settings), model),
          unmatched_(context(), "unmatched pixels", sizeof(uint32_t),
                     VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                     gpu::BufferPlace::readback) {
        if (options.msaa != 1)
            throw UsageError(
                fmt::format("--msaa {}: renderer inferred has one sample a pixel (light-prepass, deferred, "
                            "z-prepass and multipass have more)",
                            options.msaa));
    }
    ~Inferred() override { finish(); }

private:
    resident::GpuSceneSettings scene_settings() const override {
        resident::GpuSceneSettings scene = LightBufferRenderer::scene_settings();
        scene.casters = shadow_options(settings()).on;
        scene.surface_ids = true;
        scene.blends = has_layers(settings());
        return scene;
    }

    resident::ViewSettings view_settings() const override {
        resident::ViewSettings view = LightBufferRenderer::view_settings();
        view.shadows = {};
        view.layer_decals = has_layers(settings());
        return view;
    }

    std::optional<resident::ViewSettings> light_view_settings() const override {
        resident::ViewSettings view = LightBufferRenderer::view_settings();
        view.frame = view.raster.extent;
        view.raster.extent = inferred_extent(settings(), view.frame);
        view.draws.counts_pixels = view.draws.trims_by_depth = false; // it is drawn once
        view.layers = view.layer_decals = has_layers(settings());
        add_light_settings(view);
        return view;
    }

    uint64_t draws(const resident::View& view) const override {
        return LightBufferRenderer::draws(view) + layer_draws_;
    }

    Outputs build(graph::FrameGraph& graph, const resident::View& view) override {
        const bool layers = view.scene().blends();
        layer_draws_ = 0;
        note_missing_decals(graph, view.scene());
        note_what_is_opaque(graph, view.scene(), has_layers(settings()) ? "inferred" : "inferred-layers=off");
        // At the light's resolution.
        const resident::View& lit = light_view();
        const auto surface =
            passes::depth_normal_pass(graph, lit,
                                      {.stencil = settings().is("light-culling", "stencil"),
                                       .ids = true,
                                       .specular_antialiasing = settings().is("specular-antialiasing", "on")});
        passes::decal_normal_pass(graph, lit, surface, passes::decal_pass(graph, lit, surface));
        own_passes(vulkan::Stage::after_surfaces, graph, lit, surface);
        const auto visibility = this->visibility(graph, lit, surface);
        if (layers)
            passes::layer_geometry_pass(graph, lit, surface);
        const LightStage stage = light_stage(graph, lit, {surface, surface, {}});
        own_passes_after_light(graph, lit, surface, stage.light);
        // At the picture's.
        const auto drawn = picture_surface(graph, view);
        passes::clear_unmatched_pass(graph, unmatched_);
        passes::MaterialInputs materials{.depth = drawn.depth,
                                         .light = stage.light,
                                         .model = model(),
                                         .decals = passes::decal_pass(graph, view, drawn),
                                         .lit_surfaces = surface,
                                         .unmatched = &unmatched_};
        if (occludes())
            materials.visibility = visibility;
        const auto draw = [&](passes::Display display) {
            return passes::material_pass(graph, view, materials, display);
        };
        const auto add_layers = [&](graph::ImageId linear) {
            passes::layer_pass(graph, view, materials, lit, linear, &layer_draws_);
            return linear;
        };
        Outputs outputs = layers ? linear_outputs(graph, view, draw({}), drawn, add_layers)
                                 : picture_outputs(graph, view, drawn, draw);
        add_light_views(outputs, graph, lit, stage, visibility);
        add_material_views(outputs, graph, view, drawn, materials);
        if (wants("dsf-fallback"))
            outputs["dsf-fallback"] =
                passes::view_pass(graph, view, "dsf-fallback", passes::ViewKind::colour, drawn,
                                  passes::unmatched_view_pass(graph, view, materials, layers ? &lit : nullptr));
        return outputs;
    }

    /// Depth; where there are decals, with the normals that they look at.
    static passes::SurfaceBuffers picture_surface(graph::FrameGraph& graph, const resident::View& view) {
        if (!view.scene().decals().empty())
            return passes::depth_normal_pass(graph, view, {});
        return passes::depth_only_surfaces(graph, view);
    }

    void add_figures(Stats& stats) const override {
        LightBufferRenderer::add_figures(stats);
        note_left_out_decals(stats, light_view().layer_decals());
        const resident::LayerSlots& slots = light_view().layers();
        stats.inferred = {.layers = slots.drawn,
                          .layers_without_slot = slots.without_own,
                          .unmatched_pixels = *unmatched_.mapped<uint32_t>()};
        if (slots.without_own > 0)
            stats.notes.push_back(fmt::format(
                "inferred: {} of {} blended draws share their slot with others that they may cover: the nearest is lit",
                slots.without_own, slots.drawn));
    }

    gpu::Buffer unmatched_; ///< of the last frame
    uint64_t layer_draws_ = 0;
};

/// Light is filtered as floats.
std::vector<SettingInfo> float_light_settings() {
    std::vector<SettingInfo> all = light_model_settings();
    std::erase_if(all, [](const SettingInfo& one) { return one.key == "light-scale"; });
    for (SettingInfo& one : all)
        if (one.key == "light-buffer")
            one.values = {"rgba16f", "packed-rgba16f"};
    return all;
}

} // namespace

RendererInfo inferred_info() {
    RendererInfo info{.name = "inferred",
                      .description = "the light pre-pass with light and its layers of blended surfaces at a lower "
                                     "resolution, filtered by surface",
                      .settings = inferred_settings(),
                      .views = {"final", "linear", "depth", "normal", "roughness", "diffuse-light", "specular-light",
                                "diffuse-sum", "specular-sum", "albedo", "light-count", "ambient-occlusion",
                                "dsf-fallback"},
                      .presets = {}};
    for (const auto& more :
         {std::vector<SettingInfo>{specular_antialiasing_setting(), texture_filter_setting(), antialiasing_setting()},
          light_culling_settings(), draw_settings(true), shadow_settings(true), occlusion_settings(), volume_settings(),
          float_light_settings()})
        info.settings.insert(info.settings.end(), more.begin(), more.end());
    return info;
}

std::unique_ptr<Renderer> make_inferred(Device& device, const RenderOptions& options) {
    Settings settings(inferred_info(), options);
    choose_shadow_memory(settings);
    choose_light_culling(settings, device);
    const passes::LightModel model = light_model(settings, settings.shading());
    choose_shadow_memory(settings); // what the model is written by may have changed the way
    return std::make_unique<Inferred>(device, options, std::move(settings), model);
}

} // namespace prelight
