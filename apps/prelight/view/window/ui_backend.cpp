#include "ui_backend.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <imgui.h>
#include <shared/bindings.h>

namespace prelight::app::viewer {
namespace {

/// At least `size` bytes, with room to grow; the frame that used the buffer last is done.
void reserve(const gpu::Context& context, gpu::Buffer& buffer, const char* name, uint64_t size,
             VkBufferUsageFlags use) {
    if (buffer.size() < size)
        buffer = gpu::Buffer(context, name, std::max<uint64_t>(size * 3 / 2, 64 << 10), use, gpu::BufferPlace::upload);
}

TextureImage font_image() {
    unsigned char* texels = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&texels, &width, &height);
    TextureImage image{.name = "user interface font",
                       .width = static_cast<uint32_t>(width),
                       .height = static_cast<uint32_t>(height),
                       .rgba = {}};
    image.rgba.assign(texels, texels + size_t(4) * image.width * image.height);
    return image;
}

} // namespace

UiBackend::UiBackend(const gpu::Context& context, VkFormat format) : context_(context), memory_(context) {
    gpu::Uploader uploader(context);
    font_.emplace(context, memory_, uploader, font_image(), std::span<const TextureImage>(), // drawn at its size
                  gpu::TextureEncoding::linear8);
    uploader.finish();
    const Sampler linear{.wrap_s = Wrap::clamp_to_edge, .wrap_t = Wrap::clamp_to_edge, .mip = MipFilter::none};
    sampler_ = gpu::make_sampler(context, linear, gpu::TextureFilter::trilinear);
    const std::vector<gpu::Binding> bindings{gpu::Binding::texture(UI_TEXTURE, font_->view(), sampler_)};
    const VkDescriptorSetLayout layout = gpu::make_set_layout(context, "user interface", bindings);
    sets_ = gpu::DescriptorSets(context, "user interface", layout, std::span(&bindings, 1));
    ImGui::GetIO().Fonts->SetTexID(nullptr); // there is no other

    gpu::GraphicsPipelineDesc desc;
    desc.name = "user interface";
    desc.vertex = "ui.vert";
    desc.fragment = "ui.frag";
    desc.vertex_strides = {sizeof(ImDrawVert)};
    desc.attributes = {{UI_POSITION, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(ImDrawVert, pos)},
                       {UI_TEXCOORD, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(ImDrawVert, uv)},
                       {UI_COLOUR, 0, VK_FORMAT_R8G8B8A8_UNORM, offsetof(ImDrawVert, col)}};
    desc.attachments.colours = {format};
    desc.blend = gpu::Blend::over;
    desc.sets = {layout};
    desc.push_bytes = 4 * sizeof(float);
    desc.push_stage = VK_SHADER_STAGE_VERTEX_BIT;
    pipeline_ = gpu::GraphicsPipeline(context, desc);
}

UiBackend::~UiBackend() { context_.wait_idle(); }

void UiBackend::fill(const ImDrawData& data, Slot& slot) const {
    reserve(context_, slot.vertices, "user interface vertices", uint64_t(data.TotalVtxCount) * sizeof(ImDrawVert),
            VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    reserve(context_, slot.indices, "user interface indices", uint64_t(data.TotalIdxCount) * sizeof(ImDrawIdx),
            VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
    auto* vertices = slot.vertices.mapped<ImDrawVert>();
    auto* indices = slot.indices.mapped<ImDrawIdx>();
    for (int l = 0; l < data.CmdListsCount; ++l) {
        const ImDrawList& list = *data.CmdLists[l];
        vertices = std::copy(list.VtxBuffer.begin(), list.VtxBuffer.end(), vertices);
        indices = std::copy(list.IdxBuffer.begin(), list.IdxBuffer.end(), indices);
    }
}

void UiBackend::draw(const ImDrawData& data, const gpu::OverlayContext& target) {
    if (data.TotalVtxCount == 0 || data.DisplaySize.x <= 0 || data.DisplaySize.y <= 0)
        return;
    Slot& slot = slots_[target.slot];
    fill(data, slot);
    pipeline_.bind(target.commands);
    pipeline_.bind_set(target.commands, 0, sets_[0]);
    VkBuffer vertices = slot.vertices.handle();
    const VkDeviceSize start = 0;
    vkCmdBindVertexBuffers(target.commands, 0, 1, &vertices, &start);
    vkCmdBindIndexBuffer(target.commands, slot.indices.handle(), 0,
                         sizeof(ImDrawIdx) == 2 ? VK_INDEX_TYPE_UINT16 : VK_INDEX_TYPE_UINT32);
    const ImVec2 size = data.DisplaySize, from = data.DisplayPos, pixels = data.FramebufferScale;
    const float push[] = {2 / size.x, 2 / size.y, -1 - from.x * 2 / size.x, -1 - from.y * 2 / size.y};
    pipeline_.push(target.commands, std::as_bytes(std::span(push)));
    const VkViewport viewport{0, 0, float(target.extent.width), float(target.extent.height), 0, 1};
    vkCmdSetViewport(target.commands, 0, 1, &viewport);

    const auto pixel = [](float value, uint32_t most) {
        return static_cast<int32_t>(std::clamp(value, 0.0f, float(most)));
    };
    uint32_t first_index = 0;
    int32_t first_vertex = 0;
    for (int l = 0; l < data.CmdListsCount; ++l) {
        const ImDrawList& list = *data.CmdLists[l];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            const int32_t left = pixel((command.ClipRect.x - from.x) * pixels.x, target.extent.width);
            const int32_t top = pixel((command.ClipRect.y - from.y) * pixels.y, target.extent.height);
            const int32_t right = pixel((command.ClipRect.z - from.x) * pixels.x, target.extent.width);
            const int32_t bottom = pixel((command.ClipRect.w - from.y) * pixels.y, target.extent.height);
            if (command.UserCallback || right <= left || bottom <= top)
                continue;
            const VkRect2D scissor{{left, top}, {uint32_t(right - left), uint32_t(bottom - top)}};
            vkCmdSetScissor(target.commands, 0, 1, &scissor);
            vkCmdDrawIndexed(target.commands, command.ElemCount, 1, first_index + command.IdxOffset,
                             first_vertex + static_cast<int32_t>(command.VtxOffset), 0);
        }
        first_index += static_cast<uint32_t>(list.IdxBuffer.Size);
        first_vertex += list.VtxBuffer.Size;
    }
}

} // namespace prelight::app::viewer
