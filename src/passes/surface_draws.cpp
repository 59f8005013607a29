#include "surface_draws.hpp"
#include <cstddef>
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

using resident::VertexAttributes;

const std::vector<gpu::VertexAttribute> position_only{{VERTEX_POSITION, 0, VK_FORMAT_R32G32B32_SFLOAT, 0}};
const std::vector<gpu::VertexAttribute> all_attributes{
    position_only[0],
    {VERTEX_NORMAL, 1, VK_FORMAT_R32G32B32_SFLOAT, offsetof(VertexAttributes, normal)},
    {VERTEX_TANGENT, 1, VK_FORMAT_R32G32B32A32_SFLOAT, offsetof(VertexAttributes, tangent)},
    {VERTEX_TEXCOORD_0, 1, VK_FORMAT_R32G32_SFLOAT, offsetof(VertexAttributes, texcoord_0)},
    {VERTEX_TEXCOORD_1, 1, VK_FORMAT_R32G32_SFLOAT, offsetof(VertexAttributes, texcoord_1)},
    {VERTEX_COLOUR, 1, VK_FORMAT_R16G16B16A16_UNORM, offsetof(VertexAttributes, colour)}};

} // namespace

SurfaceDraws::SurfaceDraws(const resident::Frame& frame, const graph::PassInterface& interface,
                           const Desc& desc)
    : frame_(frame), features_kept_(desc.depth_only         ? FEATURE_ALPHA_MASK | FEATURE_BASE_COLOUR_TEXTURE
                                    : desc.keeps_alpha_mask ? ~0u
                                                            : ~FEATURE_ALPHA_MASK),
      motion_(desc.motion) {
    gpu::GraphicsPipelineDesc pipeline;
    pipeline.vertex_strides = {sizeof(glm::vec3), sizeof(VertexAttributes)};
    std::vector<gpu::VertexAttribute> shaded_attributes = all_attributes;
    if (motion_) {
        pipeline.vertex_strides.push_back(sizeof(glm::vec3));
        shaded_attributes.push_back({VERTEX_PREVIOUS_POSITION, 2, VK_FORMAT_R32G32B32_SFLOAT, 0});
    }
    pipeline.colour_formats = interface.colour_formats;
    pipeline.depth_format = interface.depth_format;
    pipeline.depth = desc.depth;
    pipeline.blend = desc.blend;
    pipeline.push_bytes = desc.push_bytes;
    pipeline.sets = {frame.layout(), interface.inputs, frame.materials().layout};
    for (const resident::Draw& draw : frame.geometry().draws) {
        const uint32_t features = key(draw);
        if (pipelines_.contains(features))
            continue;
        const bool shaded = !desc.depth_only || (features & FEATURE_ALPHA_MASK);
        pipeline.vertex = !shaded ? "depth_only.vert" : motion_ ? "surface+motion.vert" : "surface.vert";
        pipeline.fragment = shaded ? desc.fragment : "";
        pipeline.attributes = shaded ? shaded_attributes : position_only;
        pipeline.name = desc.name + " features " + std::to_string(features);
        pipeline.constants = desc.constants;
        pipeline.constants.emplace_back(CONSTANT_MATERIAL_FEATURES, features);
        pipelines_.emplace(features, gpu::GraphicsPipeline(frame.context(), pipeline));
    }
}

uint32_t SurfaceDraws::key(const resident::Draw& draw) const { return draw.features & features_kept_; }

void SurfaceDraws::bind_geometry(const graph::PassContext& pass) const {
    const resident::Geometry& geometry = frame_.geometry();
    const VkBuffer buffers[] = {geometry.positions.handle(), geometry.attributes.handle(), geometry.previous()};
    const VkDeviceSize offsets[] = {0, 0, 0};
    vkCmdBindVertexBuffers(pass.commands, 0, motion_ ? 3 : 2, buffers, offsets);
    vkCmdBindIndexBuffer(pass.commands, geometry.indices.handle(), 0, VK_INDEX_TYPE_UINT32);
}

void SurfaceDraws::draw(const graph::PassContext& pass, Bound& bound, const resident::Draw& draw,
                        std::span<const std::byte> push) const {
    const gpu::GraphicsPipeline& pipeline = pipelines_.at(key(draw));
    if (&pipeline != bound.pipeline) {
        pipeline.bind(pass.commands);
        pipeline.bind_set(pass.commands, SET_FRAME, frame_.set());
        pipeline.bind_set(pass.commands, SET_INPUTS, pass.inputs);
        bound = {&pipeline, no_image};
    }
    if (draw.material != bound.material) {
        pipeline.bind_set(pass.commands, SET_MATERIAL, frame_.materials().sets[draw.material]);
        bound.material = draw.material;
    }
    vkCmdSetCullMode(pass.commands, draw.double_sided ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT);
    vkCmdSetFrontFace(pass.commands, draw.mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
    if (!push.empty())
        pipeline.push(pass.commands, push);
    vkCmdDrawIndexed(pass.commands, draw.index_count, 1, draw.first_index, draw.vertex_offset, draw.object);
}

void SurfaceDraws::record(const graph::PassContext& pass) const {
    bind_geometry(pass);
    Bound bound;
    for (const resident::Draw& one : frame_.geometry().draws)
        draw(pass, bound, one);
}

void draw_surfaces(graph::Pass& pass, const resident::Frame& frame, const SurfaceDraws::Desc& desc) {
    auto draws = std::make_shared<std::optional<SurfaceDraws>>();
    pass.prepare([=, &frame](const graph::PassInterface& interface) { draws->emplace(frame, interface, desc); });
    pass.record([draws](const graph::PassContext& context) { (*draws)->record(context); });
}

} // namespace prelight::passes
