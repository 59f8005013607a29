#include "resources.hpp"
#include <fmt/format.h>
#include <prelight/error.hpp>

namespace prelight::graph {
namespace {

constexpr VkPipelineStageFlags2 depth_stages =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
constexpr VkPipelineStageFlags2 shader_stages = VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT |
                                                VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT |
                                                VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;

struct FormatInfo {
    VkFormat format;
    uint32_t bytes;
    const char* name;
};
constexpr FormatInfo formats[] = {
    {VK_FORMAT_D32_SFLOAT, 4, "D32F"},
    {VK_FORMAT_D32_SFLOAT_S8_UINT, 5, "D32F_S8"},
    {VK_FORMAT_D24_UNORM_S8_UINT, 4, "D24_S8"},
    {VK_FORMAT_R8_UNORM, 1, "R8"},
    {VK_FORMAT_R16_UINT, 2, "R16UI"},
    {VK_FORMAT_R8G8_UNORM, 2, "RG8"},
    {VK_FORMAT_R16_SFLOAT, 2, "R16F"},
    {VK_FORMAT_R32_SFLOAT, 4, "R32F"},
    {VK_FORMAT_R32_UINT, 4, "R32UI"},
    {VK_FORMAT_R8G8B8A8_UNORM, 4, "RGBA8"},
    {VK_FORMAT_R8G8B8A8_SRGB, 4, "sRGBA8"},
    {VK_FORMAT_B8G8R8A8_UNORM, 4, "BGRA8"},
    {VK_FORMAT_B8G8R8A8_SRGB, 4, "sBGRA8"},
    {VK_FORMAT_A8B8G8R8_UNORM_PACK32, 4, "ABGR8"},
    {VK_FORMAT_A8B8G8R8_SRGB_PACK32, 4, "sABGR8"},
    {VK_FORMAT_A2B10G10R10_UNORM_PACK32, 4, "RGB10A2"},
    {VK_FORMAT_A2R10G10B10_UNORM_PACK32, 4, "BGR10A2"},
    {VK_FORMAT_B10G11R11_UFLOAT_PACK32, 4, "R11G11B10F"},
    {VK_FORMAT_R16G16_UNORM, 4, "RG16"},
    {VK_FORMAT_R16G16_SFLOAT, 4, "RG16F"},
    {VK_FORMAT_R16G16B16A16_SFLOAT, 8, "RGBA16F"},
    {VK_FORMAT_R16G16B16A16_UINT, 8, "RGBA16UI"},
    {VK_FORMAT_R32G32_SFLOAT, 8, "RG32F"},
    {VK_FORMAT_R32G32_UINT, 8, "RG32UI"},
    {VK_FORMAT_R32G32B32A32_SFLOAT, 16, "RGBA32F"},
    {VK_FORMAT_R32G32B32A32_UINT, 16, "RGBA32UI"},
};

const FormatInfo& find(VkFormat format) {
    for (const FormatInfo& info : formats)
        if (info.format == format)
            return info;
    throw Error(fmt::format("frame graph: VkFormat {} is not in its table", static_cast<int>(format)));
}

} // namespace

Access Access::colour() {
    return {VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
            VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
            VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, true};
}

Access Access::depth_write() {
    return {depth_stages,
            VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
            VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL, true};
}

Access Access::depth_test() {
    return {depth_stages, VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT,
            VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL, false};
}

Access Access::stencil_write() {
    return {depth_stages,
            VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
            VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_STENCIL_ATTACHMENT_OPTIMAL, true};
}

Access Access::sampled(bool depth) {
    return {VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
            VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
            depth ? VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, false};
}

Access Access::storage(bool writes) {
    return {shader_stages, VK_ACCESS_2_SHADER_STORAGE_READ_BIT | (writes ? VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT : 0),
            VK_IMAGE_LAYOUT_GENERAL, writes};
}

Access Access::storage_image() {
    return {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
            VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL, true};
}

Access Access::indirect() {
    return {VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT, VK_IMAGE_LAYOUT_GENERAL,
            false};
}

Access Access::indices() {
    return {VK_PIPELINE_STAGE_2_INDEX_INPUT_BIT, VK_ACCESS_2_INDEX_READ_BIT, VK_IMAGE_LAYOUT_GENERAL, false};
}

Access Access::condition() {
    return {VK_PIPELINE_STAGE_2_CONDITIONAL_RENDERING_BIT_EXT, VK_ACCESS_2_CONDITIONAL_RENDERING_READ_BIT_EXT,
            VK_IMAGE_LAYOUT_GENERAL, false};
}

Access Access::copied_to() {
    return {VK_PIPELINE_STAGE_2_COPY_BIT | VK_PIPELINE_STAGE_2_CLEAR_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
            VK_IMAGE_LAYOUT_GENERAL, true};
}

Access& Access::operator|=(const Access& other) {
    stages |= other.stages;
    access |= other.access;
    writes |= other.writes;
    return *this;
}

bool has_stencil(VkFormat format) {
    return format == VK_FORMAT_D32_SFLOAT_S8_UINT || format == VK_FORMAT_D24_UNORM_S8_UINT;
}
bool is_depth(VkFormat format) { return format == VK_FORMAT_D32_SFLOAT || has_stencil(format); }
VkImageAspectFlags aspects(VkFormat format) {
    if (has_stencil(format))
        return VK_IMAGE_ASPECT_DEPTH_BIT | VK_IMAGE_ASPECT_STENCIL_BIT;
    return is_depth(format) ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}
uint32_t texel_bytes(VkFormat format) { return find(format).bytes; }
std::string format_name(VkFormat format) { return find(format).name; }

} // namespace prelight::graph
