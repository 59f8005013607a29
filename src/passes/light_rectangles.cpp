#include "light_rectangles.hpp"
#include "light_draws.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

/// `auto` leaves software devices out: on SwiftShader the test and a draw for each light cost
/// more than the pixels that they save (docs/light-culling.md).
bool uses_depth_bounds(const resident::View& view) {
    const gpu::Context& context = view.context();
    const resident::DepthBounds asked = view.volumes().depth_bounds;
    return context.features().depth_bounds && (asked == resident::DepthBounds::on ||
                                               (asked == resident::DepthBounds::automatic && !context.is_software()));
}

class RectangleDraws {
public:
    RectangleDraws(const resident::View& view, const graph::PassInterface& interface, const LightingInputs& inputs)
        : draws_(view, interface, inputs), bounds_(uses_depth_bounds(view)) {
        for (const bool inside : {false, true}) {
            gpu::GraphicsPipelineDesc desc =
                draws_.pipeline(inside ? "rectangles from inside" : "rectangles from outside", "light_rectangle.vert");
            desc.constants.emplace_back(CONSTANT_RECTANGLE_FAR_SIDE, inside);
            desc.depth_bounds = bounds_;
            desc.depth = bounds_  ? gpu::DepthTest::none
                         : inside ? gpu::DepthTest::before_or_at
                                  : gpu::DepthTest::behind_or_at;
            pipelines_[inside] = gpu::GraphicsPipeline(view.context(), desc);
            if (bounds_)
                break; // both sides are in the bounds
        }
    }

    void record(const graph::PassContext& pass) const {
        draws_.record_fullscreen(pass);
        const resident::LightGroups& lights = draws_.lights();
        for (const VolumeGroup& group : volume_groups) {
            draws_.each(pass, lights.first[group.index()], lights.count[group.index()],
                        [&](uint32_t first, uint32_t count) {
                            draws_.bind(pass, pipelines_[group.inside && !bounds_]);
                            if (bounds_)
                                draw_bounded(pass, first, count);
                            else
                                vkCmdDraw(pass.commands, 6, count, 0, first);
                        });
        }
    }

private:
    void draw_bounded(const graph::PassContext& pass, uint32_t first, uint32_t count) const {
        for (uint32_t i = first; i < first + count; ++i) {
            // Reversed depth: the far side is the smaller one. 0 is where no surface is.
            const shared::LightScreenBounds& bounds = draws_.lights().bounds[i];
            const float nearest = bounds.depth.x, farthest = bounds.depth.y;
            const float least = std::max(farthest, std::numeric_limits<float>::min());
            vkCmdSetDepthBounds(pass.commands, std::min(nearest, least), nearest);
            vkCmdDraw(pass.commands, 6, 1, 0, i);
        }
    }

    LightDraws draws_;
    bool bounds_;
    std::array<gpu::GraphicsPipeline, 2> pipelines_; ///< from outside, from inside
};

} // namespace

void light_rectangle_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                          const LightingInputs& inputs) {
    if (view.volumes().depth_bounds == resident::DepthBounds::on && !uses_depth_bounds(view))
        graph.note(fmt::format("{}: {} has no depth bounds test, one side of each light is tested", name,
                               view.context().name()));
    graph::Pass& pass = graph.pass(name);
    declare_lighting(graph, pass, inputs);
    pass.blends().depth_test(inputs.surface.depth);
    draw_lights<RectangleDraws>(pass, view, inputs);
}

} // namespace prelight::passes
