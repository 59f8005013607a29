#pragma once
#include <gpu/descriptors.hpp>
#include <gpu/pipeline.hpp>
#include <gpu/presenter.hpp>
#include <gpu/texture.hpp>

struct ImDrawData;

namespace prelight::app::viewer {

/// Draws what Dear ImGui has laid out, with dynamic rendering: the part that its own Vulkan back end does with render
/// passes. Of the current ImGui context it takes the font.
class UiBackend {
public:
    /// `format`: of the images that are drawn into. Throws Error.
    UiBackend(const gpu::Context& context, VkFormat format);
    ~UiBackend();
    UiBackend(const UiBackend&) = delete;
    UiBackend& operator=(const UiBackend&) = delete;
    void draw(const ImDrawData& data, const gpu::OverlayContext& target);

private:
    struct Slot {
        gpu::Buffer vertices, indices;
    };
    void fill(const ImDrawData& data, Slot& slot) const;

    const gpu::Context& context_;
    gpu::MemoryPool memory_;
    std::optional<gpu::Texture> font_;
    gpu::UniqueSampler sampler_;
    gpu::DescriptorSets sets_;
    gpu::GraphicsPipeline pipeline_;
    gpu::PerFrame<Slot> slots_;
};

} // namespace prelight::app::viewer
