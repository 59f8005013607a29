#include "light_stencil.hpp"
#include "device_volumes.hpp"
#include "light_draws.hpp"

namespace prelight::passes {
namespace {

class StencilDraws {
public:
    StencilDraws(const resident::View& view, const graph::PassInterface& interface, const LightingInputs& inputs)
        : draws_(view, interface, inputs), volumes_(view) {
        for (const VolumeGroup& group : volume_groups) {
            gpu::GraphicsPipelineDesc light = draws_.pipeline(group.name, "");
            volumes_.describe(light, group.spot);
            gpu::GraphicsPipelineDesc mark = light;
            light.stencil = gpu::Stencil::marked_to_zero;
            // Outside, a surface in the volume lies behind its front and not behind its back. Inside
            // there may be no front, so the faces that fail are counted: those behind the surface.
            mark.name += ", marked";
            mark.fragment = {};
            mark.depth = gpu::DepthTest::behind_or_at;
            mark.stencil = group.inside ? gpu::Stencil::mark_failing : gpu::Stencil::mark_passing;
            pipelines_[group.index()] = {gpu::GraphicsPipeline(view.context(), mark),
                                         gpu::GraphicsPipeline(view.context(), light)};
        }
    }

    void record(const graph::PassContext& pass) const {
        draws_.record_fullscreen(pass);
        const resident::LightGroups& lights = draws_.lights();
        for (const VolumeGroup& group : volume_groups) {
            draws_.each(pass, lights.first[group.index()], lights.count[group.index()],
                        [&](uint32_t first, uint32_t count) {
                            for (uint32_t i = first; i < first + count; ++i)
                                draw_one(pass, group, i);
                        });
        }
    }

private:
    void draw_one(const graph::PassContext& pass, const VolumeGroup& group, uint32_t i) const {
        const auto& [mark, light] = pipelines_[group.index()];
        draws_.bind(pass, mark); // culls nothing
        volumes_.draw(pass.commands, group.spot, 1, i);
        // Back faces cover all that may be marked, wherever the camera is.
        draws_.bind(pass, light);
        vkCmdSetCullMode(pass.commands, VK_CULL_MODE_FRONT_BIT);
        volumes_.draw(pass.commands, group.spot, 1, i);
    }

    struct Pair {
        gpu::GraphicsPipeline mark, light;
    };
    LightDraws draws_;
    DeviceVolumes volumes_;
    std::array<Pair, resident::light_group_count> pipelines_;
};

} // namespace

void light_stencil_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                        const LightingInputs& inputs) {
    graph::Pass& pass = graph.pass(name);
    declare_lighting(graph, pass, inputs);
    pass.blends().stencil(inputs.surface.depth);
    draw_lights<StencilDraws>(pass, view, inputs);
}

} // namespace prelight::passes
