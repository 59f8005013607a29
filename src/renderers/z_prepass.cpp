// Z pre-pass forward: depth alone, then every visible pixel is shaded once with up to eight lights; an
// object that more lights reach is drawn again for the rest.
#include "z_prepass.hpp"
#include "forward_renderer.hpp"
#include <passes/depth_only.hpp>
#include <passes/light_pass.hpp>

namespace prelight {
namespace {

class ZPrepass final : public ForwardRenderer {
public:
    ZPrepass(Device& device, const RenderOptions& options, Settings settings)
        : ForwardRenderer(device, options, settings,
                          settings.is("lights", "grid") ? resident::ObjectLights::none
                                                        : resident::ObjectLights::strongest_first),
          grid_(settings.is("lights", "grid")) {}

private:
    resident::ViewSettings view_settings() const override {
        resident::ViewSettings view = ForwardRenderer::view_settings();
        if (grid_)
            view.culling = resident::LightCulling::grid;
        return view;
    }

    uint32_t blended_adds(const resident::View& view) const override {
        return grid_ ? passes::light_adds(view, false) : most_batches(view, FORWARD_MOST_LIGHTS);
    }

    const passes::LightLists* world_lists() const override { return lists_ ? &*lists_ : nullptr; }

    void light_count_pass(graph::FrameGraph& graph, const resident::View& view,
                          const passes::ForwardInputs& counts) const override {
        if (grid_)
            passes::forward_grid_pass(graph, view, counts, *lists_);
        else
            ForwardRenderer::light_count_pass(graph, view, counts);
    }

    uint64_t draws(const resident::View& view) const override {
        return ForwardRenderer::draws(view) + view.visible().batches.size();
    }

    Outputs build(graph::FrameGraph& graph, const resident::View& view) override {
        const auto depth = depth_pass(graph, view);
        own_passes(vulkan::Stage::after_surfaces, graph, view, surface_of(depth));
        lists_.reset();
        if (grid_)
            lists_ = passes::grid_light_lists(graph, view, "opaque");
        Outputs outputs;
        if (grid_ && lists_->rounds.size() > 1) // which add up: only linear light does
            outputs = linear_outputs(graph, view, draw_by_grid(graph, view, depth, {}), surface_of(depth));
        else if (grid_)
            outputs = picture_outputs(graph, view, surface_of(depth), [&](passes::Display display) {
                return draw_by_grid(graph, view, depth, display);
            });
        else // further lights blend
            outputs = linear_outputs(graph, view, draw_by_plan(graph, view, depth), surface_of(depth));
        add_views(outputs, graph, view, depth);
        return outputs;
    }

    /// Depth; where there are decals, with the normals that they look at.
    graph::ImageId depth_pass(graph::FrameGraph& graph, const resident::View& view) {
        decals_ = {};
        if (view.scene().decals().empty())
            return passes::depth_only_pass(graph, view);
        const passes::SurfaceBuffers surface = passes::depth_normal_pass(graph, view, {});
        decals_ = passes::decal_pass(graph, view, surface);
        return surface.depth;
    }

    graph::ImageId draw_by_grid(graph::FrameGraph& graph, const resident::View& view, graph::ImageId depth,
                                passes::Display display) {
        passes::ForwardInputs opaque = shading(
            "opaque", depth, passes::picture_image(graph, view, view.surface_raster(), display, light_sums().wide()));
        opaque.display = display;
        opaque.shadows = shadows(graph, view);
        passes::forward_grid_pass(graph, view, opaque, *lists_);
        return opaque.colour;
    }

    graph::ImageId draw_by_plan(graph::FrameGraph& graph, const resident::View& view, graph::ImageId depth) {
        passes::ForwardInputs opaque = shading(
            "opaque", depth, passes::picture_image(graph, view, view.surface_raster(), {}, light_sums().wide()));
        opaque.shadows = shadows(graph, view);
        opaque.kinds = {passes::StepKind::base_and_lights, passes::StepKind::lights};
        opaque.plan = limited(
            [](const resident::LightReach& reach) { return passes::plan_shaded_once(reach, FORWARD_MOST_LIGHTS); });
        passes::forward_pass(graph, view, opaque);
        return opaque.colour;
    }

    bool grid_;
    std::optional<passes::LightLists> lists_; ///< with a grid; of the graph that is built
};

} // namespace

RendererInfo z_prepass_info() {
    return {.name = "z-prepass",
            .description = "depth alone, then every visible pixel shaded with the lights of its object",
            .settings = forward_settings(
                {{"lights",
                  {"per-draw", "grid"},
                  "per-draw",
                  "how a pixel finds its lights: eight a draw, strongest first; or by a grid over the world"}},
                true),
            .views = forward_views(),
            .presets = {}};
}

std::unique_ptr<Renderer> make_z_prepass(Device& device, const RenderOptions& options) {
    return std::make_unique<ZPrepass>(device, options, Settings(z_prepass_info(), options));
}

} // namespace prelight
