// Proof that validation watches: commands with a missing barrier between dynamic rendering and what
// comes after must be reported, and the same commands with the barrier must not. Each test has a
// device of its own, so that its messages fail no other test.
#include "devices.hpp"
#include "programs.hpp"
#include <gmock/gmock.h>
#include <gpu/buffer.hpp>
#include <gpu/check.hpp>

namespace prelight {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/// A picture of its own with memory and view, always in layout GENERAL so that a missing barrier is
/// the only mistake.
struct Picture {
    gpu::Allocation memory;
    gpu::UniqueImage image;
    gpu::UniqueImageView view;

    explicit Picture(const gpu::Context& context) {
        VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
        info.imageType = VK_IMAGE_TYPE_2D;
        info.format = VK_FORMAT_R8G8B8A8_UNORM;
        info.extent = {64, 64, 1};
        info.mipLevels = info.arrayLayers = 1;
        info.samples = VK_SAMPLE_COUNT_1_BIT;
        info.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
        VkImage handle = VK_NULL_HANDLE;
        gpu::check(vkCreateImage(context.device(), &info, nullptr, &handle), "picture");
        image = {context.device(), handle};
        VkMemoryRequirements needs{};
        vkGetImageMemoryRequirements(context.device(), handle, &needs);
        memory = gpu::Allocation(context, needs.size, context.memory_type(needs.memoryTypeBits, 0), false);
        gpu::check(vkBindImageMemory(context.device(), handle, memory.memory(), 0), "picture");
        VkImageViewCreateInfo view_info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
        view_info.image = handle;
        view_info.viewType = VK_IMAGE_VIEW_TYPE_2D;
        view_info.format = info.format;
        view_info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        VkImageView view_handle = VK_NULL_HANDLE;
        gpu::check(vkCreateImageView(context.device(), &view_info, nullptr, &view_handle), "picture");
        view = {context.device(), view_handle};
    }

    void barrier(VkCommandBuffer commands, VkImageLayout from, VkPipelineStageFlags2 before_stage,
                 VkAccessFlags2 before, VkPipelineStageFlags2 after_stage, VkAccessFlags2 after) const {
        VkImageMemoryBarrier2 b{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
        b.srcStageMask = before_stage;
        b.srcAccessMask = before;
        b.dstStageMask = after_stage;
        b.dstAccessMask = after;
        b.oldLayout = from;
        b.newLayout = VK_IMAGE_LAYOUT_GENERAL;
        b.srcQueueFamilyIndex = b.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        b.image = image;
        b.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
        dependency.imageMemoryBarrierCount = 1;
        dependency.pImageMemoryBarriers = &b;
        vkCmdPipelineBarrier2(commands, &dependency);
    }

    void clear(VkCommandBuffer commands) const {
        VkRenderingAttachmentInfo attachment{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
        attachment.imageView = view;
        attachment.imageLayout = VK_IMAGE_LAYOUT_GENERAL;
        attachment.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
        attachment.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
        VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
        info.renderArea = {{0, 0}, {64, 64}};
        info.layerCount = 1;
        info.colorAttachmentCount = 1;
        info.pColorAttachments = &attachment;
        vkCmdBeginRendering(commands, &info);
        vkCmdEndRendering(commands);
    }
};

constexpr auto output = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
constexpr auto write = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;

class PlantedHazard : public testing::TestWithParam<Driver> {
protected:
    void SetUp() override {
        if (GetParam() == Driver::swiftshader && !swiftshader_installed())
            GTEST_SKIP() << "SwiftShader is not installed (Debian's package chromium has it)";
        device_ = make_device(GetParam());
        if (!newer_layer_installed())
            GTEST_SKIP() << "the validation layer of Debian's package chromium-common is not in use; "
                            "the packaged one misses hazards in dynamic rendering";
    }
    std::unique_ptr<gpu::Context> device_;
};
INSTANTIATE_TEST_SUITE_P(Drivers, PlantedHazard, testing::Values(Driver::lavapipe, Driver::swiftshader), driver_name);

/// Draws, then reads in a compute shader.
std::vector<std::string> write_then_read(const gpu::Context& device, bool with_barrier) {
    const Picture picture(device);
    const gpu::Buffer target(device, "target", 64 * 4, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::BufferPlace::readback);
    const std::vector<gpu::Binding> bindings{gpu::Binding::storage(0, target.handle()),
                                             gpu::Binding::sampled(1, picture.view, VK_IMAGE_LAYOUT_GENERAL)};
    const VkDescriptorSetLayout layout = gpu::make_set_layout(device, "read", bindings);
    const gpu::DescriptorSets sets(device, "read", layout, {{bindings}});
    const Program program(device, "read_image.comp", layout);
    device.run("planted", [&](VkCommandBuffer commands) {
        picture.barrier(commands, VK_IMAGE_LAYOUT_UNDEFINED, 0, 0, output, write);
        picture.clear(commands);
        if (with_barrier)
            picture.barrier(commands, VK_IMAGE_LAYOUT_GENERAL, output, write, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                            VK_ACCESS_2_SHADER_SAMPLED_READ_BIT);
        program.run(commands, sets[0]);
    });
    return device.validation_messages();
}

TEST_P(PlantedHazard, AReadAfterRenderingIsReported) {
    EXPECT_THAT(write_then_read(*device_, false), Contains(AllOf(HasSubstr("READ_AFTER_WRITE"), HasSubstr("hazard"))));
}

TEST_P(PlantedHazard, AReadAfterRenderingWithABarrierIsNot) { EXPECT_THAT(write_then_read(*device_, true), IsEmpty()); }

std::vector<std::string> write_then_write(const gpu::Context& device, bool with_barrier) {
    const Picture picture(device);
    device.run("planted", [&](VkCommandBuffer commands) {
        picture.barrier(commands, VK_IMAGE_LAYOUT_UNDEFINED, 0, 0, output, write);
        picture.clear(commands);
        if (with_barrier)
            picture.barrier(commands, VK_IMAGE_LAYOUT_GENERAL, output, write, output, write);
        picture.clear(commands);
    });
    return device.validation_messages();
}

TEST_P(PlantedHazard, AnAttachmentWriteAfterAWriteIsReported) {
    EXPECT_THAT(write_then_write(*device_, false),
                Contains(AllOf(HasSubstr("WRITE_AFTER_WRITE"), HasSubstr("hazard"))));
}

TEST_P(PlantedHazard, AnAttachmentWriteAfterAWriteWithABarrierIsNot) {
    EXPECT_THAT(write_then_write(*device_, true), IsEmpty());
}

} // namespace
} // namespace prelight
