#pragma once
#include "raster.hpp"
#include "sample_shading.hpp"
#include "shader_stage.hpp"
#include <array>
#include <compare>
#include <memory>

namespace prelight::gpu {

struct VertexAttribute {
    uint32_t location = 0;
    uint32_t binding = 0;
    VkFormat format = VK_FORMAT_R32G32B32_SFLOAT;
    uint32_t offset = 0;
    auto operator<=>(const VertexAttribute&) const = default;
};

enum class Blend {
    none,
    add,
    over, ///< colour that is multiplied by its alpha, over what is there; the target's alpha is multiplied by 1 − alpha
    by_alpha,      ///< glTF's BLEND: colour by its alpha, what is there by 1 − alpha
    add_by_alpha,  ///< colour by its alpha is added; the target's alpha stays
    add_and_cover, ///< colour is added; the target's alpha is multiplied by 1 − alpha
    transmit,      ///< colour multiplies what is there; the larger alpha stays
    alpha_only,    ///< nothing blends: the target's alpha is replaced, its colour stays
};
enum class DepthTest {
    none,
    write_nearer,
    write_farther,
    equal,
    behind_or_at,
    behind,
    before_or_at,
    surface_only,
    overwrite
};

/// What a draw does to stencil. Marks count the faces of a closed volume around a pixel's surface,
/// wrapping; with `depth` as `behind_or_at`, a face "passes" where the surface lies behind it.
enum class Stencil {
    none,
    mark_passing,   ///< camera outside: front faces that pass +1, back faces that pass −1
    mark_failing,   ///< camera inside: back faces that fail +1, front faces that fail −1
    marked_to_zero, ///< draws where the stencil is not 0, and zeroes it
    exported        ///< holds what the fragment shader says: OptionalFeatures::stencil_export
};

/// Everything of a graphics pipeline that Prelight varies. Depth is reversed: nearer is greater, so
/// that `write_nearer` is GREATER_OR_EQUAL, and `write_farther` the opposite. `behind_or_at`: a fragment passes where
/// the stored surface lies behind it (front faces of a light volume), `behind`: and not at it; `before_or_at` is the
/// opposite of the latter;
/// `surface_only`: at the far end, passes wherever a surface is; `overwrite`: passes everywhere and is written.
/// Cull mode and front face are dynamic state.
struct GraphicsPipelineDesc {
    std::string name;
    ShaderKey vertex;
    ShaderKey fragment;                   ///< may be empty: depth and stencil only
    std::vector<uint32_t> fragment_code;  ///< SPIR-V of a user's material
    Constants constants;                  ///< for both stages
    std::vector<uint32_t> vertex_strides; ///< one per vertex buffer binding
    uint32_t instance_binding = ~0u;      ///< the one that steps once an instance
    std::vector<VertexAttribute> attributes;
    Attachments attachments;
    Blend blend = Blend::none;
    DepthTest depth = DepthTest::none;
    bool depth_bounds = false; ///< vkCmdSetDepthBounds comes before each draw
    Stencil stencil = Stencil::none;
    bool depth_clamp = false;                               ///< where the device has it
    SampleShading sample_shading = SampleShading::fragment; ///< matters with several samples
    bool post_depth_coverage = false; ///< with_post_depth_coverage(), where each fragment is shaded
    uint32_t sample_mask = ~0u;       ///< of those, a bit for each that is drawn into
    std::vector<VkDescriptorSetLayout> sets;
    uint32_t push_bytes = 0;                                      ///< push constants; at most 128
    VkShaderStageFlags push_stage = VK_SHADER_STAGE_FRAGMENT_BIT; ///< the one that reads them
    /// Depth moves away from the viewer by this many times what it changes within a pixel.
    float slope_bias = 0;
    auto operator<=>(const GraphicsPipelineDesc&) const = default; ///< what is equal is one pipeline
};

/// A handle: equal descriptions share what is built, for as long as the device lives (PipelineLibrary).
class GraphicsPipeline {
public:
    GraphicsPipeline() = default;
    GraphicsPipeline(const Context& context, const GraphicsPipelineDesc& desc);
    /// Binds the pipeline with its default dynamic state: no culling, counter-clockwise front.
    void bind(VkCommandBuffer commands) const;
    VkPipelineLayout layout() const { return built_->layout; }
    void bind_set(VkCommandBuffer commands, uint32_t index, VkDescriptorSet set) const;
    /// All `push_bytes` of the description at once.
    void push(VkCommandBuffer commands, std::span<const std::byte> bytes) const;

private:
    std::shared_ptr<const BuiltPipeline> built_;
    VkShaderStageFlags push_stage_ = 0;
};

} // namespace prelight::gpu
