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
    resident::FrameSettings frame_settings() const override {
        resident::FrameSettings frame = ForwardRenderer::frame_settings();
        if (grid_)
            frame.culling = resident::LightCulling::grid;
        return frame;
    }

    uint32_t blended_adds(const resident::Frame& frame) const override {
        return grid_ ? passes::light_adds(frame, false) : most_batches(frame, FORWARD_MOST_LIGHTS);
    }

    void light_count_pass(graph::FrameGraph& graph, const resident::Frame& frame,
                          const passes::ForwardInputs& counts) const override {
        if (grid_)
            passes::forward_grid_pass(graph, frame, counts);
        else
            ForwardRenderer::light_count_pass(graph, frame, counts);
    }

    uint64_t draws(const resident::Frame& frame) const override {
        return ForwardRenderer::draws(frame) + frame.visible().batches.size();
    }

    Views build(graph::FrameGraph& graph, const resident::Frame& frame) override {
        const auto depth = depth_pass(graph, frame);
        Views views;
        if (grid_ && passes::forward_grid_adds(frame))
            views = linear_views(graph, frame, draw_by_grid(graph, frame, depth, {}), depth);
        else if (grid_)
            views = picture_views(graph, frame, depth,
                                  [&](passes::Display display) { return draw_by_grid(graph, frame, depth, display); });
        else // Further lights blend: only linear light adds up
            views = linear_views(graph, frame, draw_by_plan(graph, frame, depth), depth);
        add_views(views, graph, frame, depth);
        return views;
    }

    /// Depth; where there are decals, with the normals that they look at.
    graph::ImageId depth_pass(graph::FrameGraph& graph, const resident::Frame& frame) {
        decals_ = {};
        if (frame.decals().empty())
            return passes::depth_only_pass(graph, frame);
        const passes::SurfaceBuffers surface = passes::depth_normal_pass(graph, frame, {});
        decals_ = passes::decal_pass(graph, frame, surface);
        return surface.depth;
    }

    graph::ImageId draw_by_grid(graph::FrameGraph& graph, const resident::Frame& frame, graph::ImageId depth,
                                passes::Display display) {
        passes::ForwardInputs opaque =
            shading("opaque", depth, passes::picture_image(graph, frame, display, light_sums().wide()));
        opaque.display = display;
        opaque.shadows = shadows(graph, frame);
        passes::forward_grid_pass(graph, frame, opaque);
        return opaque.colour;
    }

    graph::ImageId draw_by_plan(graph::FrameGraph& graph, const resident::Frame& frame, graph::ImageId depth) {
        passes::ForwardInputs opaque =
            shading("opaque", depth, passes::picture_image(graph, frame, {}, light_sums().wide()));
        opaque.shadows = shadows(graph, frame);
        opaque.kinds = {passes::StepKind::base_and_lights, passes::StepKind::lights};
        opaque.plan = limited(
            [](const resident::LightReach& reach) { return passes::plan_shaded_once(reach, FORWARD_MOST_LIGHTS); });
        passes::forward_pass(graph, frame, opaque);
        return opaque.colour;
    }

    bool grid_;
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
