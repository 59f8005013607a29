#include "surface_draws.hpp"
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

using resident::VertexAttributes;

// Vertex buffer bindings.
constexpr uint32_t positions = 0, attributes = 1, previous_positions = 2, objects = 3, groups = 4;

/// Three rows of ObjectData.
void add_rows(std::vector<gpu::VertexAttribute>& out, uint32_t location, size_t offset) {
    for (uint32_t row = 0; row < 3; ++row)
        out.push_back({location + row, objects, VK_FORMAT_R32G32B32A32_SFLOAT,
                       static_cast<uint32_t>(offset + row * sizeof(glm::vec4))});
}

std::vector<gpu::VertexAttribute> position_attributes(gpu::Variants variants) {
    std::vector<gpu::VertexAttribute> out{{VERTEX_POSITION, positions, VK_FORMAT_R32G32B32_SFLOAT, 0}};
    if (variants.has(gpu::Variant::facing)) // how far it stands from there
        out.push_back({VERTEX_NORMAL, attributes, VK_FORMAT_R32G32B32_SFLOAT, offsetof(VertexAttributes, normal)});
    add_rows(out, VERTEX_WORLD_ROW, offsetof(shared::ObjectData, world_row));
    return out;
}

std::vector<gpu::VertexAttribute> surface_attributes(gpu::Variants variants) {
    std::vector<gpu::VertexAttribute> out = position_attributes(variants);
    out.push_back({VERTEX_COLOUR, attributes, VK_FORMAT_R16G16B16A16_UNORM, offsetof(VertexAttributes, colour)});
    if (!variants.has(gpu::Variant::no_normal)) {
        if (!variants.has(gpu::Variant::facing))
            out.push_back({VERTEX_NORMAL, attributes, VK_FORMAT_R32G32B32_SFLOAT, offsetof(VertexAttributes, normal)});
        add_rows(out, VERTEX_NORMAL_ROW, offsetof(shared::ObjectData, normal_row));
    }
    if (!variants.has(gpu::Variant::no_textures)) {
        out.push_back({VERTEX_TEXCOORD_0, attributes, VK_FORMAT_R32G32_SFLOAT, offsetof(VertexAttributes, texcoord_0)});
        out.push_back({VERTEX_TEXCOORD_1, attributes, VK_FORMAT_R32G32_SFLOAT, offsetof(VertexAttributes, texcoord_1)});
        if (!variants.has(gpu::Variant::no_normal))
            out.push_back(
                {VERTEX_TANGENT, attributes, VK_FORMAT_R32G32B32A32_SFLOAT, offsetof(VertexAttributes, tangent)});
    }
    if (variants.has(gpu::Variant::surface_ids)) {
        out.push_back({VERTEX_SMOOTH_GROUP, groups, VK_FORMAT_R32_UINT, 0});
        if (variants.has(gpu::Variant::no_normal)) // the draw's number is there
            out.push_back({VERTEX_NORMAL_ROW + 1, objects, VK_FORMAT_R32G32B32A32_SFLOAT,
                           static_cast<uint32_t>(offsetof(shared::ObjectData, normal_row) + sizeof(glm::vec4))});
    }
    if (variants.has(gpu::Variant::motion)) {
        out.push_back({VERTEX_PREVIOUS_POSITION, previous_positions, VK_FORMAT_R32G32B32_SFLOAT, 0});
        add_rows(out, VERTEX_PREVIOUS_WORLD_ROW, offsetof(shared::ObjectData, previous_world_row));
    }
    return out;
}

VkCullModeFlags left_out_faces(const resident::Draw& draw, SurfaceDraws::Faces faces) {
    if (!draw.double_sided)
        return VK_CULL_MODE_BACK_BIT;
    return faces == SurfaceDraws::Faces::all    ? VK_CULL_MODE_NONE
           : faces == SurfaceDraws::Faces::back ? VK_CULL_MODE_FRONT_BIT
                                                : VK_CULL_MODE_BACK_BIT;
}

bool has_textures(uint32_t features) {
    return (features & (FEATURE_BASE_COLOUR_TEXTURE | FEATURE_METALLIC_ROUGHNESS_TEXTURE | FEATURE_NORMAL_TEXTURE |
                        FEATURE_OCCLUSION_TEXTURE | FEATURE_EMISSIVE_TEXTURE)) != 0;
}

} // namespace

SurfaceDraws::SurfaceDraws(const resident::View& view, const graph::PassInterface& interface, const Desc& desc)
    : view_(view), features_kept_((desc.depth_only ? FEATURE_ALPHA_MASK | FEATURE_BASE_COLOUR_TEXTURE | FEATURE_FACING
                                   : desc.keeps_alpha_mask ? ~0u
                                                           : ~FEATURE_ALPHA_MASK) &
                                  ~((desc.decals == Decals::none && !desc.layer_decals ? FEATURE_DECALS : 0u) |
                                    (desc.softens ? 0u : FEATURE_SOFT))),
      depth_only_(desc.depth_only), positions_only_(desc.positions_only), only_decals_(desc.decals == Decals::only),
      class_(desc.draws), layer_decals_(desc.layer_decals),
      later_(is_later(desc.depth) && class_ == resident::DrawClass::opaque),
      counts_(view.visible_pixels() && !later_ && class_ == resident::DrawClass::opaque),
      skips_(view.visible_pixels() && later_) {
    gpu::GraphicsPipelineDesc pipeline;
    pipeline.vertex_strides = {sizeof(glm::vec3), sizeof(VertexAttributes), sizeof(glm::vec3),
                               sizeof(shared::ObjectData)};
    if (desc.vertex.has(gpu::Variant::surface_ids))
        pipeline.vertex_strides.push_back(sizeof(uint32_t));
    pipeline.instance_binding = objects;
    pipeline.attachments = interface.attachments;
    pipeline.stencil =
        interface.attachments.stencil == VK_FORMAT_UNDEFINED ? gpu::Stencil::none : gpu::Stencil::exported;
    pipeline.depth = desc.depth;
    pipeline.blend = desc.blend;
    pipeline.sample_mask = desc.sample_mask;
    pipeline.push_bytes = desc.push_bytes;
    for (const resident::Draw& draw : view.scene().geometry().draws) {
        const Key chosen = key(draw);
        if (left_out(draw) || pipelines_.contains(chosen))
            continue;
        pipeline.sets = {view.layout(), interface.inputs, view.scene().materials().layout};
        if (layer_decals_ && (chosen.second & FEATURE_DECALS))
            pipeline.sets.push_back(view.layer_decals()->layout());
        set_shaders(pipeline, desc, chosen);
        pipelines_.emplace(chosen, gpu::GraphicsPipeline(view.context(), pipeline));
    }
}

void SurfaceDraws::set_shaders(gpu::GraphicsPipelineDesc& pipeline, const Desc& desc, Key key) const {
    const auto [shader, features] = key;
    const bool own = shader > 0; // wants to know all of a point
    const bool decals = (features & FEATURE_DECALS) != 0;
    const bool shaded = !desc.depth_only || (features & FEATURE_ALPHA_MASK);
    using gpu::Variant;
    const bool soft = (features & FEATURE_SOFT) != 0;
    const bool by_sample = soft || (decals && !layer_decals_); // reads what lies under each sample
    const gpu::Variants own_variants =                         // of the object, not of the pass
        gpu::when(decals, layer_decals_ ? Variant::layer_decals : Variant::decals) | gpu::when(soft, Variant::soft) |
        gpu::when(by_sample && pipeline.attachments.samples > 1, Variant::samples);
    const gpu::Variants facing = gpu::when((features & FEATURE_FACING) != 0, Variant::facing);
    const bool untextured = desc.vertex.has(Variant::no_textures) && !own && !decals && !has_textures(features);
    gpu::Variants vertex = facing | gpu::when(untextured, Variant::no_textures);
    for (const Variant more : {Variant::motion, Variant::surface_ids, Variant::transmission})
        vertex |= gpu::when(desc.vertex.has(more), more);
    for (const Variant left_out : {Variant::no_world, Variant::no_normal})
        vertex |= gpu::when(!own && !(decals && layer_decals_) && desc.vertex.has(left_out), left_out);
    const bool positions_alone = !shaded || desc.positions_only;
    pipeline.vertex =
        positions_alone ? gpu::ShaderKey("depth_only.vert", facing) : gpu::ShaderKey("surface.vert", vertex);
    pipeline.fragment =
        !shaded ? gpu::ShaderKey() : desc.fragment.with(gpu::when(untextured, Variant::no_textures) | own_variants);
    pipeline.fragment_code.clear();
    pipeline.name = desc.name;
    if (own) {
        const resident::MaterialShaders& shaders = view_.scene().materials().shaders;
        pipeline.name += " " + shaders.name(shader);
        if (shaded) {
            const gpu::ShaderKey stage =
                (desc.own_fragment.empty() ? desc.fragment : desc.own_fragment).with(own_variants);
            pipeline.fragment = {stage.file, stage.variants | Variant::own_material, shaders.name(shader)};
            const auto code = shaders.code(shader, stage);
            pipeline.fragment_code.assign(code.begin(), code.end());
        }
    }
    pipeline.name += " features " + std::to_string(features);
    pipeline.sample_shading =
        by_sample || (features & FEATURE_ALPHA_MASK) ? gpu::SampleShading::sample : desc.sample_shading;
    pipeline.attributes = positions_alone ? position_attributes(facing) : surface_attributes(vertex);
    pipeline.post_depth_coverage = desc.post_depth_coverage && view_.context().features().post_depth_coverage &&
                                   pipeline.sample_shading == gpu::SampleShading::fragment;
    pipeline.constants = desc.constants;
    if (desc.post_depth_coverage)
        pipeline.constants.emplace_back(CONSTANT_POST_DEPTH_COVERAGE, pipeline.post_depth_coverage);
    pipeline.constants.emplace_back(CONSTANT_MATERIAL_FEATURES, features);
}

bool SurfaceDraws::left_out(const resident::Draw& draw) const {
    return draw.draw_class() != class_ || (only_decals_ && !(draw.features & FEATURE_DECALS));
}

SurfaceDraws::Key SurfaceDraws::key(const resident::Draw& draw) const {
    if (positions_only_)
        return {0, draw.features & FEATURE_FACING};
    if (draw.shader == 0)
        return {0, draw.features & features_kept_};
    // Whatever it makes of a surface may decide whether it is there; what has no mask is depth and no more.
    if (depth_only_ && !(draw.features & FEATURE_ALPHA_MASK))
        return {0, draw.features & FEATURE_FACING};
    return {draw.shader, draw.features & (features_kept_ | ~(FEATURE_ALPHA_MASK | FEATURE_DECALS | FEATURE_SOFT))};
}

void SurfaceDraws::bind_geometry(const graph::PassContext& pass) const {
    const resident::Geometry& geometry = view_.scene().geometry();
    const VkBuffer buffers[] = {geometry.positions.handle(), geometry.attributes.handle(), geometry.previous(),
                                view_.objects(), geometry.groups.handle()};
    const VkDeviceSize offsets[std::size(buffers)] = {};
    vkCmdBindVertexBuffers(pass.commands, 0, geometry.groups.handle() ? 5 : 4, buffers, offsets);
}

void SurfaceDraws::bind_state(const graph::PassContext& pass, Bound& bound, const resident::Draw& draw,
                              VkBuffer indices, Faces faces) const {
    const gpu::GraphicsPipeline& pipeline = pipelines_.at(key(draw));
    if (&pipeline != bound.pipeline) {
        pipeline.bind(pass.commands);
        pipeline.bind_set(pass.commands, SET_FRAME, view_.set());
        pipeline.bind_set(pass.commands, SET_INPUTS, pass.inputs);
        bound.pipeline = &pipeline;
        bound.material = no_image;
        bound.faces = {};
    }
    if (draw.material != bound.material) {
        pipeline.bind_set(pass.commands, SET_MATERIAL, view_.scene().materials().sets[draw.material]);
        bound.material = draw.material;
    }
    if (layer_decals_ && (key(draw).second & FEATURE_DECALS))
        pipeline.bind_set(
            pass.commands, SET_LAYER_DECALS,
            view_.layer_decals()->set(static_cast<uint32_t>(&draw - view_.scene().geometry().draws.data())));
    if (indices != bound.indices) {
        vkCmdBindIndexBuffer(pass.commands, indices, 0, VK_INDEX_TYPE_UINT32);
        bound.indices = indices;
    }
    const std::pair wanted(left_out_faces(draw, faces), draw.mirrored);
    if (wanted == bound.faces)
        return;
    vkCmdSetCullMode(pass.commands, wanted.first);
    vkCmdSetFrontFace(pass.commands, draw.mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
    bound.faces = wanted;
}

bool SurfaceDraws::draw(const graph::PassContext& pass, Bound& bound, uint32_t index, std::span<const std::byte> push,
                        Faces faces) const {
    const resident::VisibleDraw* visible = view_.visible().find(index);
    const resident::Draw& draw = view_.scene().geometry().draws[index];
    if (!visible || left_out(draw))
        return false;
    const Source from = source(visible->trimmed, visible->device_trimmed);
    bind_state(pass, bound, draw, from.indices, faces);
    if (!push.empty())
        bound.pipeline->push(pass.commands, push);
    if (skips_)
        view_.visible_pixels()->begin_if_visible(pass.commands, visible->instance);
    if (from.device)
        draw_indirect(pass, from.commands, visible->instance, visible->instance + 1);
    else
        vkCmdDrawIndexed(pass.commands, visible->index_count, 1, visible->first_index, draw.vertex_offset,
                         visible->instance);
    if (skips_)
        view_.visible_pixels()->end_if_visible(pass.commands);
    return true;
}

void SurfaceDraws::record(const graph::PassContext& pass, std::span<const std::byte> push) const {
    const std::vector<resident::DrawBatch>& batches = view_.visible().batches;
    const resident::Geometry& geometry = view_.scene().geometry();
    const bool alone = counts_ || skips_; // each draw has its own query
    bind_geometry(pass);
    Bound bound;
    for (size_t first = 0; first < batches.size();) {
        const resident::DrawBatch& batch = batches[first];
        const resident::Draw& draw = geometry.draws[batch.draw];
        if (left_out(draw)) {
            ++first;
            continue;
        }
        const Source from = source(batch.trimmed, batch.device_trimmed);
        bind_state(pass, bound, draw, from.indices);
        if (!push.empty() && bound.pipeline != bound.pushed)
            (bound.pushed = bound.pipeline)->push(pass.commands, push);
        size_t end = first + 1;
        if (alone || !(from.device || view_.draw_options().indirect)) {
            draw_batch(pass, from, first);
        } else {
            while (end < batches.size() && !left_out(geometry.draws[batches[end].draw]) &&
                   source(batches[end].trimmed, batches[end].device_trimmed) == from &&
                   same_state(geometry.draws[batches[end].draw], draw))
                ++end;
            draw_indirect(pass, from.commands, first, end);
        }
        first = end;
    }
}

void SurfaceDraws::draw_batch(const graph::PassContext& pass, const Source& from, size_t batch) const {
    const resident::VisiblePixels* pixels = view_.visible_pixels();
    const uint32_t query = static_cast<uint32_t>(batch);
    if (counts_)
        pixels->begin(pass.commands, query);
    if (skips_)
        pixels->begin_if_visible(pass.commands, query);
    if (from.device || view_.draw_options().indirect) {
        draw_indirect(pass, from.commands, batch, batch + 1);
    } else {
        const VkDrawIndexedIndirectCommand& c = view_.visible().batches[batch].command;
        vkCmdDrawIndexed(pass.commands, c.indexCount, c.instanceCount, c.firstIndex, c.vertexOffset, c.firstInstance);
    }
    if (skips_)
        pixels->end_if_visible(pass.commands);
    if (counts_)
        pixels->end(pass.commands, query);
}

SurfaceDraws::Source SurfaceDraws::source(bool trimmed, bool device_trimmed) const {
    const resident::DrawOptions& options = view_.draw_options();
    const resident::DeviceTrimming* device = view_.device_trimming();
    if (device_trimmed && later_ && options.trims_by_depth)
        return {device->later().indices.handle(), device->later().commands.handle(), true};
    if (device_trimmed && options.trimming == resident::IndexTrimming::device)
        return {device->first().indices.handle(), device->first().commands.handle(), true};
    return {trimmed ? view_.trimmed_indices() : view_.scene().geometry().indices.handle(), view_.commands(), false};
}

bool SurfaceDraws::same_state(const resident::Draw& a, const resident::Draw& b) const {
    return key(a) == key(b) && a.material == b.material && a.mirrored == b.mirrored;
}

void SurfaceDraws::draw_indirect(const graph::PassContext& pass, VkBuffer commands, size_t first, size_t end) const {
    constexpr uint32_t stride = sizeof(VkDrawIndexedIndirectCommand);
    const gpu::Context& context = view_.context();
    const size_t most = context.features().multi_draw_indirect ? context.limits().maxDrawIndirectCount : 1;
    for (; first < end; first += std::min(most, end - first))
        vkCmdDrawIndexedIndirect(pass.commands, commands, first * stride,
                                 static_cast<uint32_t>(std::min(most, end - first)), stride);
}

void declare_surfaces(graph::FrameGraph& graph, graph::Pass& pass, const resident::View& view, gpu::DepthTest depth) {
    const bool later = SurfaceDraws::is_later(depth);
    const resident::DrawOptions& options = view.draw_options();
    const auto reads = [&](const resident::DeviceTrimming::Output& from) {
        pass.indices(graph.buffer("kept indices", from.indices))
            .indirect(graph.buffer("trimmed draw commands", from.commands));
    };
    if (later && options.trims_by_depth)
        reads(view.device_trimming()->later());
    else if (options.trimming == resident::IndexTrimming::device)
        reads(view.device_trimming()->first());
    if (later && view.visible_pixels())
        pass.condition(graph.buffer("draw conditions", view.visible_pixels()->conditions()));
    if (!later && view.visible_pixels())
        pass.before_rendering(
            [&view](const graph::PassContext& context) { view.visible_pixels()->reset(context.commands); });
}

void draw_surfaces(graph::FrameGraph& graph, graph::Pass& pass, const resident::View& view,
                   const SurfaceDraws::Desc& desc) {
    declare_surfaces(graph, pass, view, desc.depth);
    auto draws = std::make_shared<std::optional<SurfaceDraws>>();
    pass.prepare([=, &view](const graph::PassInterface& interface) { draws->emplace(view, interface, desc); });
    pass.record([draws](const graph::PassContext& context) { (*draws)->record(context); });
}

} // namespace prelight::passes
