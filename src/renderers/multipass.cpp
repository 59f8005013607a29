// Multi-pass forward (Lee's "what we did in the past"; the XNA multipass sample): ambient and emissive
// light first, then every object again for the lights that reach it, added up.
#include "multipass.hpp"
#include "forward_renderer.hpp"

namespace prelight {
namespace {

class Multipass final : public ForwardRenderer {
public:
    Multipass(Device& device, const RenderOptions& options, Settings settings)
        : ForwardRenderer(device, options, std::move(settings), resident::ObjectLights::world_order) {}

private:
    uint32_t lights_per_pass() const { return static_cast<uint32_t>(settings().number("lights-per-pass")); }
    uint32_t blended_adds(const resident::View& view) const override { return most_batches(view, lights_per_pass()); }
    uint64_t draws(const resident::View& view) const override { return ForwardRenderer::draws(view) + ambient_draws_; }

    Outputs build(graph::FrameGraph& graph, const resident::View& view) override {
        const bool per_object = settings().is("ambient", "per-object");
        const uint32_t per_pass = lights_per_pass();
        const auto plan = settings().is("order", "lights") ? passes::plan_by_lights : passes::plan_by_objects;
        decals_ = passes::decals_of_own(graph, view);
        const auto depth = graph.image("depth", {VK_FORMAT_D32_SFLOAT, view.surface_raster()});
        const auto linear = passes::picture_image(graph, view, view.surface_raster(), {}, light_sums().wide());

        ambient_draws_ = 0;
        passes::ForwardInputs lights = shading("lights", depth, linear);
        lights.shadows = shadows(graph, view);
        lights.lights_test =
            settings().is("depth-test", "equal") ? gpu::DepthTest::equal : gpu::DepthTest::behind_or_at;
        lights.kinds = {passes::StepKind::lights};
        if (per_object) {
            lights.kinds.push_back(passes::StepKind::base);
        } else {
            passes::ForwardInputs ambient = shading("ambient", depth, linear);
            ambient.kinds = {passes::StepKind::base};
            ambient.plan = [](const resident::LightReach& reach) { return passes::plan_base(reach.draws()); };
            ambient.draws = &ambient_draws_;
            passes::forward_pass(graph, view, ambient);
            lights.load = graph::Load::keep;
        }
        lights.plan = limited([=](const resident::LightReach& reach) { return plan(reach, per_pass, per_object); });
        passes::forward_pass(graph, view, lights);
        Outputs outputs = linear_outputs(graph, view, linear, surface_of(depth));
        add_views(outputs, graph, view, depth);
        return outputs;
    }

    uint64_t ambient_draws_ = 0;
};

} // namespace

RendererInfo multipass_info() {
    return {.name = "multipass",
            .description = "ambient light, then every object again for the lights that reach it",
            .settings = forward_settings(
                {{"order", {"lights", "objects"}, "lights", "the outer loop: over lights, or over objects"},
                 {"ambient", {"first", "per-object"}, "first", "ambient of all objects first, or with each object"},
                 {"lights-per-pass", {"1", "2", "3", "4", "5", "6", "7", "8"}, "1", "lights that one draw adds"},
                 {"depth-test",
                  {"less-equal", "equal"},
                  "less-equal",
                  "of the draws that add lights: what lies at or before the depth that is there, or just at it"}},
                false),
            .views = forward_views(),
            .presets = {}};
}

std::unique_ptr<Renderer> make_multipass(Device& device, const RenderOptions& options) {
    return std::make_unique<Multipass>(device, options, Settings(multipass_info(), options));
}

} // namespace prelight
