// What changes of a world that is on the device already.
#include "gpu_scene.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <scene/mesh_facts.hpp>
#include <scene/takes_decals.hpp>
#include <shared/bindings.h>
#include <tuple>

namespace prelight::resident {
namespace {

void check_numbers(std::span<const uint32_t> numbers, size_t count, const char* what, const Scene& scene) {
    for (const uint32_t number : numbers)
        if (number >= count)
            throw Error(fmt::format("{}: changes of {} {}: there are {}", scene.name, what, number, count));
}

/// As decals are drawn: other pipelines, or other materials in a pass that was made for those there were.
bool drawn_alike(const DecalBox& a, const DecalBox& b) {
    return a.decal.material == b.decal.material && a.features == b.features;
}

} // namespace

bool GpuScene::is_turned(const Instance& instance) const {
    return instance.deformed && deforms_on_device(world_, *instance.deformed) &&
           world_.deformations[*instance.deformed].turned;
}

void GpuScene::set_shape(Draw& draw) const {
    const Instance& instance = world_.instances[draw.object];
    if (deforms_on_device(world_, *instance.deformed)) {
        const Deformation& shape = world_.deformations[*instance.deformed];
        draw.own_low = shape.low;
        draw.own_high = shape.high;
        return;
    }
    draw.primitive = &world_.mesh_of(instance).primitives[draw.part];
    std::tie(draw.own_low, draw.own_high) = box_of(draw.primitive->positions);
    draw.facing_reach = facing_reach(*draw.primitive);
}

bool GpuScene::fits(uint32_t i, std::span<const DecalBox> decals) const {
    const Instance& instance = world_.instances[i];
    if (shown_[i] != std::pair(instance.mesh, instance.deformed))
        return false;
    for (const uint32_t d : geometry_.draws_of[i]) {
        Draw moved = geometry_.draws[d];
        const bool receives = instance.receives_decals && takes_decals(world_.scene->materials[moved.material]);
        const bool drawn_with_decals = (moved.features & FEATURE_DECALS) != 0;
        if (drawn_with_decals && !receives)
            return false;
        if (drawn_with_decals || !receives)
            continue; // one that no decal reaches any more stays as it is: nothing lies on it
        if (instance.deformed)
            set_shape(moved);
        moved.bound(instance.transform);
        if (reaches_any(decals, moved.low, moved.high))
            return false;
    }
    return true;
}

bool GpuScene::can_update(const WorldChanges& changes, std::span<const DecalBox> decals) const {
    if (changes.all || world_.instances.size() != shown_.size() || world_.deformed.size() != geometry_.deformed.size())
        return false;
    check_numbers(changes.instances, world_.instances.size(), "instance", *world_.scene);
    check_numbers(changes.deformed, world_.deformed.size(), "deformed mesh", *world_.scene);
    check_numbers(changes.materials, world_.scene->materials.size(), "material", *world_.scene);
    for (const uint32_t d : changes.deformed) {
        if (geometry_.deformed[d].empty())
            continue; // no instance shows it
        if (deformation_ && !deformation_->fits(world_, d))
            return false;
        if (deforms_on_device(world_, d)) {
            if (!deformation_)
                return false;
            continue;
        }
        const std::vector<Primitive>& primitives = world_.deformed[d].primitives;
        const std::vector<VertexRange>& ranges = geometry_.deformed[d];
        if (!std::equal(primitives.begin(), primitives.end(), ranges.begin(), ranges.end(),
                        [](const Primitive& primitive, const VertexRange& range) { return range.fits(primitive); }))
            return false;
        for (const Primitive& primitive : primitives)
            if (settings_.motion && !primitive.previous_positions.empty() && !geometry_.previous_positions.handle())
                return false;
    }
    const auto all_fit = [&](std::span<const uint32_t> instances) {
        return std::all_of(instances.begin(), instances.end(), [&](uint32_t i) { return fits(i, decals); });
    };
    if (!all_fit(changes.instances) || !all_fit(showing(changes.deformed)))
        return false;
    if (!changes.materials.empty() && material_keys(*world_.scene) != materials_.keys)
        return false;
    if (changes.decals) {
        if (!std::equal(decals.begin(), decals.end(), decals_.begin(), decals_.end(), drawn_alike))
            return false;
        for (uint32_t i = 0; i < shown_.size(); ++i)
            if (!fits(i, decals))
                return false;
    }
    return true;
}

std::vector<uint32_t> GpuScene::showing(std::span<const uint32_t> deformed) const {
    std::vector<bool> wanted(geometry_.deformed.size());
    for (const uint32_t d : deformed)
        wanted[d] = true;
    std::vector<uint32_t> instances;
    for (uint32_t i = 0; i < shown_.size() && !deformed.empty(); ++i)
        if (shown_[i].second && wanted[*shown_[i].second])
            instances.push_back(i);
    return instances;
}

bool GpuScene::update(const WorldChanges& changes) {
    std::optional<std::vector<DecalBox>> decals;
    if (changes.decals)
        decals = decal_boxes(world_);
    if (!can_update(changes, decals ? *decals : decals_))
        return false;
    if (decals)
        decals_ = std::move(*decals);
    for (const uint32_t m : changes.materials) {
        update_material(materials_, *world_.scene, m, settings_.exposure, updates_);
        for (Draw& draw : geometry_.draws) // a mask casts another shadow
            draw.version += draw.material == m && (draw.features & FEATURE_ALPHA_MASK);
    }
    for (const uint32_t d : changes.deformed) {
        if (geometry_.deformed[d].empty())
            continue;
        if (deforms_on_device(world_, d))
            deformation_->update(world_, d, updates_);
        else
            update_vertices(d);
    }
    std::vector<uint32_t> moved = changes.instances;
    const std::vector<uint32_t> shaped = showing(changes.deformed);
    moved.insert(moved.end(), shaped.begin(), shaped.end());
    update_boxes(moved);
    return true;
}

void GpuScene::update_vertices(uint32_t deformed) {
    const Mesh& mesh = world_.deformed[deformed];
    for (size_t p = 0; p < mesh.primitives.size(); ++p) {
        const Primitive& primitive = mesh.primitives[p];
        const uint64_t first = geometry_.deformed[deformed][p].first;
        updates_.write(geometry_.positions, first * sizeof(glm::vec3), std::as_bytes(std::span(primitive.positions)));
        const std::vector<VertexAttributes> attributes = attributes_of(primitive);
        updates_.write(geometry_.attributes, first * sizeof(VertexAttributes), std::as_bytes(std::span(attributes)));
        if (geometry_.previous_positions.handle())
            updates_.write(
                geometry_.previous_positions, first * sizeof(glm::vec3),
                std::as_bytes(std::span(primitive.previous_positions.empty() ? primitive.positions
                                                                             : primitive.previous_positions)));
    }
}

void GpuScene::update_boxes(std::span<const uint32_t> instances) {
    const glm::dvec3 centre = box_.centre();
    for (const uint32_t i : instances)
        for (const uint32_t d : geometry_.draws_of[i]) {
            const Instance& instance = world_.instances[i];
            Draw& draw = geometry_.draws[d];
            if (instance.deformed)
                set_shape(draw);
            draw.mirrored = !draw.facing() && instance.mirrored != is_turned(instance);
            draw.place(instance);
            ++draw.version;
        }
    if (instances.empty())
        return;
    box_ = box_around(geometry_.draws);
    if (!settings_.casters)
        return;
    const auto write = [&](uint32_t d) {
        const std::array<glm::vec4, 3> row = caster_row(geometry_.draws[d]);
        updates_.write(caster_rows_, d * sizeof row, std::as_bytes(std::span(row)));
    };
    if (box_.centre() != centre) // what all rows are relative to
        for (uint32_t d = 0; d < geometry_.draws.size(); ++d)
            write(d);
    else
        for (const uint32_t i : instances)
            for (const uint32_t d : geometry_.draws_of[i])
                write(d);
}

} // namespace prelight::resident
