#include "buffer.hpp"
#include "check.hpp"
#include <algorithm>
#include <cstring>

namespace prelight::gpu {

Buffer::Buffer(const Context& context, std::string_view name, uint64_t size, VkBufferUsageFlags usage,
               BufferPlace place)
    : size_(size) {
    VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    info.size = size;
    info.usage = usage;
    VkBuffer handle = VK_NULL_HANDLE;
    check(vkCreateBuffer(context.device(), &info, nullptr, &handle), name);
    buffer_ = {context.device(), handle};
    context.count_created(Context::Kind::buffer);
    context.set_name(VK_OBJECT_TYPE_BUFFER, reinterpret_cast<uint64_t>(handle), name);

    VkMemoryRequirements requirements{};
    vkGetBufferMemoryRequirements(context.device(), handle, &requirements);
    const bool host = place != BufferPlace::device;
    const VkMemoryPropertyFlags flags = host
                                            ? VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT
                                            : VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
    allocation_ = Allocation(context, requirements.size, context.memory_type(requirements.memoryTypeBits, flags), host);
    check(vkBindBufferMemory(context.device(), handle, allocation_.memory(), 0), name);
}

UniqueBufferView make_texel_view(const Context& context, std::string_view name, const Buffer& buffer) {
    constexpr uint64_t texel = 4 * sizeof(float);
    VkBufferViewCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO};
    info.buffer = buffer.handle();
    info.format = VK_FORMAT_R32G32B32A32_SFLOAT;
    info.range = std::min<uint64_t>(buffer.size() / texel, context.limits().maxTexelBufferElements) * texel;
    VkBufferView handle = VK_NULL_HANDLE;
    check(vkCreateBufferView(context.device(), &info, nullptr, &handle), name);
    context.set_name(VK_OBJECT_TYPE_BUFFER_VIEW, reinterpret_cast<uint64_t>(handle), name);
    return {context.device(), handle};
}

Buffer make_device_buffer(const Context& context, std::string_view name, std::span<const std::byte> bytes,
                          VkBufferUsageFlags usage) {
    const uint64_t size = std::max<uint64_t>(bytes.size(), 4);
    Buffer staging(context, "staging", size, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, BufferPlace::upload);
    std::memset(staging.mapped<std::byte>(), 0, 4);
    std::copy(bytes.begin(), bytes.end(), staging.mapped<std::byte>());
    Buffer buffer(context, name, size, usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT, BufferPlace::device);
    context.run(name, [&](VkCommandBuffer commands) {
        const VkBufferCopy region{0, 0, size};
        vkCmdCopyBuffer(commands, staging.handle(), buffer.handle(), 1, &region);
    });
    return buffer;
}

} // namespace prelight::gpu
