#include "own_passes.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <prelight/error.hpp>

namespace prelight {
namespace {

using vulkan::PassImages;
using vulkan::Stage;

const char* stage_name(Stage stage) {
    switch (stage) {
    case Stage::after_surfaces: return "after_surfaces";
    case Stage::after_light: return "after_light";
    case Stage::after_opaque: return "after_opaque";
    case Stage::before_display: return "before_display";
    default: return "after_display";
    }
}

graph::ImageId find_offered(const vulkan::Pass& pass, std::span<const OwnPasses::Offered> images,
                            std::string_view name) {
    const auto found = std::ranges::find(images, name, &OwnPasses::Offered::name);
    if (found != images.end())
        return found->image;
    std::string names;
    for (const OwnPasses::Offered& one : images)
        names += (names.empty() ? "" : ", ") + std::string(one.name);
    throw UsageError(fmt::format("pass {}: {}: no such image at {} (there are: {})", pass.name, name,
                                 stage_name(pass.stage), names));
}

/// One image of a pass, in the layout that it has there; its view comes when the graph is compiled.
struct Slot {
    PassImages::One described;
    graph::ImageId image;
};

Slot describe(const graph::FrameGraph& graph, std::string_view name, graph::ImageId image,
              const graph::Access& access) {
    const graph::ImageDesc& desc = graph.desc(image);
    return {{.name = std::string(name),
             .layout = access.layout,
             .format = desc.format,
             .extent = desc.raster.extent,
             .samples = desc.raster.samples},
            image};
}

struct Described {
    std::vector<Slot> reads, writes;
    std::optional<Slot> depth;
};

bool same_raster(const PassImages::One& a, const PassImages::One& b) {
    return a.extent.width == b.extent.width && a.extent.height == b.extent.height && a.samples == b.samples;
}

/// Attachments of one pass are of one raster.
void check_rasters(const vulkan::Pass& pass, const Described& all) {
    const Slot* first = !all.writes.empty() ? &all.writes[0] : nullptr;
    const auto check = [&](const Slot& one) {
        if (first && !same_raster(one.described, first->described))
            throw UsageError(fmt::format("pass {}: {} has {} samples a pixel at {}x{}, {} has {} at {}x{}", pass.name,
                                         one.described.name, one.described.samples, one.described.extent.width,
                                         one.described.extent.height, first->described.name, first->described.samples,
                                         first->described.extent.width, first->described.extent.height));
    };
    std::ranges::for_each(all.writes, check);
    if (all.depth)
        check(*all.depth);
}

} // namespace

uint64_t OwnPasses::add(vulkan::Pass pass) {
    if (pass.name.empty())
        throw UsageError("add_pass(): a pass without a name");
    if (!pass.record)
        throw UsageError(fmt::format("pass {}: record() is missing", pass.name));
    for (const std::string& written : pass.writes)
        if (written == "depth" || std::ranges::count(pass.writes, written) > 1 ||
            std::ranges::find(pass.reads, written) != pass.reads.end())
            throw UsageError(fmt::format("pass {}: {}: cannot be written, for it is {}", pass.name, written,
                                         written == "depth" ? "the depth buffer" : "read or written already"));
    passes_.emplace(next_, std::make_shared<const vulkan::Pass>(std::move(pass)));
    return next_++;
}

bool OwnPasses::any(Stage stage) const {
    return std::ranges::any_of(passes_, [&](const auto& one) { return one.second->stage == stage; });
}

void OwnPasses::build(Stage stage, graph::FrameGraph& graph, const resident::View& view,
                      std::span<const Offered> images) {
    for (const auto& entry : passes_) {
        const auto own = entry.second; // clang 14 captures no part of a structured binding
        if (own->stage != stage)
            continue;
        missing_.erase(entry.first);
        graph::Pass& pass = graph.pass(own->name);
        pass.always();
        auto all = std::make_shared<Described>();
        for (const std::string& name : own->writes) {
            const graph::ImageId image = find_offered(*own, images, name);
            pass.colour(image, graph::Load::keep).blends();
            all->writes.push_back(describe(graph, name, image, graph::Access::colour()));
        }
        for (const std::string& name : own->reads) {
            const graph::ImageId image = find_offered(*own, images, name);
            pass.sample(static_cast<uint32_t>(all->reads.size()), image);
            all->reads.push_back(
                describe(graph, name, image, graph::Access::sampled(graph::is_depth(graph.desc(image).format))));
        }
        if (own->depth_test) {
            const graph::ImageId depth = find_offered(*own, images, "depth");
            pass.depth_test(depth);
            all->depth = describe(graph, "depth", depth, graph::Access::depth_test());
        }
        check_rasters(*own, *all);
        auto shown = std::make_shared<PassImages>();
        pass.prepare([=, &graph](const graph::PassInterface&) {
            const auto with_view = [&](Slot one) {
                one.described.view = graph.sampled_view(one.image);
                return one.described;
            };
            for (const Slot& one : all->reads)
                shown->reads.push_back(with_view(one));
            for (const Slot& one : all->writes)
                shown->writes.push_back(with_view(one));
            if (all->depth)
                shown->depth_test = with_view(*all->depth);
            if (own->prepare)
                own->prepare(*shown);
        });
        pass.record([=, &view](const graph::PassContext& context) {
            if (!context.one_pixel)
                own->record({.commands = context.commands,
                             .images = *shown,
                             .clip_from_world = view.clip_from_world(),
                             .eye = view.eye(),
                             .slot = context.slot});
        });
    }
}

void OwnPasses::end() const {
    if (!missing_.empty()) {
        const vulkan::Pass& pass = *missing_.begin()->second;
        throw UsageError(fmt::format("pass {}: this renderer has no stage {}", pass.name, stage_name(pass.stage)));
    }
}

} // namespace prelight
