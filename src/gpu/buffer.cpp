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
    constexpr VkMemoryPropertyFlags host = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    constexpr VkMemoryPropertyFlags device = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
    const bool of_host = place != BufferPlace::device;
    const uint32_t type = context.memory_type(requirements.memoryTypeBits, of_host ? host : device);
    const bool seen = of_host || (context.memory_flags(type) & host) == host;
    allocation_ = Allocation(context, requirements.size, type, seen);
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

Buffer make_device_buffer(const Context& context, std::string_view name, uint64_t size, VkBufferUsageFlags usage,
                          const std::function<void(std::byte*)>& fill) {
    const uint64_t room = std::max<uint64_t>(size, 4);
    const auto fill_room = [&](const Buffer& buffer) {
        if (size < room)
            std::memset(buffer.mapped<std::byte>(), 0, room);
        fill(buffer.mapped<std::byte>());
    };
    Buffer buffer(context, name, room, usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT, BufferPlace::device);
    if (buffer.mapped<std::byte>()) {
        fill_room(buffer);
        return buffer;
    }
    const Buffer staging(context, "staging", room, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, BufferPlace::upload);
    fill_room(staging);
    context.run(name, [&](VkCommandBuffer commands) {
        const VkBufferCopy region{0, 0, room};
        vkCmdCopyBuffer(commands, staging.handle(), buffer.handle(), 1, &region);
    });
    return buffer;
}

Buffer make_device_buffer(const Context& context, std::string_view name, std::span<const std::byte> bytes,
                          VkBufferUsageFlags usage) {
    return make_device_buffer(context, name, bytes.size(), usage,
                              [&](std::byte* to) { std::copy(bytes.begin(), bytes.end(), to); });
}

} // namespace prelight::gpu
