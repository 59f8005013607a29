#include "shader_stage.hpp"
#include "check.hpp"
#include "shaders.hpp"

namespace prelight::gpu {
namespace {

UniqueShaderModule make_module(const Context& context, const std::string& name, std::span<const uint32_t> code) {
    VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    info.codeSize = code.size_bytes();
    info.pCode = code.data();
    VkShaderModule handle = VK_NULL_HANDLE;
    check(vkCreateShaderModule(context.device(), &info, nullptr, &handle), name);
    context.set_name(VK_OBJECT_TYPE_SHADER_MODULE, reinterpret_cast<uint64_t>(handle), name);
    return {context.device(), handle};
}

} // namespace

ShaderStage::ShaderStage(const Context& context, VkShaderStageFlagBits stage, const ShaderKey& key,
                         const Constants& constants, std::span<const uint32_t> code)
    : stage_(stage), module_(make_module(context, key.text(), code.empty() ? find_shader(key) : code)) {
    for (const auto& [id, value] : constants) {
        entries_.push_back({id, static_cast<uint32_t>(values_.size() * 4), 4});
        values_.push_back(value);
    }
    specialisation_ = {static_cast<uint32_t>(entries_.size()), entries_.data(), values_.size() * 4, values_.data()};
}

VkPipelineShaderStageCreateInfo ShaderStage::info() const {
    VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
    info.stage = stage_;
    info.module = module_;
    info.pName = "main";
    info.pSpecializationInfo = &specialisation_;
    return info;
}

UniquePipelineLayout make_pipeline_layout(const Context& context, std::string_view name,
                                          std::span<const VkDescriptorSetLayout> sets, VkShaderStageFlags push,
                                          uint32_t push_bytes) {
    VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    info.setLayoutCount = static_cast<uint32_t>(sets.size());
    info.pSetLayouts = sets.data();
    const VkPushConstantRange range{push, 0, push_bytes};
    info.pushConstantRangeCount = push_bytes > 0 ? 1 : 0;
    info.pPushConstantRanges = &range;
    VkPipelineLayout handle = VK_NULL_HANDLE;
    check(vkCreatePipelineLayout(context.device(), &info, nullptr, &handle), name);
    context.set_name(VK_OBJECT_TYPE_PIPELINE_LAYOUT, reinterpret_cast<uint64_t>(handle), name);
    return {context.device(), handle};
}

} // namespace prelight::gpu
