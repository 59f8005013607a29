#include "compute_pipeline.hpp"
#include "check.hpp"
#include "pipeline_library.hpp"

namespace prelight::gpu {

namespace {

std::shared_ptr<const BuiltPipeline> build(const Context& context, const ComputePipelineDesc& desc) {
    auto out = std::make_shared<BuiltPipeline>();
    out->layout = make_pipeline_layout(context, desc.name, desc.sets, VK_SHADER_STAGE_COMPUTE_BIT, desc.push_bytes);
    const ShaderStage stage(context, VK_SHADER_STAGE_COMPUTE_BIT, desc.shader, desc.constants);
    VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
    info.stage = stage.info();
    info.layout = out->layout;
    VkPipeline handle = VK_NULL_HANDLE;
    check(vkCreateComputePipelines(context.device(), context.pipeline_cache(), 1, &info, nullptr, &handle), desc.name);
    out->pipeline = {context.device(), handle};
    context.count_created(Context::Kind::pipeline);
    context.set_name(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<uint64_t>(handle), desc.name);
    return out;
}

} // namespace

ComputePipeline::ComputePipeline(const Context& context, const ComputePipelineDesc& desc)
    : built_(context.pipelines().find(desc, [&] { return build(context, desc); })) {}

void ComputePipeline::bind(VkCommandBuffer commands) const {
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, built_->pipeline);
}

void ComputePipeline::bind_set(VkCommandBuffer commands, uint32_t index, VkDescriptorSet set) const {
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, built_->layout, index, 1, &set, 0, nullptr);
}

void ComputePipeline::push(VkCommandBuffer commands, std::span<const std::byte> bytes) const {
    vkCmdPushConstants(commands, built_->layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, static_cast<uint32_t>(bytes.size()),
                       bytes.data());
}

} // namespace prelight::gpu
