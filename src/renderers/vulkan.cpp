// Frames into the images of a program, and its own passes in them: prelight/vulkan.hpp.
#include "device_renderer.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <gpu/presenter.hpp>
#include <passes/target.hpp>
#include <prelight/error.hpp>

namespace prelight {
namespace {

DeviceRenderer& on_device(Renderer& renderer) {
    if (auto* found = dynamic_cast<DeviceRenderer*>(&renderer))
        return *found;
    throw UsageError("this renderer draws on no device");
}

} // namespace

void DeviceRenderer::check_target(const vulkan::Target& target) const {
    if (!target.image || !target.view)
        throw UsageError("target: image and view are both needed");
    if (!passes::is_target_format(target.format))
        throw UsageError(fmt::format("target: VkFormat {} is none that pictures are written in (prelight/vulkan.hpp "
                                     "lists them)",
                                     static_cast<int>(target.format)));
    if (!context_.supports(target.format, VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT))
        throw UsageError(
            fmt::format("target: {} cannot draw into VkFormat {}", context_.name(), static_cast<int>(target.format)));
    if (target.extent.width != options_.width || target.extent.height != options_.height)
        throw UsageError(fmt::format("target: of {}x{} pixels, where the renderer's pictures have {}x{} (resize())",
                                     target.extent.width, target.extent.height, options_.width, options_.height));
    if (target.layout_after == VK_IMAGE_LAYOUT_UNDEFINED || target.layout_after == VK_IMAGE_LAYOUT_PREINITIALIZED)
        throw UsageError("target: layout_after is none that an image can be brought into");
    for (const auto* uses : {&target.wait, &target.signal})
        for (const vulkan::SemaphoreUse& use : *uses)
            if (!use.semaphore)
                throw UsageError("target: a semaphore is missing");
    if (target.buffer != "final" && !wants(target.buffer))
        throw UsageError(fmt::format("target: buffer {}: was not asked for when the renderer was made", target.buffer));
}

graph::ExternalImage DeviceRenderer::external_image(const vulkan::Target& target) {
    return {target.image, target.view, target.layout_before, target.layout_after};
}

gpu::Context::Semaphores DeviceRenderer::semaphores_of(const vulkan::Target& target) {
    return {target.wait, target.signal};
}

void DeviceRenderer::render_into(const PlacedCamera& camera, const vulkan::Target& target) {
    if (!world_ || !graph_)
        throw Error("renderer: set_world() comes before render_into()");
    check_target(target);
    const TargetForm form{target.format, target.buffer};
    if (target_form_ != form) {
        target_form_ = form;
        build_again();
    }
    render(camera, 1, &target);
}

uint64_t DeviceRenderer::add_pass(vulkan::Pass pass) {
    const uint64_t number = own_passes_.add(std::move(pass));
    if (!world_)
        return number;
    try {
        build_again();
    } catch (...) {
        own_passes_.remove(number);
        build_again();
        throw;
    }
    return number;
}

void DeviceRenderer::remove_pass(uint64_t number) {
    drop_graph();
    const bool known = own_passes_.remove(number);
    if (world_)
        build_graph();
    if (!known)
        throw UsageError(fmt::format("remove_pass(): there is no pass {}", number));
}

void DeviceRenderer::own_passes(vulkan::Stage stage, graph::FrameGraph& graph, const resident::View& view,
                                const passes::SurfaceBuffers& surface, std::vector<OwnPasses::Offered> more) {
    more.push_back({"depth", surface.depth});
    if (surface.normal && surface.normal != surface.depth)
        more.push_back({"normal", surface.normal});
    own_passes_.build(stage, graph, view, more);
}

namespace vulkan {

void render_into(Renderer& renderer, const PlacedCamera& camera, const Target& target) {
    on_device(renderer).render_into(camera, target);
}

uint64_t add_pass(Renderer& renderer, Pass pass) { return on_device(renderer).add_pass(std::move(pass)); }
void remove_pass(Renderer& renderer, uint64_t pass) { on_device(renderer).remove_pass(pass); }

Presenter::Presenter(Device& device, VkSurfaceKHR surface) {
    const auto& context = dynamic_cast<const gpu::Context&>(device);
    if (!surface)
        throw UsageError("Presenter: no surface");
    if (!context.presents())
        throw Error(context.name() + ": was made without DeviceOptions::window_extensions or VK_KHR_swapchain, which a "
                                     "window needs");
    presenter_ = std::make_unique<gpu::Presenter>(context, surface);
}

Presenter::~Presenter() = default;

bool Presenter::show(const Renderer& renderer, VkExtent2D window,
                     const std::function<void(VkCommandBuffer, VkExtent2D)>& overlay, std::string_view buffer) {
    const auto* const shown = dynamic_cast<const DeviceRenderer*>(&renderer);
    if (!shown)
        throw UsageError("Presenter: this renderer draws on no device");
    if (buffer == "linear")
        throw UsageError("Presenter: linear: windows show what is display-encoded");
    presenter_->take(shown->shown(buffer));
    return presenter_->show(window, [&](const gpu::OverlayContext& over) {
        if (overlay)
            overlay(over.commands, over.extent);
    });
}

VkFormat Presenter::format() const { return presenter_->format(); }

} // namespace vulkan
} // namespace prelight
