#include "forward_renderer.hpp"
#include "draw_settings.hpp"
#include "shadow_settings.hpp"
#include <passes/view.hpp>

namespace prelight {

ForwardRenderer::ForwardRenderer(Device& device, const RenderOptions& options, Settings settings,
                                 resident::ObjectLights order)
    : DeviceRenderer(device, options, std::move(settings)), order_(order) {
    model_.shading = this->settings().shading();
    model_.fresnel = this->settings().is("model", "nv") ? passes::FresnelModel::nv : passes::FresnelModel::full;
    model_.step_gate = this->settings().is("specular-gate", "step");
    model_.reflection_vector = this->settings().is("specular-vector", "reflection");
    model_.specular_antialiasing = this->settings().is("specular-antialiasing", "on");
}

resident::FrameSettings ForwardRenderer::frame_settings() const {
    resident::FrameSettings frame = DeviceRenderer::frame_settings();
    frame.object_lights = order_;
    frame.texture_filter = settings().is("texture-filter", "bilinear") ? gpu::TextureFilter::bilinear
                                                                       : gpu::TextureFilter::anisotropic;
    return frame;
}

passes::ForwardInputs ForwardRenderer::shading(const char* name, graph::ImageId depth, graph::ImageId colour) {
    passes::ForwardInputs inputs{.name = name, .depth = depth, .colour = colour, .kinds = {}, .plan = {}, .model = model_};
    inputs.decals = decals_;
    inputs.pair_counters = &pair_counters();
    inputs.count_pairs = options().count_pairs;
    inputs.draws = &draws_;
    return inputs;
}

void ForwardRenderer::add_views(Views& views, graph::FrameGraph& graph, const resident::Frame& frame,
                                graph::ImageId depth) const {
    const passes::SurfaceBuffers surface{.format = {}, .depth = depth, .depth_source = depth, .normal = depth, .roughness = depth};
    const auto show = [&](const char* name, passes::ViewKind kind, graph::ImageId buffer) {
        views[name] = passes::view_pass(graph, frame, name, kind, surface, buffer);
    };
    if (wants("depth"))
        show("depth", passes::ViewKind::depth, depth);
    if (wants("albedo"))
        show("albedo", passes::ViewKind::colour, passes::forward_albedo_pass(graph, frame, depth, decals_));
    if (wants("light-count")) {
        passes::ForwardInputs counts{.name = "light-count",
                                     .depth = depth,
                                     .colour = graph.image("light count", {VK_FORMAT_R16G16B16A16_SFLOAT, frame.extent()}),
                                     .kinds = {passes::StepKind::lights},
                                     .plan = [](const resident::LightReach& reach) {
                                         return passes::plan_by_objects(reach, FORWARD_MOST_LIGHTS, false);
                                     },
                                     .model = model_};
        counts.decals = decals_;
        counts.pair_counters = &pair_counters();
        counts.counts_lights = true;
        light_count_pass(graph, frame, counts);
        show("light-count", passes::ViewKind::count, counts.colour);
    }
}

std::vector<SettingInfo> forward_settings(std::vector<SettingInfo> own, bool twice) {
    const std::vector<SettingInfo> common{
        {"model", {"full", "nv"}, "full", "Fresnel: of each light at V·H, or at N·V"},
        {"specular-gate", {"factor", "step"}, "factor", "phong: N·L times, or only where N·L > 0"},
        {"specular-vector", {"half", "reflection"}, "half", "phong: N·H or R·V"},
        specular_antialiasing_setting(),
        {"texture-filter", {"anisotropic", "bilinear"}, "anisotropic",
         "bilinear: level 0 only, for comparing with the reference"}};
    own.insert(own.end(), common.begin(), common.end());
    for (SettingInfo& setting : draw_settings(twice))
        own.push_back(std::move(setting));
    for (SettingInfo& setting : shadow_settings())
        own.push_back(std::move(setting));
    return own;
}

std::vector<std::string> forward_views() { return {"final", "linear", "depth", "albedo", "light-count"}; }

} // namespace prelight
