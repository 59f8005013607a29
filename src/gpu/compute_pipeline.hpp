#pragma once
#include "shader_stage.hpp"
#include <compare>
#include <memory>

namespace prelight::gpu {

struct ComputePipelineDesc {
    std::string name;
    ShaderKey shader;
    Constants constants;
    std::vector<VkDescriptorSetLayout> sets;
    uint32_t push_bytes = 0;                                      ///< push constants; at most 128
    auto operator<=>(const ComputePipelineDesc&) const = default; ///< what is equal is one pipeline
};

/// A handle, as GraphicsPipeline.
class ComputePipeline {
public:
    ComputePipeline() = default;
    ComputePipeline(const Context& context, const ComputePipelineDesc& desc);
    void bind(VkCommandBuffer commands) const;
    void bind_set(VkCommandBuffer commands, uint32_t index, VkDescriptorSet set) const;
    /// All `push_bytes` of the description at once.
    void push(VkCommandBuffer commands, std::span<const std::byte> bytes) const;

private:
    std::shared_ptr<const BuiltPipeline> built_;
};

} // namespace prelight::gpu
