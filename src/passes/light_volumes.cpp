#include "light_volumes.hpp"
#include "device_volumes.hpp"
#include "light_draws.hpp"

namespace prelight::passes {
namespace {

class VolumeDraws {
public:
    VolumeDraws(const resident::View& view, const graph::PassInterface& interface, const LightingInputs& inputs)
        : draws_(view, interface, inputs), volumes_(view) {
        for (const VolumeGroup& group : volume_groups) {
            gpu::GraphicsPipelineDesc desc = draws_.pipeline(group.name, "");
            volumes_.describe(desc, group.spot);
            // From outside the front faces find surfaces behind them; from inside, or when the near
            // plane cuts the volume, the back faces find surfaces before them: each pixel once, no hole.
            desc.depth = !view.volumes().depth_test ? gpu::DepthTest::none
                         : group.inside             ? gpu::DepthTest::before_or_at
                                                    : gpu::DepthTest::behind_or_at;
            pipelines_[group.index()] = gpu::GraphicsPipeline(view.context(), desc);
        }
    }

    void record(const graph::PassContext& pass) const {
        draws_.record_fullscreen(pass);
        const resident::LightGroups& lights = draws_.lights();
        for (const VolumeGroup& group : volume_groups) {
            const size_t g = group.index();
            draws_.each(pass, lights.first[g], lights.count[g], [&](uint32_t first, uint32_t count) {
                draws_.bind(pass, pipelines_[g]);
                vkCmdSetCullMode(pass.commands, group.inside ? VK_CULL_MODE_FRONT_BIT : VK_CULL_MODE_BACK_BIT);
                volumes_.draw(pass.commands, group.spot, count, first);
            });
        }
    }

private:
    LightDraws draws_;
    DeviceVolumes volumes_;
    std::array<gpu::GraphicsPipeline, resident::light_group_count> pipelines_;
};

} // namespace

void light_volume_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                       const LightingInputs& inputs) {
    graph::Pass& pass = graph.pass(name);
    declare_lighting(graph, pass, inputs);
    pass.blends().depth_test(inputs.surface.depth);
    draw_lights<VolumeDraws>(pass, view, inputs);
}

} // namespace prelight::passes
