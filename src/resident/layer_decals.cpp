#include "layer_decals.hpp"
#include <algorithm>
#include <cstring>

namespace prelight::resident {
namespace {

/// Samplers of one stage beside these: a material's and what a pass reads.
constexpr uint32_t other_samplers = 20;

bool takes_layer_decals(const Draw& draw) { return draw.blended() && (draw.features & FEATURE_DECALS) != 0; }

shared::LayerDecal layer_decal(const DecalBox& box, const Material& material, const glm::dvec3& eye) {
    shared::LayerDecal out{};
    out.box = decal_constants(box, eye, false);
    const shared::MaterialConstants m = material_constants(material, 1); // emissive light is not used
    out.base_colour = m.base_colour;
    out.factors = glm::vec4(m.factors.x, m.factors.y, m.factors.z, material.alpha_cutoff);
    constexpr uint32_t maps[] = {MATERIAL_BASE_COLOUR, MATERIAL_METALLIC_ROUGHNESS, MATERIAL_NORMAL};
    for (int map = 0; map < 3; ++map) {
        out.uv_linear[map] = m.uv_linear[maps[map] - 1];
        out.uv_offset[map] = m.uv_offset[maps[map] - 1];
    }
    out.features.x = box.features;
    return out;
}

} // namespace

bool LayerDecals::wanted(const GpuScene& scene) {
    return fits(scene.context()) && std::ranges::any_of(scene.geometry().draws, takes_layer_decals);
}

bool LayerDecals::fits(const gpu::Context& context) {
    return context.limits().maxPerStageDescriptorSamplers >= other_samplers + 3 * LAYER_DECALS_MOST;
}

LayerDecals::LayerDecals(const GpuScene& scene) {
    const gpu::Context& context = scene.context();
    const std::vector<Draw>& draws = scene.geometry().draws;
    for (uint32_t d = 0; d < draws.size(); ++d)
        if (takes_layer_decals(draws[d]))
            of_draw_.emplace(d, static_cast<uint32_t>(of_draw_.size()));
    const uint64_t alignment = context.limits().minUniformBufferOffsetAlignment;
    stride_ = (sizeof(shared::LayerDecalList) + alignment - 1) / alignment * alignment;
    for (gpu::Buffer& lists : lists_)
        lists = gpu::Buffer(context, "decals of blended objects", stride_ * of_draw_.size(),
                            VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, gpu::BufferPlace::upload);
    bound_.resize(of_draw_.size() * gpu::frames_in_flight);
    std::vector<std::vector<gpu::Binding>> sets;
    for (size_t s = 0; s < bound_.size(); ++s)
        sets.push_back(bindings(scene, s, {}));
    layout_ = gpu::make_set_layout(context, "decals of a blended object", sets.at(0));
    sets_ = gpu::DescriptorSets(context, "decals of a blended object", layout_, sets);
}

/// Textures of what is not there are those of any decal: nobody looks at them.
std::vector<gpu::Binding> LayerDecals::bindings(const GpuScene& scene, size_t set, const Numbers& decals) const {
    const size_t slot = set / of_draw_.size(), number = set % of_draw_.size();
    std::vector<gpu::Binding> out{gpu::Binding::uniform(LAYER_DECAL_LIST, lists_[slot].handle(), number * stride_,
                                                        sizeof(shared::LayerDecalList))};
    for (uint32_t k = 0; k < LAYER_DECALS_MOST; ++k) {
        const uint32_t decal = k < decals.size() ? decals[k] : 0;
        const uint32_t material = scene.decals()[decal].decal.material;
        for (uint32_t map = 0; map < 3; ++map) {
            gpu::Binding& one = out.emplace_back(scene.materials().surface_maps[material][map]);
            one.index = LAYER_DECAL_MAPS + 3 * k + map;
        }
    }
    return out;
}

void LayerDecals::update(const GpuScene& scene, const glm::dvec3& eye, uint32_t slot) {
    slot_ = slot;
    left_out_ = 0;
    const std::span<const DecalBox> decals = scene.decals();
    for (const auto& [d, number] : of_draw_) {
        const Draw& draw = scene.geometry().draws[d];
        Numbers reaching;
        for (uint32_t i = 0; i < decals.size(); ++i)
            if (reaches_any(decals.subspan(i, 1), draw.low, draw.high))
                reaching.push_back(i);
        if (reaching.size() > LAYER_DECALS_MOST) {
            left_out_ += static_cast<uint32_t>(reaching.size()) - LAYER_DECALS_MOST;
            reaching.erase(reaching.begin(), reaching.end() - LAYER_DECALS_MOST);
        }
        shared::LayerDecalList list{};
        list.count.x = static_cast<uint32_t>(reaching.size());
        for (size_t k = 0; k < reaching.size(); ++k) {
            const DecalBox& box = decals[reaching[k]];
            list.decals[k] = layer_decal(box, scene.world().scene->materials[box.decal.material], eye);
        }
        std::memcpy(lists_[slot].mapped<std::byte>() + number * stride_, &list, sizeof list);
        const size_t set = number + slot * of_draw_.size();
        if (bound_[set] == reaching)
            continue;
        sets_.update(scene.context(), set, bindings(scene, set, reaching));
        bound_[set] = std::move(reaching);
    }
}

} // namespace prelight::resident
