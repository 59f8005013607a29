#include "index_trimming.hpp"
#include <algorithm>
#include <gpu/compute_pipeline.hpp>
#include <optional>
#include <shared/bindings.h>
#include <shared/index_trimming.h>

namespace prelight::passes {
namespace {

/// Makes the pass run a shader with a workgroup for each group of triangles.
void dispatch_groups(graph::Pass& pass, const resident::Frame& frame, const std::string& shader,
                     const gpu::Constants& constants) {
    auto pipeline = std::make_shared<gpu::ComputePipeline>();
    pass.prepare([=, &frame, name = pass.name()](const graph::PassInterface& interface) {
        *pipeline = gpu::ComputePipeline(frame.context(), {.name = name,
                                                           .shader = shader,
                                                           .constants = constants,
                                                           .sets = {frame.layout(), interface.inputs},
                                                           .push_bytes = sizeof(uint32_t)});
    });
    pass.record([=, &frame](const graph::PassContext& context) {
        // Rows of workgroups, for a device may have no more than 65,535 in one.
        const uint32_t groups = frame.device_trimming()->groups(), rows = (groups + TRIM_ROW - 1) / TRIM_ROW;
        if (groups == 0)
            return;
        pipeline->bind(context.commands);
        pipeline->bind_set(context.commands, SET_FRAME, frame.set());
        pipeline->bind_set(context.commands, SET_INPUTS, context.inputs);
        pipeline->push(context.commands, std::as_bytes(std::span(&groups, 1)));
        vkCmdDispatch(context.commands, std::min(groups, uint32_t(TRIM_ROW)), rows, 1);
    });
}

struct Source {
    graph::BufferId indices;
    std::optional<graph::BufferId> commands; ///< of an earlier trimming on the device
};

/// One trimming: which triangles stay, and then their indices and commands.
void trim(graph::FrameGraph& graph, const resident::Frame& frame, const std::string& name, const Source& source,
          const resident::DeviceTrimming::Output& output, std::optional<graph::ImageId> depth) {
    const resident::DeviceTrimming& trimming = *frame.device_trimming();
    const graph::BufferId draws = graph.buffer("draws to trim", trimming.draws());
    const graph::BufferId groups = graph.buffer("groups to trim", trimming.group_list());
    const graph::BufferId masks = graph.buffer("trimming masks", trimming.masks());
    const graph::BufferId commands = graph.buffer("trimmed draw commands", output.commands);
    const auto declare = [&](graph::Pass& pass, bool writes_masks) {
        pass.storage(INPUT_TRIM_DRAWS, draws, false)
            .storage(INPUT_TRIM_GROUPS, groups, false)
            .storage(INPUT_TRIM_SOURCE, source.indices, false)
            .storage(INPUT_TRIM_SOURCE_COMMANDS, source.commands.value_or(draws), false) // else not read
            .storage(INPUT_TRIM_MASKS, masks, writes_masks);
    };
    const gpu::Constants constants{{CONSTANT_TRIM_SUBPIXEL_BITS, frame.context().limits().subPixelPrecisionBits},
                                   {CONSTANT_TRIM_BY_DEPTH, depth.has_value()},
                                   {CONSTANT_TRIM_AGAIN, source.commands.has_value()}};
    graph::Pass& test = graph.pass(name + " test");
    declare(test, true);
    test.storage(INPUT_TRIM_OBJECTS, graph.buffer("objects", frame.object_buffers()), false)
        .storage(INPUT_TRIM_POSITIONS, graph.buffer("positions", frame.geometry().positions), false);
    if (depth)
        test.sample(INPUT_DEPTH, *depth);
    dispatch_groups(test, frame, depth ? "trim_test+depth.comp" : "trim_test.comp", constants);

    graph::Pass& write = graph.pass(name + " write");
    declare(write, false);
    write.storage(INPUT_TRIM_INDICES, graph.buffer("kept indices", output.indices), true)
        .storage(INPUT_TRIM_COMMANDS, commands, true)
        .storage(INPUT_TRIM_COUNTS, graph.buffer("kept index counts", output.host_counts), true);
    dispatch_groups(write, frame, "trim_write.comp", constants);
}

} // namespace

void index_trimming_passes(graph::FrameGraph& graph, const resident::Frame& frame) {
    if (frame.draw_options().trimming == resident::IndexTrimming::device)
        trim(graph, frame, "geometry trimming", {graph.buffer("indices", frame.geometry().indices), {}},
             frame.device_trimming()->first(), {});
}

void depth_trimming_passes(graph::FrameGraph& graph, const resident::Frame& frame, graph::ImageId depth) {
    if (!frame.draw_options().trims_by_depth)
        return;
    const resident::DeviceTrimming& trimming = *frame.device_trimming();
    Source source;
    switch (frame.draw_options().trimming) {
    case resident::IndexTrimming::off: source.indices = graph.buffer("indices", frame.geometry().indices); break;
    case resident::IndexTrimming::host:
        source.indices = graph.buffer("trimmed indices", frame.trimmed_buffers());
        break;
    case resident::IndexTrimming::device:
        source = {graph.buffer("kept indices", trimming.first().indices),
                  graph.buffer("trimmed draw commands", trimming.first().commands)};
    }
    trim(graph, frame, "material trimming", source, trimming.later(), depth);
}

} // namespace prelight::passes
