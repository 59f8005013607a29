#include "descriptors.hpp"
#include "check.hpp"
#include "pipeline_library.hpp"
#include <map>

namespace prelight::gpu {
namespace {

void write(const Context& context, VkDescriptorSet set, std::span<const Binding> bindings) {
    for (const Binding& b : bindings) {
        const VkDescriptorBufferInfo buffer{b.buffer, b.offset, b.range};
        const VkDescriptorImageInfo image{b.sampler, b.view, b.layout};
        VkWriteDescriptorSet info{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
        info.dstSet = set;
        info.dstBinding = b.index;
        info.descriptorCount = 1;
        info.descriptorType = b.type;
        info.pBufferInfo = b.buffer ? &buffer : nullptr;
        info.pImageInfo = b.view || b.sampler ? &image : nullptr;
        info.pTexelBufferView = b.texels ? &b.texels : nullptr;
        vkUpdateDescriptorSets(context.device(), 1, &info, 0, nullptr);
    }
}

Binding of_buffer(uint32_t index, VkDescriptorType type, VkBuffer buffer, uint64_t offset, uint64_t range) {
    Binding b{index, type};
    b.buffer = buffer;
    b.offset = offset;
    b.range = range;
    return b;
}

} // namespace

Binding Binding::uniform(uint32_t index, VkBuffer buffer, uint64_t offset, uint64_t range) {
    return of_buffer(index, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, buffer, offset, range);
}

Binding Binding::storage(uint32_t index, VkBuffer buffer, uint64_t offset, uint64_t range) {
    return of_buffer(index, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, buffer, offset, range);
}

Binding Binding::texel_buffer(uint32_t index, VkBufferView texels) {
    Binding b{index, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER};
    b.texels = texels;
    return b;
}

Binding Binding::sampled(uint32_t index, VkImageView view, VkImageLayout layout) {
    Binding b{index, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE};
    b.view = view;
    b.layout = layout;
    return b;
}

Binding Binding::storage_image(uint32_t index, VkImageView view) {
    Binding b{index, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE};
    b.view = view;
    b.layout = VK_IMAGE_LAYOUT_GENERAL;
    return b;
}

Binding Binding::sampler_only(uint32_t index, VkSampler sampler) {
    Binding b{index, VK_DESCRIPTOR_TYPE_SAMPLER};
    b.sampler = sampler;
    return b;
}

Binding Binding::texture(uint32_t index, VkImageView view, VkSampler sampler) {
    Binding b{index, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER};
    b.view = view;
    b.sampler = sampler;
    return b;
}

VkDescriptorSetLayout make_set_layout(const Context& context, std::string_view name,
                                      std::span<const Binding> bindings) {
    PipelineLibrary::SetLayoutKey key;
    for (const Binding& b : bindings)
        key.emplace_back(b.index, b.type);
    return context.pipelines().find_set_layout(key, [&]() -> UniqueSetLayout {
        std::vector<VkDescriptorSetLayoutBinding> entries;
        for (const auto& [index, type] : key)
            entries.push_back({index, type, 1, VK_SHADER_STAGE_ALL_GRAPHICS | VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
        VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
        info.bindingCount = static_cast<uint32_t>(entries.size());
        info.pBindings = entries.data();
        VkDescriptorSetLayout handle = VK_NULL_HANDLE;
        check(vkCreateDescriptorSetLayout(context.device(), &info, nullptr, &handle), name);
        context.set_name(VK_OBJECT_TYPE_DESCRIPTOR_SET_LAYOUT, reinterpret_cast<uint64_t>(handle), name);
        return {context.device(), handle};
    });
}

DescriptorSets::DescriptorSets(const Context& context, std::string_view name, VkDescriptorSetLayout layout,
                               std::span<const std::vector<Binding>> sets) {
    std::map<VkDescriptorType, uint32_t> counts;
    for (const auto& bindings : sets)
        for (const Binding& b : bindings)
            ++counts[b.type];
    if (counts.empty())
        counts[VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE] = 1; // a pool of no descriptors is not allowed
    std::vector<VkDescriptorPoolSize> sizes;
    for (const auto& [type, count] : counts)
        sizes.push_back({type, count});
    VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    info.maxSets = static_cast<uint32_t>(sets.size());
    info.poolSizeCount = static_cast<uint32_t>(sizes.size());
    info.pPoolSizes = sizes.data();
    VkDescriptorPool pool = VK_NULL_HANDLE;
    check(vkCreateDescriptorPool(context.device(), &info, nullptr, &pool), name);
    pool_ = {context.device(), pool};
    context.count_created(Context::Kind::descriptor_pool);
    context.set_name(VK_OBJECT_TYPE_DESCRIPTOR_POOL, reinterpret_cast<uint64_t>(pool), name);

    const std::vector<VkDescriptorSetLayout> layouts(sets.size(), layout);
    VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    allocate.descriptorPool = pool;
    allocate.descriptorSetCount = info.maxSets;
    allocate.pSetLayouts = layouts.data();
    sets_.resize(sets.size());
    check(vkAllocateDescriptorSets(context.device(), &allocate, sets_.data()), name);
    for (size_t i = 0; i < sets.size(); ++i) {
        context.set_name(VK_OBJECT_TYPE_DESCRIPTOR_SET, reinterpret_cast<uint64_t>(sets_[i]), name);
        write(context, sets_[i], sets[i]);
    }
}

void DescriptorSets::update(const Context& context, size_t i, std::span<const Binding> bindings) const {
    write(context, sets_[i], bindings);
}

} // namespace prelight::gpu
