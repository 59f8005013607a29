// Deferred shading (Engel, ShaderX7 8.5, figures 8.5.2 and 8.5.3; Valient's Killzone 2): geometry once
// into a G-buffer, then each light with the pixel's material, added to one target.
#include "deferred.hpp"
#include "settings/draw_settings.hpp"
#include "settings/light_culling_settings.hpp"
#include "settings/light_model_settings.hpp"
#include "settings/occlusion_settings.hpp"
#include "settings/sample_settings.hpp"
#include "settings/shadow_settings.hpp"
#include "settings/texture_settings.hpp"
#include "settings/transparency_settings.hpp"
#include <passes/decals.hpp>
#include <passes/half_samples.hpp>
#include <passes/light_pass.hpp>
#include <passes/light_scale.hpp>
#include <passes/motion_blur.hpp>
#include <passes/sun_occlusion.hpp>
#include <passes/view.hpp>
#include <shared/light_scale.h>

namespace prelight {
namespace {

class Deferred final : public DeviceRenderer {
public:
    Deferred(Device& device, const RenderOptions& options, Settings settings)
        : DeviceRenderer(device, options, std::move(settings)), model_(material_light_model(this->settings())) {}

private:
    passes::GBufferFormat format() const {
        return {.layout = settings().is("g-buffer", "killzone2") ? passes::GBufferLayout::killzone2
                                                                 : passes::GBufferLayout::wide,
                .light_in_bytes = settings().is("accumulation", "rgba8"),
                .position_from_ray = settings().is("position", "ray"),
                .stencil = settings().is("light-culling", "stencil"),
                .specular_antialiasing = settings().is("specular-antialiasing", "on"),
                .wide_light = light_sums().wide(),
                .ambient_apart = occlusion_options(settings()).on,
                .samples = options().msaa};
    }

    uint32_t blended_adds(const resident::View& view) const override {
        return settings().is("accumulation", "rgba8") ? 0 : passes::light_adds(view, true);
    }

    resident::GpuSceneSettings scene_settings() const override {
        resident::GpuSceneSettings scene = DeviceRenderer::scene_settings();
        scene.motion = true;
        return scene;
    }

    resident::ViewSettings view_settings() const override {
        resident::ViewSettings view = DeviceRenderer::view_settings();
        if (format().light_in_bytes) {
            view.measures_light = settings().is("light-scale", "auto");
            view.light_scale = view.measures_light ? 1 : settings().number("light-scale");
        }
        view.culling = light_culling(settings());
        view.volumes = volume_options(settings());
        return view;
    }

    passes::LightingInputs lighting_of(const passes::GBuffer& gbuffer, const passes::Shadows& shadows) {
        return {.surface = gbuffer.surface,
                .material = gbuffer.motion,
                .albedo = gbuffer.albedo,
                .model = model_,
                .target = gbuffer.light_target(),
                .shadows = shadows,
                .pair_counters = &pair_counters(),
                .count_pairs = options().count_pairs};
    }

    /// RT0 is filled with the geometry, so that its scale has to be known before: from the geometry drawn small.
    void find_light_scale(graph::FrameGraph& graph, const resident::View& view, const passes::Shadows& shadows) {
        const bool measured = settings().is("light-scale", "auto");
        scale_.emplace(view, passes::fixed_point_of_deferred(), measured);
        if (!measured)
            return;
        passes::GBufferFormat small = format();
        small.light_in_bytes = small.ambient_apart = false;
        small.pass = "geometry-small";
        small.reduction = shared::light_sample_step(options().width, options().height);
        scale_->measure(graph, view, lighting_of(passes::gbuffer_pass(graph, view, small), shadows));
    }

    Outputs build(graph::FrameGraph& graph, const resident::View& view) override {
        const passes::Shadows maps = shadows(graph, view);
        scale_.reset();
        if (format().light_in_bytes)
            find_light_scale(graph, view, maps);
        const auto drawn = passes::gbuffer_pass(graph, view, format());
        passes::decal_geometry_pass(graph, view, drawn, passes::decal_pass(graph, view, drawn.surface));
        own_passes(vulkan::Stage::after_surfaces, graph, view, drawn.surface);
        const bool halves = blended().in_half_samples();
        if (halves) {
            blended().count_layers(graph, view, drawn.surface.depth);
            passes::half_geometry_pass(graph, view, drawn);
        }
        passes::GBufferColours colours{drawn.light, drawn.motion, drawn.albedo};
        const passes::SampledSurfaces surfaces = sampled(graph, view, drawn.surface, &colours);
        passes::GBuffer gbuffer = drawn;
        gbuffer.surface = surfaces.pixels;
        gbuffer.light = colours.light;
        gbuffer.motion = colours.material;
        gbuffer.albedo = colours.albedo;
        const passes::OcclusionOptions occlusion = occlusion_options(settings());
        std::optional<graph::ImageId> visibility;
        if (occlusion.on || wants("ambient-occlusion"))
            visibility = passes::ambient_occlusion_passes(graph, view, gbuffer.surface, occlusion);
        if (occlusion.on)
            passes::ambient_light_pass(graph, view, gbuffer, *visibility);
        const passes::Shadows lit = format().layout == passes::GBufferLayout::killzone2
                                        ? passes::sun_occlusion_pass(graph, view, gbuffer, maps)
                                        : maps;
        passes::LightingInputs lighting = lighting_of(gbuffer, lit);
        passes::ScreenListOptions lists = screen_list_options(settings());
        if (surfaces.edges)
            lists.samples = &surfaces.samples;
        lighting.lists = passes::screen_light_lists(graph, view, "light", lighting, lists);
        passes::light_pass(graph, view, "light", lighting);
        own_passes(vulkan::Stage::after_light, graph, view, gbuffer.surface, {{"light", gbuffer.light}});
        std::optional<passes::SampleColours> samples;
        if (surfaces.edges) {
            const VkFormat light = graph.desc(gbuffer.light).format;
            samples = {*surfaces.edges, graph.image("sample light", {light, surfaces.edges->raster}),
                       view.surface_raster()};
            passes::LightingInputs own = lighting;
            own.material = drawn.motion;
            own.albedo = drawn.albedo;
            own.own_light = drawn.light;
            passes::sample_light_pass(graph, view, "light samples", own, surfaces,
                                      {gpu::Variant::deferred_target, {samples->light}});
        }
        if (scale_)
            scale_->count_clipped(graph, view, gbuffer.light, gbuffer.light);
        const auto resolve = [&](passes::Display display) {
            const graph::ImageId picture =
                passes::light_resolve_pass(graph, view, gbuffer, display, samples ? &*samples : nullptr);
            if (halves)
                passes::half_coverage_pass(graph, view, drawn, picture, blended().count_draws());
            return picture;
        };
        const auto blur = [&](graph::ImageId linear) { return passes::motion_blur_pass(graph, view, gbuffer, linear); };
        const passes::SurfaceBuffers& shown = samples ? drawn.surface : gbuffer.surface;
        Outputs outputs = settings().is("motion-blur", "on") ? linear_outputs(graph, view, resolve({}), shown, blur)
                                                             : picture_outputs(graph, view, shown, resolve);
        using passes::ViewKind;
        const auto show = [&](const char* name, ViewKind kind, graph::ImageId buffer) {
            if (wants(name))
                outputs[name] = passes::view_pass(graph, view, name, kind, gbuffer.surface, buffer);
        };
        const bool wide = format().layout == passes::GBufferLayout::wide;
        show("depth", ViewKind::depth, gbuffer.surface.depth_source);
        show("normal", ViewKind::normal, gbuffer.surface.normal);
        show("roughness", ViewKind::roughness, gbuffer.surface.normal);
        show("specular", ViewKind::specular, wide ? gbuffer.albedo : gbuffer.motion);
        show("albedo", ViewKind::albedo, gbuffer.albedo);
        show("sun-occlusion", ViewKind::sun_occlusion, gbuffer.albedo);
        show("motion", ViewKind::motion, gbuffer.motion);
        add_surface_samples(outputs, graph, view, drawn.surface);
        if (wants("edges"))
            outputs["edges"] = passes::edges_view_pass(graph, view, surfaces);
        if (visibility)
            show("ambient-occlusion", ViewKind::occlusion, *visibility);
        if (wants("light-count"))
            show("light-count", ViewKind::count, passes::light_count_pass(graph, view, lighting));
        return outputs;
    }

    void add_figures(Stats& stats) const override {
        if (scale_)
            scale_->tell(stats);
    }

    passes::LightModel model_;
    std::optional<passes::LightScale> scale_; ///< of RT0 in bytes
};

} // namespace

RendererInfo deferred_info() {
    RendererInfo info{
        .name = "deferred",
        .description = "geometry once into a G-buffer, then each light with the pixel's material",
        .settings =
            {{"g-buffer", {"wide", "killzone2"}, "wide", "exact for the model, or Valient's 20 bytes a pixel"},
             {"accumulation", {"rgba16f", "rgba8"}, "rgba16f", "the target that light is added up in"},
             {"light-scale",
              {"auto", "0.01 … 1000"},
              "auto",
              "accumulation=rgba8: the light that its RGB holds; auto: from the light of each frame"},
             model_setting(),
             {"motion-blur",
              {"off", "on"},
              "off",
              "what moved since the moment's previous state (1/60 s) is blurred, by the G-buffer's motion vectors"},
             {"position", {"ray", "matrix"}, "ray", "position from depth: frustum ray or inverse matrix"},
             specular_gate_setting(),
             specular_vector_setting(),
             light_sums_setting(),
             specular_antialiasing_setting(),
             msaa_light_setting(false),
             msaa_shadows_setting(),
             texture_filter_setting(),
             antialiasing_setting()},
        .views = {"final", "linear", "depth", "normal", "roughness", "specular", "albedo", "sun-occlusion", "motion",
                  "light-count", "ambient-occlusion", "edges", "layers"},
        .presets = {"killzone2"},
        .preset_settings = {{"killzone2",
                             {{"g-buffer", "killzone2"}, {"accumulation", "rgba8"}, {"specular-antialiasing", "off"}}}},
        .preset_shading = {{"killzone2", Shading::phong}}};
    for (const auto& more : {light_culling_settings(), draw_settings(false), shadow_settings(true),
                             occlusion_settings(), volume_settings(), transparency_settings(true)})
        info.settings.insert(info.settings.end(), more.begin(), more.end());
    return info;
}

std::unique_ptr<Renderer> make_deferred(Device& device, const RenderOptions& options) {
    Settings settings(deferred_info(), options);
    choose_shadow_memory(settings);
    choose_light_culling(settings, device);
    resolve_sample_settings(settings, dynamic_cast<const gpu::Context&>(device), options.msaa);
    return std::make_unique<Deferred>(device, options, std::move(settings));
}

} // namespace prelight
