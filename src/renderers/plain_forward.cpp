// The unit F: one plain forward pass without lights, as cheap as it honestly can be. One draw an
// object that the view holds, nearest first; base colour under ambient light and emissive light, tone
// mapping in the same shader, straight into the final picture. Everything else is measured in units of it,
// so whatever makes it cheaper belongs here.
#include "plain_forward.hpp"
#include "device_renderer.hpp"
#include "settings/texture_settings.hpp"
#include <algorithm>
#include <cstddef>
#include <gpu/pipeline.hpp>
#include <shared/bindings.h>

namespace prelight {
namespace {

constexpr uint32_t textures = FEATURE_BASE_COLOUR_TEXTURE | FEATURE_EMISSIVE_TEXTURE;
constexpr uint32_t features = textures | FEATURE_ALPHA_MASK | FEATURE_UNLIT; ///< that the shaders know

class PlainForward final : public DeviceRenderer {
public:
    PlainForward(Device& device, const RenderOptions& options, Settings settings)
        : DeviceRenderer(device, options, std::move(settings)) {}
    ~PlainForward() override { finish(); } // frames in flight use its pipelines

private:
    uint64_t draws(const resident::View& view) const override { return view.visible().draws.size(); }

    Outputs build(graph::FrameGraph& graph, const resident::View& view) override {
        const auto depth = graph.image("depth", {VK_FORMAT_D32_SFLOAT, view.raster()});
        // What encodes while it stores saves the shader a power for each channel.
        const auto final = graph.image("final", view.raster(), {VK_FORMAT_R8G8B8A8_SRGB, VK_FORMAT_R8G8B8A8_UNORM});
        graph.pass("plain-forward")
            .colour(final, graph::Load::clear)
            .depth_write(depth)
            .prepare([this, &view](const graph::PassInterface& interface) { make_pipelines(view, interface); })
            .record([this, &view](const graph::PassContext& pass) { record(view, pass); });
        return {{"final", final}};
    }

    void make_pipelines(const resident::View& view, const graph::PassInterface& interface) {
        using resident::VertexAttributes;
        pipelines_.clear();
        gpu::GraphicsPipelineDesc desc;
        desc.vertex_strides = {sizeof(glm::vec3), sizeof(VertexAttributes), sizeof(shared::ObjectData)};
        desc.instance_binding = 2;
        desc.attachments = interface.attachments;
        desc.depth = gpu::DepthTest::write_nearer;
        desc.sets = {view.layout(), interface.inputs, view.scene().materials().layout};
        for (const resident::Draw& draw : view.scene().geometry().draws) {
            const uint32_t kind = draw.features & features;
            if (pipelines_.contains(kind))
                continue;
            const gpu::Variants variant = gpu::when((kind & textures) != 0, gpu::Variant::textured);
            desc.name = "plain forward features " + std::to_string(kind);
            desc.vertex = {"plain_forward.vert", variant};
            desc.fragment = {"plain_forward.frag", variant};
            desc.attributes = {{VERTEX_POSITION, 0, VK_FORMAT_R32G32B32_SFLOAT, 0},
                               {VERTEX_COLOUR, 1, VK_FORMAT_R16G16B16A16_UNORM, offsetof(VertexAttributes, colour)}};
            for (uint32_t row = 0; row < 3; ++row)
                desc.attributes.push_back(
                    {VERTEX_WORLD_ROW + row, 2, VK_FORMAT_R32G32B32A32_SFLOAT,
                     static_cast<uint32_t>(offsetof(shared::ObjectData, world_row) + row * sizeof(glm::vec4))});
            if (kind & textures) {
                desc.attributes.push_back(
                    {VERTEX_TEXCOORD_0, 1, VK_FORMAT_R32G32_SFLOAT, offsetof(VertexAttributes, texcoord_0)});
                desc.attributes.push_back(
                    {VERTEX_TEXCOORD_1, 1, VK_FORMAT_R32G32_SFLOAT, offsetof(VertexAttributes, texcoord_1)});
            }
            desc.constants = {{CONSTANT_MATERIAL_FEATURES, kind},
                              {CONSTANT_TONEMAP, static_cast<uint32_t>(options().tonemap)},
                              {CONSTANT_TARGET_ENCODES, desc.attachments.colours[0] == VK_FORMAT_R8G8B8A8_SRGB}};
            pipelines_.emplace(kind, gpu::GraphicsPipeline(view.context(), desc));
        }
    }

    /// What the view holds, nearest first, so that most hidden pixels are never shaded.
    void sort_visible(const resident::View& view) {
        const glm::mat4 rows = glm::transpose(view.clip_from_world());
        const glm::dvec3 depth(rows[3]); // w: view depth; the same everywhere for an orthographic camera
        const glm::dvec3 away = glm::dot(depth, depth) > 0 ? depth : -glm::dvec3(rows[2]);
        nearest_.clear();
        for (const resident::VisibleDraw& visible : view.visible().draws) {
            const resident::Draw& draw = view.scene().geometry().draws[visible.draw];
            nearest_.emplace_back(glm::dot(away, 0.5 * (draw.low + draw.high) - view.eye()), &visible);
        }
        std::ranges::stable_sort(nearest_, {}, &std::pair<double, const resident::VisibleDraw*>::first);
    }

    void record(const resident::View& view, const graph::PassContext& pass) {
        sort_visible(view);
        const resident::Geometry& geometry = view.scene().geometry();
        const VkBuffer buffers[] = {geometry.positions.handle(), geometry.attributes.handle(), view.objects()};
        const VkDeviceSize offsets[] = {0, 0, 0};
        vkCmdBindVertexBuffers(pass.commands, 0, 3, buffers, offsets);
        vkCmdBindIndexBuffer(pass.commands, geometry.indices.handle(), 0, VK_INDEX_TYPE_UINT32);
        const gpu::GraphicsPipeline* bound = nullptr;
        std::optional<uint32_t> material;
        for (const auto& [depth, visible] : nearest_) {
            const resident::Draw* draw = &geometry.draws[visible->draw];
            const gpu::GraphicsPipeline& pipeline = pipelines_.at(draw->features & features);
            if (&pipeline != bound) {
                pipeline.bind(pass.commands);
                pipeline.bind_set(pass.commands, SET_FRAME, view.set());
                pipeline.bind_set(pass.commands, SET_INPUTS, pass.inputs);
                bound = &pipeline;
                material.reset();
            }
            if (material != draw->material)
                pipeline.bind_set(pass.commands, SET_MATERIAL, view.scene().materials().sets[draw->material]);
            material = draw->material;
            vkCmdSetCullMode(pass.commands, draw->double_sided ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT);
            vkCmdSetFrontFace(pass.commands,
                              draw->mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
            vkCmdDrawIndexed(pass.commands, draw->index_count, 1, draw->first_index, draw->vertex_offset,
                             visible->instance);
        }
    }

    std::map<uint32_t, gpu::GraphicsPipeline> pipelines_;                  ///< by features
    std::vector<std::pair<double, const resident::VisibleDraw*>> nearest_; ///< with view depth of the middle
};

RendererInfo plain_forward_info() {
    return {.name = "plain-forward",
            .description = "one forward pass without lights: the unit F of bench",
            .settings = {texture_filter_setting()},
            .views = {"final"},
            .presets = {}};
}

} // namespace

std::unique_ptr<Renderer> make_plain_forward(Device& device, const RenderOptions& options) {
    return std::make_unique<PlainForward>(device, options, Settings(plain_forward_info(), options));
}

} // namespace prelight
