#include "device_selection.hpp"
#include "check.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <prelight/error.hpp>

namespace prelight::gpu {
namespace {

std::string type_name(VkPhysicalDeviceType type) {
    switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU: return "discrete";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU: return "integrated";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU: return "virtual";
    case VK_PHYSICAL_DEVICE_TYPE_CPU: return "software";
    default: return "other";
    }
}

/// Smaller is preferred by `auto`.
int rank(const std::string& type) {
    const char* order[] = {"discrete", "integrated", "virtual", "software"};
    return static_cast<int>(std::find(std::begin(order), std::end(order), type) - order);
}

std::vector<VkQueueFamilyProperties> queue_families(VkPhysicalDevice physical) {
    uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
    return families;
}

/// `asked` if it will do; without one the first that does.
std::optional<uint32_t> graphics_queue_family(VkPhysicalDevice physical, std::optional<uint32_t> asked) {
    const std::vector<VkQueueFamilyProperties> families = queue_families(physical);
    for (uint32_t i = 0; i < families.size(); ++i)
        if ((!asked || i == *asked) && (families[i].queueFlags & VK_QUEUE_GRAPHICS_BIT) &&
            (families[i].queueFlags & VK_QUEUE_COMPUTE_BIT))
            return i;
    return {};
}

uint64_t timestamp_mask(VkPhysicalDevice physical, uint32_t family) {
    const std::vector<VkQueueFamilyProperties> families = queue_families(physical);
    const uint32_t bits = family < families.size() ? families[family].timestampValidBits : 0;
    return bits >= 64 ? ~uint64_t(0) : (uint64_t(1) << bits) - 1;
}

void read_features(Candidate& candidate, const VkPhysicalDeviceFeatures& core) {
    auto note = [&](bool has, const char* name) {
        (has ? candidate.info.features : candidate.info.missing).push_back(name);
        return has;
    };
    OptionalFeatures& o = candidate.optional;
    o.anisotropy = note(core.samplerAnisotropy, "anisotropic filtering");
    o.depth_clamp = note(core.depthClamp, "depth clamp");
    o.depth_bounds = note(core.depthBounds, "depth bounds test");
    o.multi_draw_indirect = note(core.multiDrawIndirect, "multi-draw indirect");
    o.first_instance_indirect = note(core.drawIndirectFirstInstance, "first instance in indirect draws");
    o.sample_rate_shading = note(core.sampleRateShading, "sample shading");
    o.precise_occlusion = note(core.occlusionQueryPrecise, "precise occlusion queries");
    o.store_without_format = note(core.shaderStorageImageWriteWithoutFormat, "storage images without format");
}

bool has_extension(VkPhysicalDevice physical, std::string_view name) {
    uint32_t count = 0;
    vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> extensions(count);
    vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, extensions.data());
    return std::any_of(extensions.begin(), extensions.end(),
                       [&](const VkExtensionProperties& one) { return one.extensionName == name; });
}

bool conditional_rendering(VkPhysicalDevice physical) {
    if (!has_extension(physical, VK_EXT_CONDITIONAL_RENDERING_EXTENSION_NAME))
        return false;
    VkPhysicalDeviceConditionalRenderingFeaturesEXT conditional{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_CONDITIONAL_RENDERING_FEATURES_EXT};
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &conditional, {}};
    vkGetPhysicalDeviceFeatures2(physical, &features);
    return conditional.conditionalRendering;
}

uint32_t shuffle_lanes(const VkPhysicalDeviceSubgroupProperties& subgroups) {
    const bool shuffles = (subgroups.supportedOperations & VK_SUBGROUP_FEATURE_SHUFFLE_BIT) &&
                          (subgroups.supportedStages & VK_SHADER_STAGE_COMPUTE_BIT);
    // Light lists are built by workgroups of 64, whose subgroups have to be full.
    return shuffles && subgroups.subgroupSize <= 64 ? subgroups.subgroupSize : 0;
}

/// gallivm, which compiles llvmpipe's and lavapipe's shaders, counts the turns of all loops of an invocation and ends
/// each loop at its next turn when they are used up (LP_MAX_TGSI_LOOP_ITERATIONS in lp_bld_limits.h).
uint32_t loop_turns(VkDriverId driver) { return driver == VK_DRIVER_ID_MESA_LLVMPIPE ? 65535 : 0; }

std::vector<Candidate>::iterator find_named(std::vector<Candidate>& all, const std::string& select) {
    const bool index =
        !select.empty() && std::all_of(select.begin(), select.end(), [](char c) { return c >= '0' && c <= '9'; });
    return std::find_if(all.begin(), all.end(), [&](const Candidate& c) {
        if (select == "cpu")
            return c.info.type == "software" && c.info.usable;
        return index ? std::to_string(c.info.index) == select
                     : !select.empty() && c.info.name.find(select) != std::string::npos;
    });
}

} // namespace

Candidate examine(VkPhysicalDevice physical, uint32_t index, std::optional<uint32_t> asked) {
    Candidate candidate;
    candidate.physical = physical;
    VkPhysicalDeviceDriverProperties driver{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
    VkPhysicalDeviceSubgroupProperties subgroups{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES};
    driver.pNext = &subgroups;
    VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &driver, {}};
    vkGetPhysicalDeviceProperties2(physical, &properties);
    DeviceInfo& info = candidate.info;
    info.index = index;
    info.name = properties.properties.deviceName;
    info.type = type_name(properties.properties.deviceType);
    info.driver = fmt::format("{} {}", driver.driverName, driver.driverInfo);

    const uint32_t api = properties.properties.apiVersion;
    if (api < VK_API_VERSION_1_3) {
        info.why_not =
            fmt::format("Vulkan {}.{}, and 1.3 is needed", VK_API_VERSION_MAJOR(api), VK_API_VERSION_MINOR(api));
        return candidate;
    }
    VkPhysicalDeviceVulkan13Features v13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    VkPhysicalDeviceVulkan12Features v12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
    v12.pNext = &v13;
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &v12, {}};
    vkGetPhysicalDeviceFeatures2(physical, &features);
    read_features(candidate, features.features);
    candidate.optional.shuffle_lanes = shuffle_lanes(subgroups);
    candidate.optional.loop_turns = loop_turns(driver.driverID);
    (candidate.optional.shuffle_lanes > 0 ? info.features : info.missing).push_back("subgroup shuffle");
    candidate.optional.conditional_rendering = conditional_rendering(physical);
    (candidate.optional.conditional_rendering ? info.features : info.missing).push_back("conditional rendering");
    // What SwiftShader exports is wrong on some surfaces: a picture lit by it is 34 dB from what it should be.
    candidate.optional.stencil_export = driver.driverID != VK_DRIVER_ID_GOOGLE_SWIFTSHADER &&
                                        has_extension(physical, VK_EXT_SHADER_STENCIL_EXPORT_EXTENSION_NAME);
    (candidate.optional.stencil_export ? info.features : info.missing).push_back("stencil export");
    candidate.optional.post_depth_coverage = has_extension(physical, VK_EXT_POST_DEPTH_COVERAGE_EXTENSION_NAME);
    (candidate.optional.post_depth_coverage ? info.features : info.missing).push_back("post-depth coverage");
    // SwiftShader's gl_FragCoord.z is that of the first sample.
    candidate.optional.centre_depth = driver.driverID != VK_DRIVER_ID_GOOGLE_SWIFTSHADER;
    // lavapipe loads from a storage buffer lane by lane, and fetches a texel for all lanes at once.
    candidate.optional.fast_texel_buffers =
        driver.driverID == VK_DRIVER_ID_MESA_LLVMPIPE &&
        properties.properties.limits.maxTexelBufferElements >= properties.properties.limits.maxStorageBufferRange / 16;
    const bool fragment_stores = features.features.fragmentStoresAndAtomics;
    const std::optional<uint32_t> family = graphics_queue_family(physical, asked);
    if (!family)
        info.why_not = asked ? fmt::format("queue family {} is not for graphics and compute", *asked)
                             : "no queue for graphics and compute";
    else if (!v13.dynamicRendering || !v13.synchronization2 || !v13.maintenance4 || !v12.timelineSemaphore)
        info.why_not = "dynamic rendering, synchronization2, maintenance4 or timeline semaphores are missing";
    else if (!fragment_stores)
        info.why_not = "fragment shaders cannot write to buffers";
    info.usable = info.why_not.empty();
    candidate.queue_family = family.value_or(0);
    candidate.timestamp_mask = timestamp_mask(physical, candidate.queue_family);
    return candidate;
}

std::vector<Candidate> candidates(const Instance& instance) {
    std::vector<Candidate> all;
    for (VkPhysicalDevice physical : instance.physical_devices())
        all.push_back(examine(physical, static_cast<uint32_t>(all.size())));
    return all;
}

std::vector<Candidate> choose(std::vector<Candidate> all, const std::string& select) {
    auto chosen = all.end();
    if (select == "auto") {
        chosen = std::min_element(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
            return std::pair(!a.info.usable, rank(a.info.type)) < std::pair(!b.info.usable, rank(b.info.type));
        });
        if (chosen == all.end() || !chosen->info.usable)
            throw Error(all.empty()
                            ? std::string("Vulkan: no device")
                            : fmt::format("Vulkan: no usable device: {}: {}", chosen->info.name, chosen->info.why_not));
        chosen->info.why_chosen = fmt::format("auto prefers discrete, integrated, virtual, software: "
                                              "this is the first {} device",
                                              chosen->info.type);
    } else {
        chosen = find_named(all, select);
        if (chosen == all.end())
            throw UsageError(fmt::format("--device {}: no such device (prelight devices lists them)", select));
        if (!chosen->info.usable)
            throw Error(fmt::format("{}: {}", chosen->info.name, chosen->info.why_not));
        chosen->info.why_chosen = "asked for by --device " + select;
    }
    chosen->info.chosen = true;
    return all;
}

std::vector<Candidate> select_device(const Instance& instance, const std::string& select) {
    return choose(candidates(instance), select);
}

} // namespace prelight::gpu
