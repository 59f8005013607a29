#include "shadow_draws.hpp"
#include <algorithm>
#include <cstddef>
#include <gpu/pipeline.hpp>
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

using resident::Draw;
using resident::ShadowMap;
using resident::ShadowTile;
using resident::VertexAttributes;

// Vertex buffer bindings.
constexpr uint32_t caster_positions = 0, caster_attributes = 1, caster_rows = 2;
/// Beside the offset along the normal that lighting adds: for normals that are not the triangle's.
constexpr float slope_bias = 1;

/// Tiles are runs along the atlas' curve: those that overlap this one follow one another.
void forget_overlapped(std::map<uint64_t, HeldMaps::Map>& maps, const resident::ShadowTilePlace& place) {
    auto first = maps.lower_bound(place.first);
    if (first != maps.begin() && std::prev(first)->second.map.place.end() > place.first)
        --first;
    maps.erase(first, maps.lower_bound(place.end()));
}

} // namespace

/// The pipelines of casters: of those without alpha, and of each set of features that alpha has.
class ShadowDraws::Casters {
public:
    Casters(const resident::View& view, VkDescriptorSetLayout inputs, ShadowTarget target)
        : view_(view), blended_(view.shadows()->options().blended), target_(target) {
        gpu::GraphicsPipelineDesc desc;
        desc.vertex_strides = {sizeof(glm::vec3), sizeof(VertexAttributes), 3 * sizeof(glm::vec4)};
        desc.instance_binding = caster_rows;
        gpu::GraphicsPipelineDesc clear{.name = "shadow tile clear", .vertex = "fullscreen.vert"};
        if (target == ShadowTarget::depth) {
            desc.attachments.depth = shadow_format;
            desc.depth = gpu::DepthTest::write_nearer;
            desc.slope_bias = slope_bias;
            clear.depth = gpu::DepthTest::overwrite;
        } else {
            // What lies behind an opaque caster is not drawn: for what is in front of it, it leaves all light.
            desc.attachments = {.colours = {transmittance_format}, .depth = shadow_format};
            desc.depth = gpu::DepthTest::behind_or_at;
            desc.blend = gpu::Blend::transmit;
            clear.fragment = "shadow_transmittance_clear.frag";
        }
        clear.attachments = desc.attachments;
        clear_ = gpu::GraphicsPipeline(view.context(), clear);
        desc.push_bytes = sizeof(shared::ShadowTileConstants);
        desc.push_stage = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
        desc.sets = {view.layout(), inputs, view.scene().materials().layout};
        const std::string kind = target == ShadowTarget::depth ? "shadow casters" : "transparent shadow casters";
        for (const Draw& draw : view.scene().geometry().draws) {
            const uint32_t features = key(draw);
            if (!casts(draw) || pipelines_.contains(features))
                continue;
            desc.name = kind + ", features " + std::to_string(features);
            const bool facing = (features & FEATURE_FACING) != 0, alpha = (features & ~FEATURE_FACING) != 0;
            desc.vertex = {alpha ? "surface.vert" : "depth_only.vert",
                           gpu::Variant::shadow_tile | gpu::when(facing, gpu::Variant::facing)};
            desc.fragment = target == ShadowTarget::transmittance ? "shadow_transmittance.frag"
                            : alpha                               ? "shadow_mask.frag"
                                                                  : "";
            desc.constants = {{CONSTANT_MATERIAL_FEATURES, features}};
            desc.attributes = attributes_of(alpha, facing);
            pipelines_.emplace(features, gpu::GraphicsPipeline(view.context(), desc));
        }
    }

    void bind_geometry(const graph::PassContext& pass) {
        const resident::Geometry& geometry = view_.scene().geometry();
        const VkBuffer buffers[] = {geometry.positions.handle(), geometry.attributes.handle(),
                                    view_.scene().caster_rows()};
        const VkDeviceSize offsets[] = {0, 0, 0};
        vkCmdBindVertexBuffers(pass.commands, 0, 3, buffers, offsets);
        bind_indices(pass, false);
    }

    /// As without casters, all over the viewport: depth 0 is the far end. vkCmdClearAttachments makes a software device
    /// finish all that was drawn into the atlas before.
    void clear(const graph::PassContext& pass) const {
        clear_.bind(pass.commands);
        vkCmdDraw(pass.commands, 3, 1, 0, 0);
    }

    /// Neighbours of the same mesh are one call, where they are drawn whole.
    void draw(const graph::PassContext& pass, const ShadowMap& map,
              std::span<const resident::VisibleDraw> casters = {}) {
        const std::vector<Draw>& all = view_.scene().geometry().draws;
        const std::vector<uint32_t>& draws = map.casters;
        const shared::ShadowTileConstants tile{map.clip_from_centre, glm::uvec4(map.place.corner, 0, 0)};
        const gpu::GraphicsPipeline* bound = nullptr;
        uint32_t material = no_image;
        for (size_t i = 0; i < draws.size();) {
            const Draw& first = all[draws[i]];
            const resident::VisibleDraw part = casters.empty() ? resident::VisibleDraw{.first_index = first.first_index,
                                                                                       .index_count = first.index_count}
                                                               : casters[i];
            if (!casts(first) || part.index_count == 0) {
                ++i;
                continue;
            }
            const gpu::GraphicsPipeline& pipeline = pipelines_.at(key(first));
            if (&pipeline != bound) {
                pipeline.bind(pass.commands);
                pipeline.bind_set(pass.commands, SET_FRAME, view_.set());
                pipeline.bind_set(pass.commands, SET_INPUTS, pass.inputs);
                pipeline.push(pass.commands, std::as_bytes(std::span(&tile, 1)));
                bound = &pipeline;
                material = no_image;
            }
            if (first.material != material && (key(first) || material == no_image)) {
                pipeline.bind_set(pass.commands, SET_MATERIAL,
                                  view_.scene().materials().sets_for_gradients()[first.material]);
                material = first.material;
            }
            uint32_t count = 1;
            while (!part.trimmed && i + count < draws.size() && draws[i + count] == draws[i] + count &&
                   same_triangles(all[draws[i + count]], first) && (casters.empty() || !casters[i + count].trimmed))
                ++count;
            if (part.trimmed != trimmed_bound_)
                bind_indices(pass, part.trimmed);
            vkCmdDrawIndexed(pass.commands, part.index_count, count, part.first_index, first.vertex_offset, draws[i]);
            i += count;
        }
    }

    /// Each pipeline once.
    void warm_up(const graph::PassContext& pass) {
        const std::vector<Draw>& all = view_.scene().geometry().draws;
        clear(pass);
        for (const auto& [features, pipeline] : pipelines_)
            for (uint32_t d = 0; d < all.size(); ++d)
                if (casts(all[d]) && key(all[d]) == features) {
                    draw(pass, {.casters = {d}});
                    break;
                }
    }

private:
    /// Whether the target holds what the draw casts.
    bool casts(const Draw& draw) const {
        const bool transmits = draw.blended() && blended_ == resident::TransparentShadows::filtered;
        return transmits == (target_ == ShadowTarget::transmittance);
    }
    uint32_t key(const Draw& draw) const {
        uint32_t alpha = draw.features & FEATURE_ALPHA_MASK;
        if (draw.blended() && blended_ != resident::TransparentShadows::opaque)
            alpha |= FEATURE_BLENDED;
        return (alpha ? alpha | (draw.features & FEATURE_BASE_COLOUR_TEXTURE) : 0) | (draw.features & FEATURE_FACING);
    }
    void bind_indices(const graph::PassContext& pass, bool trimmed) {
        const VkBuffer buffer = trimmed ? view_.caster_indices().handle() : view_.scene().geometry().indices.handle();
        vkCmdBindIndexBuffer(pass.commands, buffer, 0, VK_INDEX_TYPE_UINT32);
        trimmed_bound_ = trimmed;
    }
    bool same_triangles(const Draw& a, const Draw& b) const {
        return key(a) == key(b) && a.material == b.material && a.first_index == b.first_index &&
               a.index_count == b.index_count && a.vertex_offset == b.vertex_offset;
    }
    static std::vector<gpu::VertexAttribute> attributes_of(bool alpha, bool facing) {
        std::vector<gpu::VertexAttribute> out{{VERTEX_POSITION, caster_positions, VK_FORMAT_R32G32B32_SFLOAT, 0}};
        for (uint32_t row = 0; row < 3; ++row)
            out.push_back({VERTEX_WORLD_ROW + row, caster_rows, VK_FORMAT_R32G32B32A32_SFLOAT,
                           static_cast<uint32_t>(row * sizeof(glm::vec4))});
        if (facing) // how far it stands from there
            out.push_back(
                {VERTEX_NORMAL, caster_attributes, VK_FORMAT_R32G32B32_SFLOAT, offsetof(VertexAttributes, normal)});
        if (alpha) {
            out.push_back(
                {VERTEX_COLOUR, caster_attributes, VK_FORMAT_R16G16B16A16_UNORM, offsetof(VertexAttributes, colour)});
            out.push_back({VERTEX_TEXCOORD_0, caster_attributes, VK_FORMAT_R32G32_SFLOAT,
                           offsetof(VertexAttributes, texcoord_0)});
            out.push_back({VERTEX_TEXCOORD_1, caster_attributes, VK_FORMAT_R32G32_SFLOAT,
                           offsetof(VertexAttributes, texcoord_1)});
        }
        return out;
    }

    const resident::View& view_;
    resident::TransparentShadows blended_;
    ShadowTarget target_;
    gpu::GraphicsPipeline clear_;
    std::map<uint32_t, gpu::GraphicsPipeline> pipelines_; ///< by features; 0: neither alpha nor facing
    bool trimmed_bound_ = false;                          ///< as bind_indices() had it
};

ShadowDraws::ShadowDraws(const resident::View& view, VkDescriptorSetLayout inputs, const Shadows& shadows,
                         ShadowTarget target)
    : view_(view), counts_(*shadows.counts), held_(shadows.held), target_(target),
      casters_(std::make_unique<Casters>(view, inputs, target)) {}
ShadowDraws::~ShadowDraws() = default;

void ShadowDraws::record(const graph::PassContext& pass) {
    casters_->bind_geometry(pass);
    if (pass.one_pixel)
        return casters_->warm_up(pass);
    if (target_ == ShadowTarget::transmittance) {
        for (const ShadowMap& map : held_->drawn)
            draw(pass, map);
        return;
    }
    ++held_->frame;
    std::vector<const ShadowTile*> due;
    for (const ShadowTile& tile : view_.shadows()->tiles())
        if (!reuses(tile))
            due.push_back(&tile);
    const size_t turns = choose(due);
    held_->drawn.clear();
    for (size_t i = 0; i < due.size(); ++i) {
        const ShadowTile& tile = *due[i];
        if (i < turns) {
            held_->drawn.push_back(tile.map);
            hold(tile, tile.map, held_->frame);
            count(tile.map);
        } else if (!earlier(tile)) { // nothing is in shadow until it is its turn
            ShadowMap empty = tile.map;
            empty.casters.clear();
            empty.versions.clear();
            held_->drawn.push_back(empty);
            hold(tile, empty, 0);
        }
    }
    draw_trimmed(pass, held_->drawn);
}

size_t ShadowDraws::choose(std::vector<const ShadowTile*>& due) const {
    const size_t most = view_.shadows()->options().updates;
    const auto others =
        std::stable_partition(due.begin(), due.end(), [](const ShadowTile* tile) { return tile->cascade; });
    const auto cascades = static_cast<size_t>(others - due.begin());
    if (due.size() - cascades <= most)
        return due.size();
    const auto last_drawn = [&](const ShadowTile* tile) {
        const HeldMaps::Map* const before = earlier(*tile);
        return before ? before->frame : 0;
    };
    std::stable_sort(others, due.end(),
                     [&](const ShadowTile* a, const ShadowTile* b) { return last_drawn(a) < last_drawn(b); });
    return cascades + most;
}

void ShadowDraws::draw_trimmed(const graph::PassContext& pass, std::span<const ShadowMap> maps) {
    const gpu::Buffer& indices = view_.caster_indices();
    std::vector<resident::VisibleDraw> casters;
    if (view_.draw_options().trimming == resident::IndexTrimming::host)
        casters = resident::trim_casters(view_.scene(), maps,
                                         {indices.mapped<uint32_t>(), indices.size() / sizeof(uint32_t)});
    size_t first = 0;
    for (const ShadowMap& map : maps) {
        const size_t count = casters.empty() ? 0 : map.casters.size();
        draw(pass, map, std::span(casters).subspan(first, count));
        first += count;
    }
}

void ShadowDraws::begin(const graph::PassContext& pass) {
    if (!pass.one_pixel)
        return;
    pass.between([&] {
        const VkRect2D pixel{{0, 0}, {1, 1}};
        vkCmdSetScissor(pass.commands, 0, 1, &pixel);
        casters_->bind_geometry(pass);
        casters_->warm_up(pass);
    });
}

void ShadowDraws::record_light(const graph::PassContext& pass, uint32_t light) {
    const std::vector<ShadowTile>& tiles = view_.shadows()->tiles();
    const auto first = std::lower_bound(tiles.begin(), tiles.end(), light,
                                        [](const ShadowTile& tile, uint32_t wanted) { return tile.light < wanted; });
    if (pass.one_pixel || first == tiles.end() || first->light != light)
        return;
    pass.between([&] {
        casters_->bind_geometry(pass);
        for (auto tile = first; tile != tiles.end() && tile->light == light; ++tile)
            if (!reuses(*tile)) {
                hold(*tile, tile->map, held_->frame);
                count(tile->map);
                draw(pass, tile->map);
            }
    });
}

bool ShadowDraws::reuses(const ShadowTile& tile) {
    const auto found = held_->maps.find(tile.map.place.first);
    const bool held = view_.shadows()->options().cached && found != held_->maps.end() && found->second.map == tile.map;
    counts_.tiles_reused += held;
    return held;
}

const HeldMaps::Map* ShadowDraws::earlier(const ShadowTile& tile) const {
    const auto found = held_->maps.find(tile.map.place.first);
    const bool own = found != held_->maps.end() && found->second.map.place == tile.map.place &&
                     found->second.light == tile.light && found->second.number == tile.number;
    return own ? &found->second : nullptr;
}

void ShadowDraws::hold(const ShadowTile& tile, const ShadowMap& map, uint64_t frame) {
    forget_overlapped(held_->maps, map.place);
    held_->maps.emplace(map.place.first, HeldMaps::Map{map, tile.light, tile.number, frame});
}

void ShadowDraws::count(const ShadowMap& map) {
    ++counts_.tiles_drawn;
    counts_.casters_drawn += map.casters.size();
}

void ShadowDraws::draw(const graph::PassContext& pass, const ShadowMap& map,
                       std::span<const resident::VisibleDraw> trimmed) {
    const auto x = static_cast<int32_t>(map.place.corner.x), y = static_cast<int32_t>(map.place.corner.y);
    const auto side = static_cast<float>(map.place.side);
    const VkViewport viewport{static_cast<float>(x), static_cast<float>(y), side, side, 0, 1};
    const VkRect2D area{{x, y}, {map.place.side, map.place.side}};
    vkCmdSetViewport(pass.commands, 0, 1, &viewport);
    vkCmdSetScissor(pass.commands, 0, 1, &area);
    casters_->clear(pass);
    casters_->draw(pass, map, trimmed);
}

} // namespace prelight::passes
