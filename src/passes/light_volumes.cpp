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
    VolumeDraws(const resident::Frame& frame, const graph::PassInterface& interface,
                const LightVolumeInputs& inputs, uint32_t output)
        : frame_(frame), sphere_(frame.context(), "sphere volume", sphere_volume()),
          cone_(frame.context(), "cone volume", cone_volume(resident::cone_sides)) {
        gpu::GraphicsPipelineDesc desc;
        desc.constants = inputs.surface.format.constants();
        const gpu::Constants model = inputs.model.constants();
        desc.constants.insert(desc.constants.end(), model.begin(), model.end());
        desc.constants.insert(desc.constants.end(), {{CONSTANT_COUNT_PAIRS, inputs.count_pairs},
                                                     {CONSTANT_LIGHT_OUTPUT, output},
                                                     {CONSTANT_SEED_FALLOFF, frame.seed_falloff()}});
        desc.colour_formats = interface.colour_formats;
        desc.depth_format = interface.depth_format;
        desc.blend = gpu::Blend::add;
        desc.depth_clamp = true;
        desc.sets = {frame.layout(), interface.inputs};
        const std::string variant = interface.colour_formats.size() == 1 ? "+packed.frag" : ".frag";
        if (inputs.model.ambient_as_light && output == LIGHT_OUTPUT_LIGHT) {
            desc.name = "ambient light";
            desc.vertex = "light_fullscreen.vert";
            desc.fragment = "light_ambient" + variant;
            desc.depth = gpu::DepthTest::surface_only;
            ambient_ = gpu::GraphicsPipeline(frame.context(), desc);
            has_ambient_ = true;
        }
        desc.fragment = "light" + variant;
        const gpu::Constants base = desc.constants;
        for (const GroupState& state : groups) {
            const bool volume = state.group != LightGroup::fullscreen;
            desc.name = state.name;
            desc.vertex = volume ? "light_volume.vert" : "light_fullscreen.vert";
            desc.depth = state.depth;
            desc.constants = base;
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

void declare(graph::FrameGraph& graph, graph::Pass& pass, const resident::Frame& frame,
             const LightVolumeInputs& inputs, uint32_t output) {
    pass.depth_test(inputs.surface.depth)
        .sample(INPUT_DEPTH, inputs.surface.depth_source)
        .sample(INPUT_NORMAL, inputs.surface.normal)
        .sample(INPUT_ROUGHNESS, inputs.surface.roughness)
        .storage(INPUT_PAIR_COUNTERS, graph.buffer("pair counters", *inputs.pair_counters),
                 inputs.count_pairs);
    auto draws = std::make_shared<std::optional<VolumeDraws>>();
    pass.prepare([=, &frame](const graph::PassInterface& interface) {
        draws->emplace(frame, interface, inputs, output);
    });
    pass.record([draws](const graph::PassContext& context) { (*draws)->record(context); });
}

} // namespace

gpu::Constants LightModel::constants() const {
    return {{CONSTANT_SHADING, shading == Shading::ggx ? SHADING_GGX : SHADING_PHONG},
            {CONSTANT_MODEL, static_cast<uint32_t>(fresnel)},
            {CONSTANT_PACKED_LIGHT, packed()},
            {CONSTANT_SPECULAR_STEP_GATE, step_gate},
            {CONSTANT_REFLECTION_VECTOR, reflection_vector},
            {CONSTANT_AMBIENT_AS_LIGHT, ambient_as_light}};
}

LightBuffer light_volume_pass(graph::FrameGraph& graph, const resident::Frame& frame,
                              const LightVolumeInputs& inputs) {
    const bool bytes = inputs.model.buffer == LightBufferFormat::packed_rgba8;
    const VkFormat format = bytes ? VK_FORMAT_R8G8B8A8_UNORM : VK_FORMAT_R16G16B16A16_SFLOAT;
    LightBuffer out;
    out.diffuse = out.specular = graph.image("diffuse light", {format, frame.extent()});
    graph::Pass& pass = graph.pass("light");
    pass.colour(out.diffuse, graph::Load::clear);
    if (!inputs.model.packed()) {
        out.specular = graph.image("specular light", {format, frame.extent()});
        pass.colour(out.specular, graph::Load::clear);
    }
    declare(graph, pass, frame, inputs, LIGHT_OUTPUT_LIGHT);
    return out;
}

graph::ImageId light_count_pass(graph::FrameGraph& graph, const resident::Frame& frame,
                                const LightVolumeInputs& inputs) {
    const graph::ImageId counts = graph.image("light count", {VK_FORMAT_R16G16B16A16_SFLOAT, frame.extent()});
    graph::Pass& pass = graph.pass("light-count");
    pass.colour(counts, graph::Load::clear);
    LightVolumeInputs uncounted = inputs;
    uncounted.count_pairs = false;
    declare(graph, pass, frame, uncounted, LIGHT_OUTPUT_COUNT);
    return counts;
}

} // namespace prelight::passes
