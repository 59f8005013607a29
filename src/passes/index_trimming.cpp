#include "index_trimming.hpp"
#include <algorithm>
#include <gpu/compute_pipeline.hpp>
#include <optional>
#include <shared/bindings.h>
#include <shared/index_trimming.h>

namespace prelight::passes {
namespace {

/// Makes the pass run a shader with a workgroup for each group of triangles.
void dispatch_groups(graph::Pass& pass, const resident::View& view, const gpu::ShaderKey& shader,
                     const gpu::Constants& constants) {
    auto pipeline = std::make_shared<gpu::ComputePipeline>();
    pass.prepare([=, &view, name = pass.name()](const graph::PassInterface& interface) {
        *pipeline = gpu::ComputePipeline(view.context(), {.name = name,
                                                          .shader = shader,
                                                          .constants = constants,
                                                          .sets = {view.layout(), interface.inputs},
                                                          .push_bytes = sizeof(uint32_t)});
    });
    pass.record([=, &view](const graph::PassContext& context) {
        // Rows of workgroups, for a device may have no more than 65,535 in one.
        const uint32_t groups = view.device_trimming()->groups(), rows = (groups + TRIM_ROW - 1) / TRIM_ROW;
        if (groups == 0)
            return;
        pipeline->bind(context.commands);
        pipeline->bind_set(context.commands, SET_FRAME, view.set());
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
void trim(graph::FrameGraph& graph, const resident::View& view, const std::string& name, const Source& source,
          const resident::DeviceTrimming::Output& output, std::optional<graph::ImageId> depth) {
    const resident::DeviceTrimming& trimming = *view.device_trimming();
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
    const uint32_t samples = view.surface_raster().samples;
    const gpu::Constants constants{{CONSTANT_SAMPLES, samples},
                                   {CONSTANT_TRIM_SUBPIXEL_BITS, view.context().limits().subPixelPrecisionBits},
                                   {CONSTANT_TRIM_BY_DEPTH, depth.has_value()},
                                   {CONSTANT_TRIM_AGAIN, source.commands.has_value()}};
    graph::Pass& test = graph.pass(name + " test");
    declare(test, true);
    test.raster(view.raster());
    test.storage(INPUT_TRIM_OBJECTS, graph.buffer("objects", view.object_buffers()), false)
        .storage(INPUT_TRIM_POSITIONS, graph.buffer("positions", view.scene().geometry().positions), false);
    if (depth)
        test.sample(INPUT_DEPTH, *depth);
    dispatch_groups(test, view,
                    {"trim_test.comp", gpu::when(bool(depth), gpu::Variant::by_depth) |
                                           gpu::when(depth && samples > 1, gpu::Variant::samples)},
                    constants);

    graph::Pass& write = graph.pass(name + " write");
    declare(write, false);
    write.storage(INPUT_TRIM_INDICES, graph.buffer("kept indices", output.indices), true)
        .storage(INPUT_TRIM_COMMANDS, commands, true)
        .storage(INPUT_TRIM_COUNTS, graph.buffer("kept index counts", output.host_counts), true);
    dispatch_groups(write, view, "trim_write.comp", constants);
}

} // namespace

void index_trimming_passes(graph::FrameGraph& graph, const resident::View& view) {
    if (view.draw_options().trimming == resident::IndexTrimming::device)
        trim(graph, view, "geometry trimming", {graph.buffer("indices", view.scene().geometry().indices), {}},
             view.device_trimming()->first(), {});
}

void depth_trimming_passes(graph::FrameGraph& graph, const resident::View& view, graph::ImageId depth) {
    if (!view.draw_options().trims_by_depth)
        return;
    const resident::DeviceTrimming& trimming = *view.device_trimming();
    Source source;
    switch (view.draw_options().trimming) {
    case resident::IndexTrimming::off: source.indices = graph.buffer("indices", view.scene().geometry().indices); break;
    case resident::IndexTrimming::host: source.indices = graph.buffer("trimmed indices", view.trimmed_buffers()); break;
    case resident::IndexTrimming::device:
        source = {graph.buffer("kept indices", trimming.first().indices),
                  graph.buffer("trimmed draw commands", trimming.first().commands)};
    }
    trim(graph, view, "material trimming", source, trimming.later(), depth);
}

} // namespace prelight::passes
