#include "target.hpp"
#include "fullscreen.hpp"
#include <algorithm>
#include <array>
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

constexpr std::array target_formats{VK_FORMAT_R8G8B8A8_UNORM,           VK_FORMAT_R8G8B8A8_SRGB,
                                    VK_FORMAT_B8G8R8A8_UNORM,           VK_FORMAT_B8G8R8A8_SRGB,
                                    VK_FORMAT_A8B8G8R8_UNORM_PACK32,    VK_FORMAT_A8B8G8R8_SRGB_PACK32,
                                    VK_FORMAT_A2B10G10R10_UNORM_PACK32, VK_FORMAT_A2R10G10B10_UNORM_PACK32,
                                    VK_FORMAT_R16G16B16A16_SFLOAT,      VK_FORMAT_R32G32B32A32_SFLOAT};

bool encodes_itself(VkFormat format) {
    return format == VK_FORMAT_R8G8B8A8_SRGB || format == VK_FORMAT_B8G8R8A8_SRGB ||
           format == VK_FORMAT_A8B8G8R8_SRGB_PACK32;
}

uint32_t conversion(VkFormat buffer, VkFormat target) {
    if (encodes_itself(buffer)) // sampled linear
        return encodes_itself(target) ? TARGET_AS_IT_IS : TARGET_ENCODE;
    return buffer == VK_FORMAT_R8G8B8A8_UNORM && encodes_itself(target) ? TARGET_DECODE : TARGET_AS_IT_IS;
}

} // namespace

bool is_target_format(VkFormat format) { return std::ranges::find(target_formats, format) != target_formats.end(); }

void target_pass(graph::FrameGraph& graph, const resident::View& view, graph::ImageId buffer, VkFormat format) {
    const graph::ImageId target = graph.external_image("target", {format, graph.raster(buffer)});
    graph::Pass& pass = graph.pass("target");
    pass.colour(target, graph::Load::discard).sample(INPUT_COLOUR, buffer);
    draw_fullscreen(pass, view, "target.frag",
                    {{CONSTANT_TARGET_CONVERSION, conversion(graph.desc(buffer).format, format)}});
}

} // namespace prelight::passes
