#include "pipeline.hpp"
#include "check.hpp"
#include "pipeline_library.hpp"
#include "shaders.hpp"
#include <optional>

namespace prelight::gpu {
namespace {

void set_stencil(VkPipelineDepthStencilStateCreateInfo& state, Stencil stencil) {
    state.stencilTestEnable = stencil != Stencil::none;
    for (VkStencilOpState* face : {&state.front, &state.back}) {
        face->failOp = face->passOp = face->depthFailOp = VK_STENCIL_OP_KEEP;
        face->compareOp = VK_COMPARE_OP_ALWAYS;
        face->compareMask = face->writeMask = 0xff;
    }
    switch (stencil) {
    case Stencil::none: break;
    case Stencil::mark_passing:
        state.front.passOp = VK_STENCIL_OP_INCREMENT_AND_WRAP;
        state.back.passOp = VK_STENCIL_OP_DECREMENT_AND_WRAP;
        break;
    case Stencil::mark_failing:
        state.back.depthFailOp = VK_STENCIL_OP_INCREMENT_AND_WRAP;
        state.front.depthFailOp = VK_STENCIL_OP_DECREMENT_AND_WRAP;
        break;
    case Stencil::exported: state.front.passOp = state.back.passOp = VK_STENCIL_OP_REPLACE; break;
    case Stencil::marked_to_zero:
        for (VkStencilOpState* face : {&state.front, &state.back}) {
            face->compareOp = VK_COMPARE_OP_NOT_EQUAL;
            face->passOp = face->depthFailOp = VK_STENCIL_OP_ZERO;
        }
        break;
    }
}

VkPipelineDepthStencilStateCreateInfo depth_state(DepthTest test) {
    VkPipelineDepthStencilStateCreateInfo state{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
    state.depthTestEnable = test != DepthTest::none;
    state.depthWriteEnable =
        test == DepthTest::write_nearer || test == DepthTest::write_farther || test == DepthTest::overwrite;
    switch (test) {
    case DepthTest::none:
    case DepthTest::overwrite: state.depthCompareOp = VK_COMPARE_OP_ALWAYS; break;
    case DepthTest::write_nearer: state.depthCompareOp = VK_COMPARE_OP_GREATER_OR_EQUAL; break;
    case DepthTest::equal: state.depthCompareOp = VK_COMPARE_OP_EQUAL; break;
    case DepthTest::behind: state.depthCompareOp = VK_COMPARE_OP_GREATER; break;
    case DepthTest::behind_or_at: state.depthCompareOp = VK_COMPARE_OP_GREATER_OR_EQUAL; break;
    case DepthTest::write_farther:
    case DepthTest::before_or_at: state.depthCompareOp = VK_COMPARE_OP_LESS_OR_EQUAL; break;
    case DepthTest::surface_only: state.depthCompareOp = VK_COMPARE_OP_LESS; break;
    }
    return state;
}

std::vector<VkPipelineColorBlendAttachmentState> blend_states(const GraphicsPipelineDesc& desc) {
    VkPipelineColorBlendAttachmentState state{};
    state.blendEnable = desc.blend != Blend::none && desc.blend != Blend::alpha_only;
    state.srcColorBlendFactor = state.dstColorBlendFactor = VK_BLEND_FACTOR_ONE;
    state.srcAlphaBlendFactor = state.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
    if (desc.blend == Blend::over || desc.blend == Blend::add_and_cover) {
        state.srcAlphaBlendFactor = VK_BLEND_FACTOR_ZERO;
        state.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
    }
    if (desc.blend == Blend::over)
        state.dstColorBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
    if (desc.blend == Blend::by_alpha || desc.blend == Blend::add_by_alpha)
        state.srcColorBlendFactor = VK_BLEND_FACTOR_SRC_ALPHA;
    if (desc.blend == Blend::by_alpha)
        state.dstColorBlendFactor = state.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
    if (desc.blend == Blend::add_by_alpha)
        state.srcAlphaBlendFactor = VK_BLEND_FACTOR_ZERO;
    state.colorBlendOp = state.alphaBlendOp = VK_BLEND_OP_ADD;
    if (desc.blend == Blend::transmit) {
        state.srcColorBlendFactor = VK_BLEND_FACTOR_DST_COLOR;
        state.dstColorBlendFactor = VK_BLEND_FACTOR_ZERO;
        state.alphaBlendOp = VK_BLEND_OP_MAX;
    }
    state.colorWriteMask = desc.fragment.empty() ? 0 : desc.blend == Blend::alpha_only ? VK_COLOR_COMPONENT_A_BIT : 0xf;
    return std::vector<VkPipelineColorBlendAttachmentState>(desc.attachments.colours.size(), state);
}

std::shared_ptr<const BuiltPipeline> build(const Context& context, const GraphicsPipelineDesc& desc) {
    auto out = std::make_shared<BuiltPipeline>();
    out->layout = make_pipeline_layout(context, desc.name, desc.sets, desc.push_stage, desc.push_bytes);
    const ShaderStage vertex(context, VK_SHADER_STAGE_VERTEX_BIT, desc.vertex, desc.constants);
    std::vector<VkPipelineShaderStageCreateInfo> stages{vertex.info()};
    const bool per_sample =
        desc.sample_shading == SampleShading::sample && desc.attachments.samples > 1 && !desc.fragment.empty();
    std::vector<uint32_t> code = desc.fragment_code;
    if (per_sample)
        code = with_sample_inputs(code.empty() ? find_shader(desc.fragment) : code);
    else if (desc.post_depth_coverage)
        code = with_post_depth_coverage(code.empty() ? find_shader(desc.fragment) : code);
    std::optional<ShaderStage> fragment;
    if (!desc.fragment.empty())
        stages.push_back(
            fragment.emplace(context, VK_SHADER_STAGE_FRAGMENT_BIT, desc.fragment, desc.constants, code).info());

    std::vector<VkVertexInputBindingDescription> bindings;
    for (const uint32_t stride : desc.vertex_strides) {
        const auto binding = static_cast<uint32_t>(bindings.size());
        bindings.push_back(
            {binding, stride,
             binding == desc.instance_binding ? VK_VERTEX_INPUT_RATE_INSTANCE : VK_VERTEX_INPUT_RATE_VERTEX});
    }
    std::vector<VkVertexInputAttributeDescription> attributes;
    for (const VertexAttribute& a : desc.attributes)
        attributes.push_back({a.location, a.binding, a.format, a.offset});
    VkPipelineVertexInputStateCreateInfo input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    input.vertexBindingDescriptionCount = static_cast<uint32_t>(bindings.size());
    input.pVertexBindingDescriptions = bindings.data();
    input.vertexAttributeDescriptionCount = static_cast<uint32_t>(attributes.size());
    input.pVertexAttributeDescriptions = attributes.data();

    VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
    viewport.viewportCount = viewport.scissorCount = 1;
    VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
    raster.lineWidth = 1;
    raster.depthBiasEnable = desc.slope_bias > 0;
    raster.depthBiasSlopeFactor = -desc.slope_bias; // reversed depth
    raster.depthClampEnable = desc.depth_clamp && context.features().depth_clamp;
    VkPipelineMultisampleStateCreateInfo samples{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
    samples.rasterizationSamples = static_cast<VkSampleCountFlagBits>(desc.attachments.samples);
    samples.sampleShadingEnable = per_sample;
    samples.minSampleShading = 1;
    const VkSampleMask mask = desc.sample_mask;
    if (mask != ~0u)
        samples.pSampleMask = &mask;
    VkPipelineDepthStencilStateCreateInfo depth = depth_state(desc.depth);
    depth.depthBoundsTestEnable = desc.depth_bounds;
    set_stencil(depth, desc.stencil);
    const auto blends = blend_states(desc);
    VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
    blend.attachmentCount = static_cast<uint32_t>(blends.size());
    blend.pAttachments = blends.data();
    std::vector<VkDynamicState> dynamic_states{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                               VK_DYNAMIC_STATE_CULL_MODE, VK_DYNAMIC_STATE_FRONT_FACE};
    if (desc.depth_bounds)
        dynamic_states.push_back(VK_DYNAMIC_STATE_DEPTH_BOUNDS);
    VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
    dynamic.dynamicStateCount = static_cast<uint32_t>(dynamic_states.size());
    dynamic.pDynamicStates = dynamic_states.data();

    VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
    rendering.colorAttachmentCount = static_cast<uint32_t>(desc.attachments.colours.size());
    rendering.pColorAttachmentFormats = desc.attachments.colours.data();
    rendering.depthAttachmentFormat = desc.attachments.depth;
    rendering.stencilAttachmentFormat = desc.attachments.stencil;

    VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO, &rendering};
    info.stageCount = static_cast<uint32_t>(stages.size());
    info.pStages = stages.data();
    info.pVertexInputState = &input;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &samples;
    info.pDepthStencilState = &depth;
    info.pColorBlendState = &blend;
    info.pDynamicState = &dynamic;
    info.layout = out->layout;
    VkPipeline handle = VK_NULL_HANDLE;
    check(vkCreateGraphicsPipelines(context.device(), context.pipeline_cache(), 1, &info, nullptr, &handle), desc.name);
    out->pipeline = {context.device(), handle};
    context.count_created(Context::Kind::pipeline);
    context.set_name(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<uint64_t>(handle), desc.name);
    return out;
}

} // namespace

GraphicsPipeline::GraphicsPipeline(const Context& context, const GraphicsPipelineDesc& desc)
    : built_(context.pipelines().find(desc, [&] { return build(context, desc); })), push_stage_(desc.push_stage) {}

void GraphicsPipeline::bind(VkCommandBuffer commands) const {
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, built_->pipeline);
    vkCmdSetCullMode(commands, VK_CULL_MODE_NONE);
    vkCmdSetFrontFace(commands, VK_FRONT_FACE_COUNTER_CLOCKWISE);
}

void GraphicsPipeline::bind_set(VkCommandBuffer commands, uint32_t index, VkDescriptorSet set) const {
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, built_->layout, index, 1, &set, 0, nullptr);
}

void GraphicsPipeline::push(VkCommandBuffer commands, std::span<const std::byte> bytes) const {
    vkCmdPushConstants(commands, built_->layout, push_stage_, 0, static_cast<uint32_t>(bytes.size()), bytes.data());
}

} // namespace prelight::gpu
