#include "behind.hpp"
#include <fmt/format.h>
#include <gpu/compute_pipeline.hpp>
#include <gpu/context.hpp>
#include <prelight/error.hpp>
#include <shared/behind.h>
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

uint32_t groups_along(int texels) { return static_cast<uint32_t>((texels + BEHIND_GROUP - 1) / BEHIND_GROUP); }

/// Room for all levels.
VkExtent2D extent_of(glm::ivec2 size, int last) {
    glm::ivec2 end = size;
    for (int level = 1; level <= last; ++level)
        end = glm::max(end, shared::behind_corner(size, level) + shared::behind_size(size, level));
    return {static_cast<uint32_t>(end.x), static_cast<uint32_t>(end.y)};
}

void level_pass(graph::FrameGraph& graph, const resident::View& view, graph::ImageId from, graph::ImageId to,
                glm::ivec2 size, int level) {
    graph::Pass& pass = graph.pass(fmt::format("behind {}", level));
    pass.raster(view.raster()).sample(INPUT_COLOUR, from).store(INPUT_BEHIND_TARGET, to);
    auto pipeline = std::make_shared<gpu::ComputePipeline>();
    pass.prepare([=, &view](const graph::PassInterface& interface) {
        *pipeline = gpu::ComputePipeline(view.context(), {.name = level == 0 ? "behind copy" : "behind level",
                                                          .shader = "behind_level.comp",
                                                          .constants = {{CONSTANT_BEHIND_COPIES, level == 0}},
                                                          .sets = {view.layout(), interface.inputs},
                                                          .push_bytes = sizeof level});
    });
    const glm::ivec2 texels = shared::behind_size(size, level);
    pass.record([=, &view](const graph::PassContext& context) {
        pipeline->bind(context.commands);
        pipeline->bind_set(context.commands, SET_FRAME, view.set());
        pipeline->bind_set(context.commands, SET_INPUTS, context.inputs);
        pipeline->push(context.commands, std::as_bytes(std::span(&level, 1)));
        vkCmdDispatch(context.commands, context.one_pixel ? 1 : groups_along(texels.x),
                      context.one_pixel ? 1 : groups_along(texels.y), 1);
    });
}

} // namespace

Behind behind_passes(graph::FrameGraph& graph, const resident::View& view, graph::ImageId linear) {
    const auto [width, height] = view.raster().extent;
    const glm::ivec2 size(width, height);
    const int last = shared::behind_last_level(size);
    const VkExtent2D extent = extent_of(size, last);
    if (const uint32_t most = view.context().limits().maxImageDimension2D; std::max(extent.width, extent.height) > most)
        throw Error(fmt::format("{}: picture of {}x{}: what transmissive materials show takes an image of {}x{}, the "
                                "device's limit is {} (transparency=opaque takes none)",
                                view.context().name(), width, height, extent.width, extent.height, most));
    const Behind out{graph.image("behind", {VK_FORMAT_R16G16B16A16_SFLOAT, {extent}}), static_cast<uint32_t>(last)};
    for (int level = 0; level <= last; ++level)
        level_pass(graph, view, level == 0 ? linear : out.image, out.image, size, level);
    return out;
}

} // namespace prelight::passes
