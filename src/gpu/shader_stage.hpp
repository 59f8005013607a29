#pragma once
#include "context.hpp"
#include "shader_key.hpp"
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace prelight::gpu {

/// Values of specialisation constants: {constant id, value}. Booleans are 0 or 1.
using Constants = std::vector<std::pair<uint32_t, uint32_t>>;

/// One shader with its specialisation constants, in the form that pipeline creation wants.
class ShaderStage {
public:
    /// `key`: one of this build's shaders, or the name of `code` when there is some. Throws Error.
    ShaderStage(const Context& context, VkShaderStageFlagBits stage, const ShaderKey& key, const Constants& constants,
                std::span<const uint32_t> code = {});
    ShaderStage(const ShaderStage&) = delete;
    ShaderStage& operator=(const ShaderStage&) = delete;
    /// Points into this object.
    VkPipelineShaderStageCreateInfo info() const;

private:
    VkShaderStageFlagBits stage_;
    UniqueShaderModule module_;
    std::vector<VkSpecializationMapEntry> entries_;
    std::vector<uint32_t> values_;
    VkSpecializationInfo specialisation_{};
};

/// `push_bytes` of push constants for the stages `push`; 0: none.
UniquePipelineLayout make_pipeline_layout(const Context& context, std::string_view name,
                                          std::span<const VkDescriptorSetLayout> sets, VkShaderStageFlags push,
                                          uint32_t push_bytes);

/// What the handles of the classes for pipelines share.
struct BuiltPipeline {
    UniquePipelineLayout layout;
    UniquePipeline pipeline;
};

} // namespace prelight::gpu
