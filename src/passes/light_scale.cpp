#include "light_scale.hpp"
#include <algorithm>
#include <bit>
#include <fmt/format.h>
#include <gpu/barrier.hpp>
#include <gpu/compute_pipeline.hpp>
#include <shared/bindings.h>
#include <shared/light_scale.h>

namespace prelight::passes {
namespace {

/// More clipped pixels than this are more than a few highlights that the sampling missed.
constexpr double clipped_share = 0.001;

uint32_t groups_of(uint32_t count, uint32_t size) { return (count + size - 1) / size; }

/// A compute pass whose shader may be given one number; `dispatch` comes when all is bound.
void dispatches(graph::Pass& pass, const resident::View& view, const gpu::ShaderKey& shader,
                const gpu::Constants& constants,
                std::function<void(const graph::PassContext&, const gpu::ComputePipeline&)> dispatch,
                uint32_t push_bytes = 0) {
    auto pipeline = std::make_shared<gpu::ComputePipeline>();
    pass.prepare([=, &view, name = pass.name()](const graph::PassInterface& interface) {
        *pipeline = gpu::ComputePipeline(view.context(), {.name = name,
                                                          .shader = shader,
                                                          .constants = constants,
                                                          .sets = {view.layout(), interface.inputs},
                                                          .push_bytes = push_bytes});
    });
    pass.record([pipeline, dispatch = std::move(dispatch), &view](const graph::PassContext& context) {
        pipeline->bind(context.commands);
        pipeline->bind_set(context.commands, SET_FRAME, view.set());
        pipeline->bind_set(context.commands, SET_INPUTS, context.inputs);
        dispatch(context, *pipeline);
    });
}

} // namespace

FixedPoint fixed_point(const LightModel& model) {
    constexpr uint32_t r = 1, b = 4, a = 8, rgb = 7;
    FixedPoint form{.codes = model.buffer == LightBufferFormat::rgb10a2 ? 1023.0f : 255.0f,
                    .most = model.shading == Shading::ggx ? 32.0f : 10.0f, // [ggx] divides diffuse light by π
                    .packed = model.packed()};
    if (model.packed()) {
        form.first = (model.specular == SpecularWay::luv ? b : rgb) | a;
        form.second = model.specular == SpecularWay::fifth_channel ? r : 0;
    }
    return form;
}

FixedPoint fixed_point_of_deferred() { return {.most = 4, .first = 15, .second = 0}; }

struct LightScale::Shared {
    gpu::PerFrame<gpu::Buffer> results; ///< LightScaleResult
    gpu::Buffer histogram;
    uint32_t slot = 0; ///< of the last recording
    uint64_t pixels = 0;
};

LightScale::LightScale(const resident::View& view, const FixedPoint& form, bool measured)
    : form_(form), fixed_scale_(view.light_scale()), measured_(measured), shared_(std::make_shared<Shared>()) {
    for (gpu::Buffer& result : shared_->results)
        result = gpu::Buffer(view.context(), "light scale", sizeof(shared::LightScaleResult),
                             VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::BufferPlace::readback);
    shared_->pixels = uint64_t(view.raster().extent.width) * view.raster().extent.height;
    if (measured)
        shared_->histogram = gpu::make_device_buffer(
            view.context(), "light histogram",
            std::vector<std::byte>(sizeof(shared::LightHistogram) + 2 * LIGHT_BINS * sizeof(uint32_t)),
            VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
}

void LightScale::measure(graph::FrameGraph& graph, const resident::View& view, const LightingInputs& lighting) const {
    if (!measured_)
        return;
    const bool deferred = lighting.target.deferred();
    LightingInputs inputs = lighting;
    inputs.count_pairs = false;
    if (!deferred)
        inputs.target = {};
    if (inputs.shadows.reused)
        inputs.shadows = {}; // one light's maps at a time: as if there were none
    const graph::BufferId histogram = graph.buffer("light histogram", shared_->histogram);
    graph::Pass& peaks = graph.pass("light-peaks");
    declare_lit_surface(graph, peaks, inputs);
    if (deferred)
        peaks.sample(INPUT_COLOUR_BEFORE, lighting.target.images[0]);
    peaks.storage(INPUT_LIGHT_HISTOGRAM, histogram, true);
    const uint32_t step = shared::light_sample_step(view.raster().extent.width, view.raster().extent.height);
    gpu::Constants constants = lighting_constants(view, inputs);
    constants.emplace_back(CONSTANT_LIGHT_SAMPLE_STEP, step);
    dispatches(
        peaks, view, lighting_shader(inputs, "light_peaks.comp"), constants,
        [&view, side = step * LIGHT_SAMPLE_GROUP](const graph::PassContext& context,
                                                  const gpu::ComputePipeline& pipeline) {
            const auto lights = static_cast<uint32_t>(view.light_groups().order.size());
            pipeline.push(context.commands, std::as_bytes(std::span(&lights, 1)));
            const VkExtent2D all = context.one_pixel ? VkExtent2D{1, 1} : view.raster().extent;
            vkCmdDispatch(context.commands, groups_of(all.width, side), groups_of(all.height, side), 1);
        },
        sizeof(uint32_t));

    graph::Pass& scale = graph.pass("light-scale");
    scale.storage(INPUT_LIGHT_HISTOGRAM, histogram, true)
        .storage(INPUT_LIGHT_SCALE, graph.buffer("light scale", shared_->results), true)
        .storage(INPUT_FRAME_CONSTANTS, graph.buffer("frame constants", view.constant_buffers()), true);
    dispatches(scale, view, "light_scale.comp",
               {{CONSTANT_LIGHT_CODES, std::bit_cast<uint32_t>(form_.codes)},
                {CONSTANT_LIGHT_MOST, std::bit_cast<uint32_t>(form_.most)},
                {CONSTANT_LIGHTS_BLENDED, !lighting.write_once && !resident::builds_lists(view.culling())}},
               [](const graph::PassContext& context, const gpu::ComputePipeline&) {
                   constexpr VkPipelineStageFlags2 all = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                                   compute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
                   // Every pass reads the frame's constants, and says so to nobody.
                   gpu::memory_barrier(context.commands, all, VK_ACCESS_2_NONE, compute,
                                       VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
                   vkCmdDispatch(context.commands, 1, 1, 1);
                   gpu::memory_barrier(context.commands, compute, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, all,
                                       VK_ACCESS_2_UNIFORM_READ_BIT);
               });
}

void LightScale::count_clipped(graph::FrameGraph& graph, const resident::View& view, graph::ImageId first,
                               graph::ImageId second) const {
    graph.before_frame([shared = shared_](const gpu::FrameTurn& turn) {
        shared->slot = turn.slot;
        shared->results[turn.slot].mapped<shared::LightScaleResult>()->clipped = 0;
    });
    graph::Pass& pass = graph.pass("light-clipping");
    pass.raster(graph.raster(first))
        .sample(INPUT_DIFFUSE_LIGHT, first)
        .sample(INPUT_SPECULAR_LIGHT, second)
        .storage(INPUT_LIGHT_SCALE, graph.buffer("light scale", shared_->results), true);
    dispatches(pass, view, "light_clipping.comp",
               {{CONSTANT_CLIPPING_FIRST, form_.first}, {CONSTANT_CLIPPING_SECOND, form_.second}},
               [&view](const graph::PassContext& context, const gpu::ComputePipeline&) {
                   const VkExtent2D all = context.one_pixel ? VkExtent2D{1, 1} : view.raster().extent;
                   vkCmdDispatch(context.commands, groups_of(all.width, LIGHT_CLIP_GROUP),
                                 groups_of(all.height, LIGHT_CLIP_GROUP), 1);
               });
}

void LightScale::tell(Stats& stats) const {
    const auto& result = *shared_->results[shared_->slot].mapped<const shared::LightScaleResult>();
    LightBufferStats figures{
        .diffuse_scale = fixed_scale_, .specular_scale = fixed_scale_, .clipped_pixels = result.clipped};
    if (measured_) {
        figures.diffuse_scale = double(result.scale[0]);
        figures.specular_scale = form_.second || form_.packed ? double(result.scale[1]) : figures.diffuse_scale;
    }
    stats.light_buffer = figures;
    const double share = static_cast<double>(figures.clipped_pixels) / static_cast<double>(shared_->pixels);
    // What is brighter than the largest scale is not lost to the picture.
    const bool at_most = std::max(figures.diffuse_scale, figures.specular_scale) >= double(form_.most);
    if (measured_ ? share > clipped_share && !at_most : figures.clipped_pixels > 0)
        stats.notes.push_back(fmt::format(
            "light-scale: {} pixels, {:.2g} % of the picture, hold the largest light that the light buffer "
            "can: theirs may be more{}",
            figures.clipped_pixels, share * 100, measured_ ? "" : " (light-scale=auto finds a scale that fits)"));
}

} // namespace prelight::passes
