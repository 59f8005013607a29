#pragma once
#include "buffer.hpp"
#include "command_slot.hpp"
#include "descriptors.hpp"
#include "frames_in_flight.hpp"
#include "pipeline.hpp"
#include "shown_image.hpp"
#include "swapchain.hpp"
#include <functional>
#include <optional>
#include <prelight/image.hpp>

namespace prelight::gpu {

/// What the overlay gets: dynamic rendering into the window's image has begun.
struct OverlayContext {
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VkExtent2D extent{};
    uint32_t slot = 0; ///< of the frames in flight: what the host writes for it is free now
};

/// Puts pictures into a window, with something drawn over them. It keeps a copy of the picture that it was given last,
/// so that whoever drew that may be gone, and what lies over it may change alone.
class Presenter {
public:
    /// Takes the surface over. Throws Error.
    Presenter(const Context& context, VkSurfaceKHR surface);
    ~Presenter();
    Presenter(const Presenter&) = delete;
    Presenter& operator=(const Presenter&) = delete;

    /// The next picture: copied on the device by the next show(), which has to come before the image is gone.
    void take(const ShownImage& image) { taken_ = image; }
    /// The same of display-encoded values on the host: copied now.
    void take(const Image& display);
    /// Shows the picture, stretched where the window has another size, and what `overlay` draws. `window`: its size
    /// now, pixels. False: nothing could be shown now (minimised, or its size has just changed); what take() was given
    /// is forgotten, and the picture from before kept. Throws SurfaceLost, DeviceLost, Error.
    bool show(VkExtent2D window, const std::function<void(const OverlayContext&)>& overlay);
    VkFormat format() const { return swapchain_.format(); }
    void lose_surface() { swapchain_.lose(); }

private:
    struct Slot {
        CommandSlot recorded;
        UniqueSemaphore ready;
        uint64_t value = 0; ///< of the timeline, at its end; 0: not in flight
    };
    void wait(Slot& slot);
    void make_pipeline();
    void make_picture(VkExtent2D extent);
    void make_set();
    void draw_picture(VkCommandBuffer commands, VkExtent2D window) const;
    void copy_taken(VkCommandBuffer commands);
    void record(VkCommandBuffer commands, uint32_t index, uint32_t slot,
                const std::function<void(const OverlayContext&)>& overlay);

    const Context& context_;
    Swapchain swapchain_;
    PerFrame<Slot> slots_;
    uint32_t slot_ = 0;
    std::optional<ShownImage> taken_;
    UniqueImage picture_;
    Allocation memory_;
    UniqueImageView view_;
    UniqueSampler sampler_;
    VkDescriptorSetLayout layout_ = VK_NULL_HANDLE;
    DescriptorSets set_;
    GraphicsPipeline pipeline_; ///< of the picture in the window; what the driver makes of it is kept between starts,
                                ///< which what a blit needs would not be
    VkExtent2D extent_{};
    bool filled_ = false; ///< the picture has been copied once
};

} // namespace prelight::gpu
