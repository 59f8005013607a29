#pragma once
#include <cstddef>
#include <gpu/buffer.hpp>
#include <prelight/renderer.hpp>
#include <vulkan/vulkan_core.h>

namespace prelight {

/// An image of the device as floats: what bytes store as it is, half floats and floats within the range of half
/// floats, so that a picture does not depend on what its light was added up in.
Image unpack(const std::byte* texels, VkFormat format, VkExtent2D extent);
/// The same as they are, in the buffer's memory.
Texels hand_out(gpu::Buffer buffer, VkFormat format, VkExtent2D extent);

} // namespace prelight
