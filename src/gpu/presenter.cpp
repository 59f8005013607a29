#include "presenter.hpp"
#include "check.hpp"
#include "texture.hpp"
#include <algorithm>
#include <cmath>
#include <shared/bindings.h>

namespace prelight::gpu {
namespace {

constexpr VkFormat picture_format = VK_FORMAT_R8G8B8A8_UNORM;
constexpr VkImageSubresourceRange whole{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
constexpr VkImageSubresourceLayers layer{VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};

struct Use {
    VkPipelineStageFlags2 stages = 0;
    VkAccessFlags2 access = 0;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
};
constexpr Use copied_from{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
                          VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};
constexpr Use copied_to{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                        VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
constexpr Use sampled{VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                      VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
constexpr Use drawn{VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                    VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
                    VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};

void transition(VkCommandBuffer commands, VkImage image, const Use& from, const Use& to) {
    VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    barrier.srcStageMask = from.stages;
    barrier.srcAccessMask = from.access;
    barrier.dstStageMask = to.stages;
    barrier.dstAccessMask = to.access;
    barrier.oldLayout = from.layout;
    barrier.newLayout = to.layout;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = whole;
    VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    info.imageMemoryBarrierCount = 1;
    info.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &info);
}

bool equal(VkExtent2D a, VkExtent2D b) { return a.width == b.width && a.height == b.height; }

} // namespace

Presenter::Presenter(const Context& context, VkSurfaceKHR surface) : context_(context), swapchain_(context, surface) {
    for (Slot& slot : slots_) {
        slot.recorded = make_command_slot(context, "window commands");
        slot.ready = make_semaphore(context, "window image ready");
    }
    sampler_ =
        make_sampler(context, {.wrap_s = Wrap::clamp_to_edge, .wrap_t = Wrap::clamp_to_edge, .mip = MipFilter::none},
                     TextureFilter::trilinear);
    make_pipeline();
}

void Presenter::make_pipeline() {
    const Binding picture = Binding::texture(WINDOW_PICTURE, VK_NULL_HANDLE, sampler_);
    layout_ = make_set_layout(context_, "window picture", std::span(&picture, 1));
    GraphicsPipelineDesc desc;
    desc.name = "window picture";
    desc.vertex = "fullscreen.vert";
    desc.fragment = "window_picture.frag";
    desc.attachments.colours = {format()};
    desc.sets = {layout_};
    desc.push_bytes = 2 * sizeof(float);
    pipeline_ = GraphicsPipeline(context_, desc);
}

Presenter::~Presenter() { context_.wait_idle(); }

void Presenter::wait(Slot& slot) {
    if (const uint64_t value = std::exchange(slot.value, 0))
        context_.wait(value);
}

void Presenter::make_picture(VkExtent2D extent) {
    if (picture_ && equal(extent, extent_))
        return;
    for (Slot& slot : slots_)
        wait(slot);
    filled_ = false;
    set_ = {};
    view_ = {};
    picture_ = {}; // before the memory that it lies in
    VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = picture_format;
    info.extent = {extent.width, extent.height, 1};
    info.mipLevels = info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    VkImage handle = VK_NULL_HANDLE;
    check(vkCreateImage(context_.device(), &info, nullptr, &handle), "window picture");
    UniqueImage image(context_.device(), handle);
    context_.count_created(Context::Kind::image);
    context_.set_name(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<uint64_t>(handle), "window picture");
    VkMemoryRequirements requirements{};
    vkGetImageMemoryRequirements(context_.device(), handle, &requirements);
    memory_ = Allocation(context_, requirements.size,
                         context_.memory_type(requirements.memoryTypeBits, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT), false);
    check(vkBindImageMemory(context_.device(), handle, memory_.memory(), 0), "window picture");
    picture_ = std::move(image);
    extent_ = extent;
    make_set();
}

void Presenter::make_set() {
    VkImageViewCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    info.image = picture_;
    info.viewType = VK_IMAGE_VIEW_TYPE_2D;
    info.format = picture_format;
    info.subresourceRange = whole;
    VkImageView handle = VK_NULL_HANDLE;
    check(vkCreateImageView(context_.device(), &info, nullptr, &handle), "window picture");
    view_ = {context_.device(), handle};
    context_.set_name(VK_OBJECT_TYPE_IMAGE_VIEW, reinterpret_cast<uint64_t>(handle), "window picture");
    const std::vector<Binding> bindings{Binding::texture(WINDOW_PICTURE, view_, sampler_)};
    set_ = DescriptorSets(context_, "window picture", layout_, std::span(&bindings, 1));
}

void Presenter::take(const Image& display) {
    taken_.reset();
    make_picture({display.width, display.height});
    const Buffer staging(context_, "window picture", display.pixels.size() * 4, VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                         BufferPlace::upload);
    auto* bytes = staging.mapped<uint8_t>();
    for (const glm::vec3& pixel : display.pixels) {
        for (int c = 0; c < 3; ++c)
            *bytes++ = static_cast<uint8_t>(std::lround(std::clamp(pixel[c], 0.0f, 1.0f) * 255));
        *bytes++ = 255;
    }
    context_.run("window picture", [&](VkCommandBuffer commands) {
        transition(commands, picture_, {sampled.stages, 0, VK_IMAGE_LAYOUT_UNDEFINED}, copied_to);
        VkBufferImageCopy copy{};
        copy.imageSubresource = layer;
        copy.imageExtent = {display.width, display.height, 1};
        vkCmdCopyBufferToImage(commands, staging.handle(), picture_, copied_to.layout, 1, &copy);
        transition(commands, picture_, copied_to, sampled);
    });
    filled_ = true;
}

void Presenter::copy_taken(VkCommandBuffer commands) {
    const Use before{taken_->stages, taken_->access, taken_->layout};
    transition(commands, taken_->image, before, copied_from);
    transition(commands, picture_, {sampled.stages, 0, VK_IMAGE_LAYOUT_UNDEFINED}, copied_to);
    VkImageCopy copy{};
    copy.srcSubresource = copy.dstSubresource = layer;
    copy.extent = {extent_.width, extent_.height, 1};
    // Formats of one size: bytes as they are, whether or not the renderer's is called sRGB.
    vkCmdCopyImage(commands, taken_->image, copied_from.layout, picture_, copied_to.layout, 1, &copy);
    transition(commands, picture_, copied_to, sampled);
    transition(commands, taken_->image, {copied_from.stages, 0, copied_from.layout},
               {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT, taken_->layout});
    taken_.reset();
    filled_ = true;
}

void Presenter::draw_picture(VkCommandBuffer commands, VkExtent2D window) const {
    pipeline_.bind(commands);
    pipeline_.bind_set(commands, 0, set_[0]);
    const float push[] = {static_cast<float>(window.width), static_cast<float>(window.height)};
    pipeline_.push(commands, std::as_bytes(std::span(push)));
    const VkViewport viewport{0, 0, push[0], push[1], 0, 1};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    const VkRect2D scissor{{}, window};
    vkCmdSetScissor(commands, 0, 1, &scissor);
    vkCmdDraw(commands, 3, 1, 0, 0);
}

void Presenter::record(VkCommandBuffer commands, uint32_t index, uint32_t slot,
                       const std::function<void(const OverlayContext&)>& overlay) {
    const VkExtent2D window = swapchain_.extent();
    if (taken_)
        copy_taken(commands);
    VkImage target = swapchain_.image(index);
    transition(commands, target, {drawn.stages, 0, VK_IMAGE_LAYOUT_UNDEFINED}, drawn); // after the semaphore's wait
    VkRenderingAttachmentInfo attachment{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    attachment.imageView = swapchain_.view(index);
    attachment.imageLayout = drawn.layout;
    attachment.loadOp = filled_ ? VK_ATTACHMENT_LOAD_OP_DONT_CARE : VK_ATTACHMENT_LOAD_OP_CLEAR;
    attachment.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    attachment.clearValue.color = {{0.15f, 0.15f, 0.15f, 1}};
    VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
    rendering.renderArea.extent = window;
    rendering.layerCount = 1;
    rendering.colorAttachmentCount = 1;
    rendering.pColorAttachments = &attachment;
    vkCmdBeginRendering(commands, &rendering);
    if (filled_)
        draw_picture(commands, window);
    if (overlay)
        overlay({commands, window, slot});
    vkCmdEndRendering(commands);
    transition(commands, target, drawn, {VK_PIPELINE_STAGE_2_NONE, 0, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR});
}

bool Presenter::show(VkExtent2D window, const std::function<void(const OverlayContext&)>& overlay) {
    if (taken_)
        make_picture(taken_->extent);
    if (window.width == 0 || window.height == 0) {
        taken_.reset();
        return false;
    }
    if (swapchain_.stale() || !equal(window, swapchain_.extent())) {
        context_.wait_idle();
        swapchain_.make(window);
    }
    slot_ = (slot_ + 1) % frames_in_flight;
    Slot& slot = slots_[slot_];
    wait(slot);
    const std::optional<uint32_t> index = swapchain_.acquire(slot.ready);
    if (!index) {
        taken_.reset();
        return false;
    }
    begin_commands(context_, slot.recorded);
    const VkCommandBuffer commands = slot.recorded.commands;
    context_.begin_label(commands, "window");
    record(commands, *index, slot_, overlay);
    context_.end_label(commands);
    check(vkEndCommandBuffer(commands), "window");
    slot.value = context_.submit(commands, {.wait = {{.semaphore = slot.ready, .stages = drawn.stages}},
                                            .signal = {{.semaphore = swapchain_.done(*index)}}});
    swapchain_.present(*index);
    return true;
}

} // namespace prelight::gpu
