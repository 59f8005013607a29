#include "instance.hpp"
#include "check.hpp"
#include <algorithm>
#include <cstring>
#include <filesystem>
#include <platform/process.hpp>

namespace prelight::gpu {
namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";

VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    std::string text = data->pMessage ? data->pMessage : "";
    std::replace(text.begin(), text.end(), '\n', ' ');
    static_cast<MessageLog*>(user)->add(std::move(text));
    return VK_FALSE;
}

VkDebugUtilsMessengerCreateInfoEXT messenger_info(MessageLog* log) {
    VkDebugUtilsMessengerCreateInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
    info.pfnUserCallback = on_message;
    info.pUserData = log;
    return info;
}

void point_loader_at_layer() {
    set_environment_default("VK_LAYER_SYNCVAL_SHADER_ACCESSES_HEURISTIC", "1");
    set_environment_default("VK_LAYER_SYNCVAL_LOAD_OP_AFTER_STORE_OP_VALIDATION", "1");
    // The build leaves a manifest (cmake/ValidationLayer.cmake): programs in its folder find it from where they are,
    // and what is installed knows nothing of that folder.
    std::error_code none;
    std::filesystem::path folder = program_file().parent_path();
    for (int up = 0; up < 3 && !folder.empty(); ++up, folder = folder.parent_path())
        if (const std::filesystem::path layers = folder / "share/prelight/layers"; exists(layers, none))
            set_environment_default("VK_LAYER_PATH", layers.string());
}

bool has_layer() {
    uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> layers(count);
    vkEnumerateInstanceLayerProperties(&count, layers.data());
    return std::any_of(layers.begin(), layers.end(), [](const VkLayerProperties& layer) {
        return std::strcmp(layer.layerName, validation_layer) == 0;
    });
}

bool has_extension(const char* name) {
    uint32_t count = 0;
    vkEnumerateInstanceExtensionProperties(nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> found(count);
    vkEnumerateInstanceExtensionProperties(nullptr, &count, found.data());
    return std::any_of(found.begin(), found.end(), [&](const VkExtensionProperties& extension) {
        return std::strcmp(extension.extensionName, name) == 0;
    });
}

} // namespace

void MessageLog::add(std::string message) {
    const std::lock_guard lock(mutex_);
    messages_.push_back(std::move(message));
}

std::vector<std::string> MessageLog::messages() const {
    const std::lock_guard lock(mutex_);
    return messages_;
}

Instance::Instance(bool validate, const std::vector<std::string>& extensions) {
    if (validate) {
        point_loader_at_layer();
        if (!has_layer())
            throw Error("Vulkan: validation was asked for, but no validation layer is installed "
                        "(on Debian: chromium-common or vulkan-validationlayers)");
    }
    uint32_t version = VK_API_VERSION_1_0;
    vkEnumerateInstanceVersion(&version);
    if (version < VK_API_VERSION_1_3)
        throw Error("Vulkan: the loader is older than 1.3");

    VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.pApplicationName = "prelight";
    application.pEngineName = "prelight";
    application.apiVersion = VK_API_VERSION_1_3;

    debug_utils_ = validate || has_extension(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    std::vector<const char*> names;
    if (debug_utils_)
        names.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    for (const std::string& extension : extensions) {
        if (!has_extension(extension.c_str()))
            throw Error("Vulkan: the instance extension " + extension + " is missing, which a window needs");
        names.push_back(extension.c_str());
    }
    VkDebugUtilsMessengerCreateInfoEXT messenger = messenger_info(log_.get());
    const VkValidationFeatureEnableEXT enables[] = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
    VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
    features.enabledValidationFeatureCount = 1;
    features.pEnabledValidationFeatures = enables;
    features.pNext = &messenger;

    VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    info.pApplicationInfo = &application;
    info.enabledExtensionCount = static_cast<uint32_t>(names.size());
    info.ppEnabledExtensionNames = names.data();
    if (validate) {
        info.pNext = &features;
        info.enabledLayerCount = 1;
        info.ppEnabledLayerNames = &validation_layer;
    }
    check(vkCreateInstance(&info, nullptr, &instance_), "Vulkan instance");
    if (validate)
        create_messenger();
}

void Instance::create_messenger() {
    const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(instance_, "vkCreateDebugUtilsMessengerEXT"));
    const VkDebugUtilsMessengerCreateInfoEXT info = messenger_info(log_.get());
    check(create(instance_, &info, nullptr, &messenger_), "Vulkan debug messenger");
}

Instance::~Instance() {
    if (messenger_) {
        const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
        destroy(instance_, messenger_, nullptr);
    }
    if (owned_)
        vkDestroyInstance(instance_, nullptr);
}

std::vector<VkPhysicalDevice> Instance::physical_devices() const {
    uint32_t count = 0;
    check(vkEnumeratePhysicalDevices(instance_, &count, nullptr), "Vulkan devices");
    std::vector<VkPhysicalDevice> devices(count);
    check(vkEnumeratePhysicalDevices(instance_, &count, devices.data()), "Vulkan devices");
    return devices;
}

} // namespace prelight::gpu
