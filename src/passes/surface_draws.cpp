#include "surface_draws.hpp"
#include <cstddef>
#include <shared/bindings.h>

namespace prelight::passes {

SurfaceDraws::SurfaceDraws(const resident::Frame& frame, const graph::PassInterface& interface,
                           const Desc& desc)
    : frame_(frame), ignored_features_(desc.keeps_alpha_mask ? 0 : FEATURE_ALPHA_MASK) {
    using resident::VertexAttributes;
    gpu::GraphicsPipelineDesc pipeline;
    pipeline.vertex = "surface.vert";
    pipeline.fragment = desc.fragment;
    pipeline.vertex_strides = {sizeof(glm::vec3), sizeof(VertexAttributes)};
    pipeline.attributes = {
        {VERTEX_POSITION, 0, VK_FORMAT_R32G32B32_SFLOAT, 0},
        {VERTEX_NORMAL, 1, VK_FORMAT_R32G32B32_SFLOAT, offsetof(VertexAttributes, normal)},
        {VERTEX_TANGENT, 1, VK_FORMAT_R32G32B32A32_SFLOAT, offsetof(VertexAttributes, tangent)},
        {VERTEX_TEXCOORD_0, 1, VK_FORMAT_R32G32_SFLOAT, offsetof(VertexAttributes, texcoord_0)},
        {VERTEX_TEXCOORD_1, 1, VK_FORMAT_R32G32_SFLOAT, offsetof(VertexAttributes, texcoord_1)},
        {VERTEX_COLOUR, 1, VK_FORMAT_R16G16B16A16_UNORM, offsetof(VertexAttributes, colour)}};
    pipeline.colour_formats = interface.colour_formats;
    pipeline.depth_format = interface.depth_format;
    pipeline.depth = desc.depth;
    pipeline.sets = {frame.layout(), interface.inputs, frame.materials().layout};
    for (const resident::Draw& draw : frame.geometry().draws) {
        const uint32_t features = key(draw);
        if (pipelines_.contains(features))
            continue;
        pipeline.name = desc.name + " features " + std::to_string(features);
        pipeline.constants = desc.constants;
        pipeline.constants.emplace_back(CONSTANT_MATERIAL_FEATURES, features);
        pipelines_.emplace(features, gpu::GraphicsPipeline(frame.context(), pipeline));
    }
}

uint32_t SurfaceDraws::key(const resident::Draw& draw) const { return draw.features & ~ignored_features_; }

void SurfaceDraws::record(const graph::PassContext& pass) const {
    const resident::Geometry& geometry = frame_.geometry();
    const VkBuffer buffers[] = {geometry.positions.handle(), geometry.attributes.handle()};
    const VkDeviceSize offsets[] = {0, 0};
    vkCmdBindVertexBuffers(pass.commands, 0, 2, buffers, offsets);
    vkCmdBindIndexBuffer(pass.commands, geometry.indices.handle(), 0, VK_INDEX_TYPE_UINT32);
    const gpu::GraphicsPipeline* bound = nullptr;
    uint32_t material = no_image;
    for (const resident::Draw& draw : geometry.draws) {
        const gpu::GraphicsPipeline& pipeline = pipelines_.at(key(draw));
        if (&pipeline != bound) {
            pipeline.bind(pass.commands);
            pipeline.bind_set(pass.commands, SET_FRAME, frame_.set());
            pipeline.bind_set(pass.commands, SET_INPUTS, pass.inputs);
            bound = &pipeline;
            material = no_image;
        }
        if (draw.material != material) {
            pipeline.bind_set(pass.commands, SET_MATERIAL, frame_.materials().sets[draw.material]);
            material = draw.material;
        }
        vkCmdSetCullMode(pass.commands, draw.double_sided ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT);
        vkCmdSetFrontFace(pass.commands,
                          draw.mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
        vkCmdDrawIndexed(pass.commands, draw.index_count, 1, draw.first_index, draw.vertex_offset, draw.object);
    }
}

} // namespace prelight::passes
