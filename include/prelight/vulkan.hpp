#pragma once
#include <cstdint>
#include <functional>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <prelight/device.hpp>
#include <prelight/renderer.hpp>
#include <string>
#include <string_view>
#include <vector>
#include <vulkan/vulkan_core.h>

namespace prelight::gpu {
class Presenter;
}
/// Prelight beside other Vulkan code of a program: on its device, into its images and windows, between its passes. The
/// only public header with Vulkan types, beside glfw.hpp, which is made of it. Prelight calls Vulkan through the
/// system's loader (libvulkan.so.1), and so must whoever made the handles: GLFW, SDL, volk and what is linked with
/// -lvulkan all do.
namespace prelight::vulkan {

/// Features and extensions of a device, as vkCreateDevice takes them. A program adds its own to the members before it
/// creates the device.
struct DeviceFeatures {
    VkPhysicalDeviceFeatures2 core{};            ///< core.features
    VkPhysicalDeviceVulkan12Features vulkan12{}; ///< in the chain after `core`
    VkPhysicalDeviceVulkan13Features vulkan13{}; ///< in the chain after `vulkan12`
    /// In the chain where VK_EXT_conditional_rendering is among the extensions.
    VkPhysicalDeviceConditionalRenderingFeaturesEXT conditional_rendering{};
    std::vector<const char*> extensions{}; ///< of the device
    void* next = nullptr;                  ///< the program's own structures, of other types than those above
    /// For VkDeviceCreateInfo::pNext, with pEnabledFeatures null. It points into this object.
    PRELIGHT_API const void* chain();
};

/// What Prelight needs of this device, and what it would like that the device has. Without any of the latter it has
/// other ways (`prelight devices` lists them). Needed are Vulkan 1.3 (of VkApplicationInfo::apiVersion too) with
/// dynamicRendering, synchronization2, maintenance4, timelineSemaphore and fragmentStoresAndAtomics, and a queue for
/// graphics and compute; no extension. Throws Error that names the device and what it lacks.
PRELIGHT_API DeviceFeatures wanted_features(VkPhysicalDevice physical_device);

/// A device that a program has made, and one queue of it.
struct ExistingDevice {
    VkInstance instance = VK_NULL_HANDLE;              ///< of version 1.3 or later
    VkPhysicalDevice physical_device = VK_NULL_HANDLE; ///< that the device was made of
    VkDevice device = VK_NULL_HANDLE;                  ///< made with `enabled`
    VkQueue queue = VK_NULL_HANDLE;                    ///< for graphics and compute; Prelight submits to no other
    uint32_t queue_family = 0;                         ///< that the queue is of
    DeviceFeatures enabled{}; ///< what the device was made with: wanted_features(), whole or in part, and anything else
    bool debug_utils = false; ///< the instance has VK_EXT_debug_utils: objects and passes get names
    /// Around each use of the queue, for programs that use it in several threads at once: usually lock() and unlock()
    /// of a mutex, which nobody holds while calling Prelight. Both or none.
    std::function<void()> lock_queue{};
    std::function<void()> unlock_queue{}; ///< see lock_queue
};

/// Device::adopt(const ExistingDevice&) is in device.hpp. This is the opposite: the handles of any Device, for as long
/// as that lives. What is submitted to the queue by others needs the same thread, or lock_queue() and unlock_queue().
PRELIGHT_API ExistingDevice handles(const Device& device);

/// A semaphore that a frame waits for, or signals.
struct SemaphoreUse {
    VkSemaphore semaphore = VK_NULL_HANDLE; ///< binary or timeline
    uint64_t value = 0;                     ///< of a timeline semaphore; ignored for a binary one
    /// What waits, or what is waited for. To wait for a target image alone COLOR_ATTACHMENT_OUTPUT is enough.
    VkPipelineStageFlags2 stages = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
};

/// An image of the program's that a picture goes into: 2D, one layer and level of it, one sample, with the usage
/// COLOR_ATTACHMENT, made for the queue's family or for concurrent use.
struct Target {
    VkImage image = VK_NULL_HANDLE;    ///< that is written
    VkImageView view = VK_NULL_HANDLE; ///< of all of it, in `format`
    /// R8G8B8A8, B8G8R8A8 or A8B8G8R8 as UNORM or SRGB, A2B10G10R10 or A2R10G10B10 as UNORM, R16G16B16A16 or
    /// R32G32B32A32 as SFLOAT.
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkExtent2D extent{}; ///< as large as the renderer's pictures
    /// What it is in before, whatever it holds: all of it is written. UNDEFINED is always right.
    VkImageLayout layout_before = VK_IMAGE_LAYOUT_UNDEFINED;
    /// What the frame leaves it in: PRESENT_SRC_KHR, SHADER_READ_ONLY_OPTIMAL …
    VkImageLayout layout_after = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    std::vector<SemaphoreUse> wait{};   ///< before the image is written
    std::vector<SemaphoreUse> signal{}; ///< when it has been
    /// "final", or one of RenderOptions::views. Display-encoded pictures keep their encoded values in every format: an
    /// SRGB target holds the same bytes as a UNORM one, to within one code. "linear" is written as it is. Alpha is 1.
    std::string buffer = "final";
};

/// Renderer::render() of one frame, whose last pass writes the target. Order of the image's uses: what the program has
/// submitted to the same queue before comes before, what it submits to it afterwards comes after and finds the image
/// written, in `layout_after`; no semaphore is needed for either. Other queues, and presentation, need `wait` and
/// `signal`. The frame is submitted when this returns, and may not be done. Image and view stay until it is: until
/// what `signal` signals, or a later call of stats() or read(). Another format or buffer than the last frame's builds
/// the frame graph anew. Throws UsageError (a target that cannot be, a buffer that was not asked for, a renderer that
/// needs no device) and Error.
PRELIGHT_API void render_into(Renderer& renderer, const PlacedCamera& camera, const Target& target);

/// Shows a renderer's pictures in a window, for programs without a swapchain of their own. Its device is made with
/// DeviceOptions::window_extensions, or adopted with VK_KHR_swapchain among the enabled extensions.
class PRELIGHT_API Presenter {
public:
    /// Takes the surface over, and destroys it in the end. Throws Error where the device cannot show pictures there.
    Presenter(Device& device, VkSurfaceKHR surface);
    ~Presenter();
    Presenter(const Presenter&) = delete;
    Presenter& operator=(const Presenter&) = delete;
    /// Shows the renderer's last frame, stretched where the window has another size. `window`: its size now, pixels.
    /// Waits for the display, not for the frame. `overlay` draws over it, inside of dynamic rendering with one colour
    /// attachment of format(). False: nothing could be shown now (minimised, or its size has just changed). Throws
    /// Error.
    bool show(const Renderer& renderer, VkExtent2D window,
              const std::function<void(VkCommandBuffer, VkExtent2D)>& overlay = {}, std::string_view buffer = "final");
    /// Of the window's images.
    VkFormat format() const;

private:
    std::unique_ptr<gpu::Presenter> presenter_;
};

/// Where in a frame a pass of the program's stands. Which images there are to read and to write:
enum class Stage {
    /// Before lights: "depth", and "normal" where the renderer stores normals. Not in multipass.
    after_surfaces,
    /// Before materials: these, and in light-prepass and inferred "diffuse-light" and "specular-light" (the same image
    /// where they are stored in one), in deferred "light", what has been added up so far. In no other.
    after_light,
    after_opaque,   ///< "depth", "normal" as above, and "picture": scene-linear, without what is blended over it
    before_display, ///< the same with all of it
    after_display,  ///< the same, where "picture" is the finished one: display-encoded, or in an SRGB format
};

/// The images of a pass, until prepare() is called anew.
struct PassImages {
    /// One of them.
    struct One {
        std::string name;                                 ///< as Stage has it
        VkImageView view = VK_NULL_HANDLE;                ///< of the depth aspect alone where the image has stencil too
        VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED; ///< while the pass runs
        VkFormat format = VK_FORMAT_UNDEFINED;            ///< of the image
        VkExtent2D extent{};                              ///< pixels
        uint32_t samples = 1;                             ///< a pixel
    };
    std::vector<One> reads;          ///< in the order of Pass::reads
    std::vector<One> writes;         ///< colour attachments, in the order of Pass::writes
    std::optional<One> depth_test{}; ///< the depth attachment
};

/// What a pass gets when a frame is recorded.
struct PassFrame {
    VkCommandBuffer commands = VK_NULL_HANDLE; ///< to record into
    const PassImages& images;                  ///< as prepare() got them
    glm::mat4 clip_from_world{1}; ///< from positions relative to `eye`; reversed depth: near 1, far 0; +Y downwards
    glm::dvec3 eye{0};            ///< the camera's position, world
    uint32_t slot = 0; ///< of two, in turn: what the program writes for this frame, the frame before last has read
};

/// A pass of the program's in a renderer's frame. Barriers and layouts follow from what it says.
struct Pass {
    std::string name;                   ///< in Stats::passes and debug labels
    Stage stage = Stage::after_display; ///< where it stands
    std::vector<std::string> reads{};   ///< sampled or fetched in fragment and compute shaders
    std::vector<std::string> writes{};  ///< drawn over what they hold, blending or not; none of `reads`
    bool depth_test =
        false; ///< "depth" is the depth attachment, tested and not written; of as many samples as `writes`
    /// Called when the frame graph has been built, with no frame in flight: to make pipelines and descriptor sets. May
    /// be empty.
    std::function<void(const PassImages&)> prepare{};
    /// With `writes` or `depth_test` dynamic rendering has begun, and viewport and scissor cover the attachments;
    /// without, any command may be recorded. Nothing else is bound. Called once a frame, and again where Prelight draws
    /// one a second time.
    std::function<void(const PassFrame&)> record{};
};

/// Adds a pass to the renderer's frames, after those that were added to the same stage before; on world and size of
/// the time, and all later ones. Throws UsageError: an image that the stage does not have, a stage that the renderer
/// does not have, attachments of different samples. Then the pass is not added.
PRELIGHT_API uint64_t add_pass(Renderer& renderer, Pass pass);
/// By what add_pass() gave: waits for the frames in flight, after which nothing of the pass is in use. Throws
/// UsageError for another number.
PRELIGHT_API void remove_pass(Renderer& renderer, uint64_t pass);

} // namespace prelight::vulkan
