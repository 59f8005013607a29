#include "programs.hpp"
#include <gpu/check.hpp>
#include <gpu/shaders.hpp>

namespace prelight {
namespace {

constexpr VkShaderStageFlags push_stages = VK_SHADER_STAGE_FRAGMENT_BIT | VK_SHADER_STAGE_COMPUTE_BIT;

gpu::UniqueShaderModule make_module(const gpu::Context& context, std::span<const uint32_t> code) {
    VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    info.codeSize = code.size_bytes();
    info.pCode = code.data();
    VkShaderModule handle = VK_NULL_HANDLE;
    gpu::check(vkCreateShaderModule(context.device(), &info, nullptr, &handle), "test shader");
    return {context.device(), handle};
}

VkPipelineShaderStageCreateInfo stage_info(VkShaderStageFlagBits stage, VkShaderModule shader) {
    VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
    info.stage = stage;
    info.module = shader;
    info.pName = "main";
    return info;
}

} // namespace

Program::Program(const gpu::Context& context, std::string_view shader, VkDescriptorSetLayout set,
                 const gpu::Attachments& attachments) {
    const VkPushConstantRange range{push_stages, 0, 16};
    VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    info.setLayoutCount = 1;
    info.pSetLayouts = &set;
    info.pushConstantRangeCount = 1;
    info.pPushConstantRanges = &range;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    gpu::check(vkCreatePipelineLayout(context.device(), &info, nullptr, &layout), shader);
    layout_ = {context.device(), layout};
    const gpu::UniqueShaderModule code = make_module(context, gpu::find_test_shader(std::string(shader)));
    if (attachments.colours.empty())
        make_compute(context, code);
    else
        make_graphics(context, code, attachments);
}

void Program::make_compute(const gpu::Context& context, VkShaderModule shader) {
    VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
    info.stage = stage_info(VK_SHADER_STAGE_COMPUTE_BIT, shader);
    info.layout = layout_;
    VkPipeline handle = VK_NULL_HANDLE;
    gpu::check(vkCreateComputePipelines(context.device(), context.pipeline_cache(), 1, &info, nullptr, &handle),
               "test pipeline");
    pipeline_ = {context.device(), handle};
}

void Program::make_graphics(const gpu::Context& context, VkShaderModule shader, const gpu::Attachments& attachments) {
    point_ = VK_PIPELINE_BIND_POINT_GRAPHICS;
    const gpu::UniqueShaderModule vertex = make_module(context, gpu::find_shader("fullscreen.vert"));
    const std::array stages{stage_info(VK_SHADER_STAGE_VERTEX_BIT, vertex),
                            stage_info(VK_SHADER_STAGE_FRAGMENT_BIT, shader)};
    const VkPipelineVertexInputStateCreateInfo input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
    viewport.viewportCount = viewport.scissorCount = 1;
    VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
    raster.lineWidth = 1;
    VkPipelineMultisampleStateCreateInfo samples{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
    samples.rasterizationSamples = static_cast<VkSampleCountFlagBits>(attachments.samples);
    VkPipelineColorBlendAttachmentState write_all{};
    write_all.colorWriteMask = 0xf;
    const std::vector<VkPipelineColorBlendAttachmentState> writes(attachments.colours.size(), write_all);
    VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
    blend.attachmentCount = static_cast<uint32_t>(writes.size());
    blend.pAttachments = writes.data();
    const std::array states{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
    dynamic.dynamicStateCount = static_cast<uint32_t>(states.size());
    dynamic.pDynamicStates = states.data();
    VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
    rendering.colorAttachmentCount = static_cast<uint32_t>(attachments.colours.size());
    rendering.pColorAttachmentFormats = attachments.colours.data();
    VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO, &rendering};
    info.stageCount = static_cast<uint32_t>(stages.size());
    info.pStages = stages.data();
    info.pVertexInputState = &input;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &samples;
    info.pColorBlendState = &blend;
    info.pDynamicState = &dynamic;
    info.layout = layout_;
    VkPipeline handle = VK_NULL_HANDLE;
    gpu::check(vkCreateGraphicsPipelines(context.device(), context.pipeline_cache(), 1, &info, nullptr, &handle),
               "test pipeline");
    pipeline_ = {context.device(), handle};
}

void Program::run(VkCommandBuffer commands, VkDescriptorSet set, std::array<float, 4> push, uint32_t groups_x,
                  uint32_t groups_y) const {
    vkCmdBindPipeline(commands, point_, pipeline_);
    vkCmdBindDescriptorSets(commands, point_, layout_, 0, 1, &set, 0, nullptr);
    vkCmdPushConstants(commands, layout_, push_stages, 0, 16, push.data());
    if (point_ == VK_PIPELINE_BIND_POINT_COMPUTE)
        vkCmdDispatch(commands, groups_x, groups_y, 1);
    else
        vkCmdDraw(commands, 3, 1, 0, 0);
}

void run_program(graph::Pass& pass, const gpu::Context& context, const std::string& shader, std::array<float, 4> push,
                 uint32_t groups_x, uint32_t groups_y) {
    auto program = std::make_shared<std::unique_ptr<Program>>();
    pass.prepare([=, &context](const graph::PassInterface& interface) {
        *program = std::make_unique<Program>(context, shader, interface.inputs, interface.attachments);
    });
    pass.record([=](const graph::PassContext& pass_context) {
        (*program)->run(pass_context.commands, pass_context.inputs, push, groups_x, groups_y);
    });
}

void run_frame(const gpu::Context& context, graph::FrameGraph& graph) {
    context.run("frame", [&](VkCommandBuffer commands) { graph.record(commands); });
}

} // namespace prelight
