#pragma once
#include "instance.hpp"
#include <optional>
#include <prelight/device.hpp>

namespace prelight::gpu {

/// Vulkan features that Prelight uses when a device has them.
struct OptionalFeatures {
    bool anisotropy = false;
    bool depth_clamp = false;
    bool depth_bounds = false;
    bool multi_draw_indirect = false;
    bool first_instance_indirect = false;
    bool sample_rate_shading = false;
    bool precise_occlusion = false;
    bool conditional_rendering = false; ///< VK_EXT_conditional_rendering
    bool store_without_format = false;  ///< shaders write storage images of any format
    bool stencil_export = false;        ///< VK_EXT_shader_stencil_export
    bool post_depth_coverage = false;   ///< VK_EXT_post_depth_coverage
    bool centre_depth = false;          ///< a fragment's depth is that under the pixel's centre, however many samples
    /// Shaders read texel buffers of any size faster than storage buffers.
    bool fast_texel_buffers = false;
    uint32_t shuffle_lanes = 0; ///< size of a subgroup whose compute shaders can shuffle; 0: they cannot
    uint32_t loop_turns = 0;    ///< after so many, of all its loops together, an invocation leaves them; 0: never
};

struct Candidate {
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    uint32_t queue_family = 0;
    uint64_t timestamp_mask = 0; ///< bits of a timestamp that count
    OptionalFeatures optional;
    DeviceInfo info;
};

/// One device, with what it has and why it cannot be used. `family`: of the queue that it is to be used by; absent: the
/// first for graphics and compute.
Candidate examine(VkPhysicalDevice physical, uint32_t index, std::optional<uint32_t> family = {});
/// Every device of the instance, with what it has and why it cannot be used, in the loader's order.
std::vector<Candidate> candidates(const Instance& instance);
/// Marks the one that `select` takes: auto, cpu, an index, or a part of a name.
/// Throws UsageError when it names none, Error when none is usable.
std::vector<Candidate> choose(std::vector<Candidate> all, const std::string& select);
/// `choose` among the devices of the instance.
std::vector<Candidate> select_device(const Instance& instance, const std::string& select);

} // namespace prelight::gpu
