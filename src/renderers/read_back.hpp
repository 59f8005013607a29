#pragma once
#include <cstddef>
#include <prelight/image.hpp>
#include <vector>
#include <vulkan/vulkan_core.h>

namespace prelight {

/// An image of the device as floats: what bytes store as it is, half floats and floats within the range of half
/// floats, so that a picture does not depend on what its light was added up in.
Image unpack(const std::vector<std::byte>& texels, VkFormat format, VkExtent2D extent);

} // namespace prelight
