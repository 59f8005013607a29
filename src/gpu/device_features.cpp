#include "device_features.hpp"
#include <algorithm>
#include <array>
#include <prelight/error.hpp>
#include <string_view>

namespace prelight {
namespace gpu {
namespace {

using vulkan::DeviceFeatures;

/// What each device is made with.
struct NeededFeature {
    const char* name;
    VkBool32& (*of)(DeviceFeatures&);
};
constexpr std::array needed_features{
    NeededFeature{"dynamicRendering", [](DeviceFeatures& f) -> VkBool32& { return f.vulkan13.dynamicRendering; }},
    NeededFeature{"synchronization2", [](DeviceFeatures& f) -> VkBool32& { return f.vulkan13.synchronization2; }},
    // shaderc writes compute shaders' sizes as LocalSizeId, which wants it
    NeededFeature{"maintenance4", [](DeviceFeatures& f) -> VkBool32& { return f.vulkan13.maintenance4; }},
    NeededFeature{"timelineSemaphore", [](DeviceFeatures& f) -> VkBool32& { return f.vulkan12.timelineSemaphore; }},
    NeededFeature{"fragmentStoresAndAtomics",
                  [](DeviceFeatures& f) -> VkBool32& { return f.core.features.fragmentStoresAndAtomics; }},
};

/// What it is made with where it has it.
struct WantedFeature {
    bool OptionalFeatures::*optional;
    VkBool32 VkPhysicalDeviceFeatures::*core;
};
constexpr std::array wanted_features{
    WantedFeature{&OptionalFeatures::anisotropy, &VkPhysicalDeviceFeatures::samplerAnisotropy},
    WantedFeature{&OptionalFeatures::depth_clamp, &VkPhysicalDeviceFeatures::depthClamp},
    WantedFeature{&OptionalFeatures::depth_bounds, &VkPhysicalDeviceFeatures::depthBounds},
    WantedFeature{&OptionalFeatures::multi_draw_indirect, &VkPhysicalDeviceFeatures::multiDrawIndirect},
    WantedFeature{&OptionalFeatures::first_instance_indirect, &VkPhysicalDeviceFeatures::drawIndirectFirstInstance},
    WantedFeature{&OptionalFeatures::sample_rate_shading, &VkPhysicalDeviceFeatures::sampleRateShading},
    WantedFeature{&OptionalFeatures::precise_occlusion, &VkPhysicalDeviceFeatures::occlusionQueryPrecise},
    WantedFeature{&OptionalFeatures::store_without_format,
                  &VkPhysicalDeviceFeatures::shaderStorageImageWriteWithoutFormat},
};

bool has_name(const std::vector<const char*>& names, std::string_view name) {
    return std::ranges::any_of(names, [&](const char* one) { return one == name; });
}

} // namespace

DeviceFeatures features_to_enable(const OptionalFeatures& optional) {
    DeviceFeatures features;
    for (const NeededFeature& needed : needed_features)
        needed.of(features) = VK_TRUE;
    for (const WantedFeature& wanted : gpu::wanted_features)
        features.core.features.*wanted.core = optional.*wanted.optional;
    if (optional.conditional_rendering) {
        features.conditional_rendering.conditionalRendering = VK_TRUE;
        features.extensions.push_back(VK_EXT_CONDITIONAL_RENDERING_EXTENSION_NAME);
    }
    if (optional.stencil_export)
        features.extensions.push_back(VK_EXT_SHADER_STENCIL_EXPORT_EXTENSION_NAME);
    if (optional.post_depth_coverage)
        features.extensions.push_back(VK_EXT_POST_DEPTH_COVERAGE_EXTENSION_NAME);
    return features;
}

std::string keep_enabled(OptionalFeatures& optional, const DeviceFeatures& enabled) {
    for (const WantedFeature& wanted : gpu::wanted_features)
        optional.*wanted.optional &= enabled.core.features.*wanted.core == VK_TRUE;
    optional.conditional_rendering &= enabled.conditional_rendering.conditionalRendering &&
                                      has_name(enabled.extensions, VK_EXT_CONDITIONAL_RENDERING_EXTENSION_NAME);
    optional.stencil_export &= has_name(enabled.extensions, VK_EXT_SHADER_STENCIL_EXPORT_EXTENSION_NAME);
    optional.post_depth_coverage &= has_name(enabled.extensions, VK_EXT_POST_DEPTH_COVERAGE_EXTENSION_NAME);
    DeviceFeatures copy = enabled;
    std::string lacks;
    for (const NeededFeature& needed : needed_features)
        if (!needed.of(copy))
            lacks += (lacks.empty() ? "" : ", ") + std::string(needed.name);
    return lacks;
}

} // namespace gpu

namespace vulkan {

const void* DeviceFeatures::chain() {
    core.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    vulkan12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    vulkan13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    conditional_rendering.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_CONDITIONAL_RENDERING_FEATURES_EXT;
    core.pNext = &vulkan12;
    vulkan12.pNext = &vulkan13;
    vulkan13.pNext = next;
    if (gpu::has_name(extensions, VK_EXT_CONDITIONAL_RENDERING_EXTENSION_NAME)) {
        vulkan13.pNext = &conditional_rendering;
        conditional_rendering.pNext = next;
    }
    return &core;
}

DeviceFeatures wanted_features(VkPhysicalDevice physical_device) {
    if (!physical_device)
        throw UsageError("wanted_features(): no physical device");
    const gpu::Candidate candidate = gpu::examine(physical_device, 0);
    if (!candidate.info.usable)
        throw Error(candidate.info.name + ": " + candidate.info.why_not);
    return gpu::features_to_enable(candidate.optional);
}

} // namespace vulkan
} // namespace prelight
