#pragma once
#include "context.hpp"
#include <span>
#include <vector>

namespace prelight::gpu {

/// One binding of a descriptor set together with what is bound there. All bindings are written:
/// lavapipe crashes on an unwritten one.
struct Binding {
    uint32_t index = 0;
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
    VkBuffer buffer = VK_NULL_HANDLE;
    uint64_t offset = 0;
    uint64_t range = VK_WHOLE_SIZE;
    VkImageView view = VK_NULL_HANDLE;
    VkImageLayout layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    VkSampler sampler = VK_NULL_HANDLE;
    VkBufferView texels = VK_NULL_HANDLE;

    static Binding uniform(uint32_t index, VkBuffer buffer, uint64_t offset = 0, uint64_t range = VK_WHOLE_SIZE);
    static Binding storage(uint32_t index, VkBuffer buffer, uint64_t offset = 0, uint64_t range = VK_WHOLE_SIZE);
    static Binding texel_buffer(uint32_t index, VkBufferView texels);
    static Binding sampled(uint32_t index, VkImageView view, VkImageLayout layout);
    static Binding storage_image(uint32_t index, VkImageView view);
    static Binding sampler_only(uint32_t index, VkSampler sampler);
    static Binding texture(uint32_t index, VkImageView view, VkSampler sampler);
};

/// A layout, visible to all graphics stages and compute, for bindings of these types. It is the device's, which has one
/// for all equals.
VkDescriptorSetLayout make_set_layout(const Context& context, std::string_view name, std::span<const Binding> bindings);

/// Descriptor sets that live together: a pool of exactly the size needed.
class DescriptorSets {
public:
    DescriptorSets() = default;
    /// `sets[i]` becomes set i, all with `layout`.
    DescriptorSets(const Context& context, std::string_view name, VkDescriptorSetLayout layout,
                   std::span<const std::vector<Binding>> sets);
    VkDescriptorSet operator[](size_t i) const { return sets_[i]; }
    /// Writes some bindings of set `i` anew; the device must not be using it.
    void update(const Context& context, size_t i, std::span<const Binding> bindings) const;

private:
    UniqueDescriptorPool pool_;
    std::vector<VkDescriptorSet> sets_;
};

} // namespace prelight::gpu
