#include "forward_renderer.hpp"
#include "settings/draw_settings.hpp"
#include "settings/light_model_settings.hpp"
#include "settings/sample_settings.hpp"
#include "settings/shadow_settings.hpp"
#include "settings/texture_settings.hpp"
#include "settings/transparency_settings.hpp"
#include <algorithm>
#include <passes/depth_only.hpp>
#include <passes/light_overlap.hpp>
#include <passes/lighting.hpp>
#include <passes/resolve.hpp>
#include <passes/view.hpp>

namespace prelight {

ForwardRenderer::ForwardRenderer(Device& device, const RenderOptions& options, Settings settings,
                                 resident::ObjectLights order)
    : DeviceRenderer(device, options, std::move(settings)), order_(order) {
    model_ = material_light_model(this->settings());
    model_.specular_antialiasing = this->settings().is("specular-antialiasing", "on");
}

resident::ViewSettings ForwardRenderer::view_settings() const {
    resident::ViewSettings view = DeviceRenderer::view_settings();
    view.object_lights = order_;
    return view;
}

uint32_t ForwardRenderer::most_batches(const resident::View& view, uint32_t per_pass) {
    const auto lights = static_cast<uint32_t>(view.lights().placed().size());
    const uint32_t batches = lights / per_pass + (lights % per_pass > 0 ? 1 : 0);
    return std::min(batches, passes::light_overlap(view.scene().geometry().draws, view.lights().placed()));
}

ForwardRenderer::Plan ForwardRenderer::limited(Plan plan) const {
    if (light_sums().wide())
        return plan;
    return [plan = std::move(plan), most = light_sums().most_adds()](const resident::LightReach& reach) {
        passes::ForwardPlan steps = plan(reach);
        passes::limit_steps(steps, most);
        return steps;
    };
}

passes::ForwardInputs ForwardRenderer::shading(const char* name, graph::ImageId depth, graph::ImageId colour) {
    passes::ForwardInputs inputs{
        .name = name, .depth = depth, .colour = colour, .kinds = {}, .plan = {}, .model = model_};
    inputs.sample_shading = material_shading(settings());
    inputs.decals = decals_;
    inputs.pair_counters = &pair_counters();
    inputs.count_pairs = options().count_pairs;
    inputs.draws = &draws_;
    return inputs;
}

void ForwardRenderer::add_views(Outputs& outputs, graph::FrameGraph& graph, const resident::View& view,
                                graph::ImageId depth) const {
    const bool any = wants("depth") || wants("albedo") || wants("light-count");
    const graph::ImageId pixels =
        any && graph.raster(depth).samples > 1 ? passes::pixel_depth_pass(graph, view) : depth;
    const passes::SurfaceBuffers surface = surface_of(pixels);
    const auto show = [&](const char* name, passes::ViewKind kind, graph::ImageId buffer) {
        outputs[name] = passes::view_pass(graph, view, name, kind, surface, buffer);
    };
    add_surface_samples(outputs, graph, view, surface_of(depth));
    if (wants("depth"))
        show("depth", passes::ViewKind::depth, pixels);
    if (wants("albedo"))
        show("albedo", passes::ViewKind::colour, passes::forward_albedo_pass(graph, view, depth, decals_));
    if (wants("light-count")) {
        passes::ForwardInputs counts{.name = "light-count",
                                     .depth = depth,
                                     .colour = passes::light_count_image(graph, view, depth),
                                     .kinds = {passes::StepKind::lights},
                                     .plan =
                                         [](const resident::LightReach& reach) {
                                             return passes::plan_by_objects(reach, FORWARD_MOST_LIGHTS, false);
                                         },
                                     .model = model_};
        counts.decals = decals_;
        counts.pair_counters = &pair_counters();
        counts.counts_lights = true;
        light_count_pass(graph, view, counts);
        show("light-count", passes::ViewKind::count, passes::resolve_pass(graph, view, counts.colour));
    }
}

std::vector<SettingInfo> forward_settings(std::vector<SettingInfo> own, bool twice) {
    const std::vector<SettingInfo> common{
        model_setting(),         specular_gate_setting(),         specular_vector_setting(),
        light_sums_setting(),    specular_antialiasing_setting(), texture_filter_setting(),
        msaa_material_setting(), antialiasing_setting()};
    own.insert(own.end(), common.begin(), common.end());
    for (const auto& more : {draw_settings(twice), shadow_settings(), transparency_settings(false)})
        own.insert(own.end(), more.begin(), more.end());
    return own;
}

std::vector<std::string> forward_views() { return {"final", "linear", "depth", "albedo", "light-count", "layers"}; }

} // namespace prelight
