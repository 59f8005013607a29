#pragma once
#include <cstdint>
#include <gpu/raster.hpp>
#include <string>
#include <vulkan/vulkan_core.h>

namespace prelight::graph {

/// Handles into one FrameGraph.
struct ImageId {
    uint32_t index = 0xffffffffu;
    explicit operator bool() const { return index != 0xffffffffu; }
    bool operator==(const ImageId&) const = default;
};
struct BufferId {
    uint32_t index = 0xffffffffu;
};

struct ImageDesc {
    VkFormat format = VK_FORMAT_UNDEFINED;
    gpu::Raster raster{};
};

/// What an attachment holds when a pass begins.
enum class Load { clear, keep, discard };

/// How a pass touches a resource: pipeline stages, memory access and image layout.
struct Access {
    VkPipelineStageFlags2 stages = 0;
    VkAccessFlags2 access = 0;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    bool writes = false;

    static Access colour();
    static Access depth_write();
    static Access depth_test();
    /// Depth tested and sampled, stencil written.
    static Access stencil_write();
    static Access sampled(bool depth);
    static Access storage(bool writes);
    static Access storage_image();
    static Access indirect();
    static Access indices();
    /// What conditional rendering asks.
    static Access condition();
    static Access copied_to();
    /// Reads of both in one pass, or in neighbouring passes (layouts must agree).
    Access& operator|=(const Access& other);
};

bool is_depth(VkFormat format);
bool has_stencil(VkFormat format);
/// Every aspect of the format.
VkImageAspectFlags aspects(VkFormat format);
/// Bytes of one texel, stencil included; only the formats that passes use. Throws Error for another.
uint32_t texel_bytes(VkFormat format);
/// "RGBA16F", "oct24 in RGBA8" is the pass's business.
std::string format_name(VkFormat format);

} // namespace prelight::graph
