#include "light_volumes.hpp"
#include "volume_meshes.hpp"
#include <array>
#include <gpu/pipeline.hpp>
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

using resident::LightGroup;

struct DeviceMesh {
    gpu::Buffer points, indices;
    uint32_t count = 0;

    DeviceMesh(const gpu::Context& context, const char* name, const VolumeMesh& mesh)
        : points(gpu::make_device_buffer(context, name, std::as_bytes(std::span(mesh.points)),
                                         VK_BUFFER_USAGE_VERTEX_BUFFER_BIT)),
          indices(gpu::make_device_buffer(context, name, std::as_bytes(std::span(mesh.indices)),
                                          VK_BUFFER_USAGE_INDEX_BUFFER_BIT)),
          count(static_cast<uint32_t>(mesh.indices.size())) {}
};

/// How the lights of a group are drawn.
struct GroupState {
    LightGroup group;
    const char* name;
    uint32_t volume;         ///< VOLUME_…, ignored for full screen
    gpu::DepthTest depth;
    VkCullModeFlags cull;
};
// From outside the front faces find surfaces behind them; from inside, or when the near plane cuts
// the volume, the back faces find surfaces before them: each pixel once, and no hole.
constexpr std::array<GroupState, resident::light_group_count> groups{{
    {LightGroup::fullscreen, "full-screen lights", 0, gpu::DepthTest::surface_only, VK_CULL_MODE_NONE},
    {LightGroup::sphere_outside, "spheres from outside", VOLUME_SPHERE, gpu::DepthTest::behind_or_at, VK_CULL_MODE_BACK_BIT},
    {LightGroup::sphere_inside, "spheres from inside", VOLUME_SPHERE, gpu::DepthTest::before_or_at, VK_CULL_MODE_FRONT_BIT},
    {LightGroup::cone_outside, "cones from outside", VOLUME_CONE, gpu::DepthTest::behind_or_at, VK_CULL_MODE_BACK_BIT},
    {LightGroup::cone_inside, "cones from inside", VOLUME_CONE, gpu::DepthTest::before_or_at, VK_CULL_MODE_FRONT_BIT},
}};

class VolumeDraws {
public:
    VolumeDraws(const resident::Frame& frame, const graph::PassInterface& interface, const LightingInputs& inputs)
        : frame_(frame), sphere_(frame.context(), "sphere volume", sphere_volume()),
          cone_(frame.context(), "cone volume", cone_volume(resident::cone_sides)) {
        if (inputs.model.ambient_as_light && inputs.target.variant != "+count") {
            gpu::GraphicsPipelineDesc desc = lighting_pipeline(frame, interface, inputs, "light_ambient");
            desc.name = "ambient light";
            desc.vertex = "light_fullscreen.vert";
            desc.depth = gpu::DepthTest::surface_only;
            desc.blend = gpu::Blend::add;
            ambient_ = gpu::GraphicsPipeline(frame.context(), desc);
            has_ambient_ = true;
        }
        for (const GroupState& state : groups) {
            const bool volume = state.group != LightGroup::fullscreen;
            gpu::GraphicsPipelineDesc desc = lighting_pipeline(frame, interface, inputs, "light");
            desc.name = state.name;
            desc.vertex = volume ? "light_volume.vert" : "light_fullscreen.vert";
            desc.depth = state.depth;
            desc.depth_clamp = true;
            desc.blend = gpu::Blend::add;
            if (volume) {
                desc.constants.emplace_back(CONSTANT_VOLUME, state.volume);
                desc.vertex_strides = {sizeof(glm::vec3)};
                desc.attributes = {{VERTEX_POSITION, 0, VK_FORMAT_R32G32B32_SFLOAT, 0}};
            }
            pipelines_[static_cast<size_t>(state.group)] = gpu::GraphicsPipeline(frame.context(), desc);
        }
    }

    void record(const graph::PassContext& pass) const {
        if (has_ambient_) {
            bind(pass, ambient_);
            vkCmdDraw(pass.commands, 3, 1, 0, 0);
        }
        const resident::LightGroups& lights = frame_.lights();
        for (const GroupState& state : groups) {
            const size_t g = static_cast<size_t>(state.group);
            if (lights.count[g] == 0)
                continue;
            bind(pass, pipelines_[g]);
            vkCmdSetCullMode(pass.commands, state.cull);
            if (state.group == LightGroup::fullscreen) {
                vkCmdDraw(pass.commands, 3, lights.count[g], 0, lights.first[g]);
                continue;
            }
            const DeviceMesh& mesh = state.volume == VOLUME_CONE ? cone_ : sphere_;
            const VkBuffer points = mesh.points.handle();
            const VkDeviceSize offset = 0;
            vkCmdBindVertexBuffers(pass.commands, 0, 1, &points, &offset);
            vkCmdBindIndexBuffer(pass.commands, mesh.indices.handle(), 0, VK_INDEX_TYPE_UINT32);
            vkCmdDrawIndexed(pass.commands, mesh.count, lights.count[g], 0, 0, lights.first[g]);
        }
    }

private:
    void bind(const graph::PassContext& pass, const gpu::GraphicsPipeline& pipeline) const {
        pipeline.bind(pass.commands);
        pipeline.bind_set(pass.commands, SET_FRAME, frame_.set());
        pipeline.bind_set(pass.commands, SET_INPUTS, pass.inputs);
    }
    const resident::Frame& frame_;
    DeviceMesh sphere_, cone_;
    gpu::GraphicsPipeline ambient_;
    bool has_ambient_ = false;
    std::array<gpu::GraphicsPipeline, resident::light_group_count> pipelines_;
};

} // namespace

void light_volume_pass(graph::FrameGraph& graph, const resident::Frame& frame, const std::string& name,
                       const LightingInputs& inputs) {
    graph::Pass& pass = graph.pass(name);
    declare_lighting(graph, pass, inputs);
    pass.blends().depth_test(inputs.surface.depth);
    auto draws = std::make_shared<std::optional<VolumeDraws>>();
    pass.prepare([=, &frame](const graph::PassInterface& interface) { draws->emplace(frame, interface, inputs); });
    pass.record([draws](const graph::PassContext& context) { (*draws)->record(context); });
}

} // namespace prelight::passes
