// Which surfaces inferred lighting tells apart, and which layers get which texels.
#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <limits>
#include <reference/inferred_light.hpp>
#include <tuple>

namespace prelight::reference {
namespace {

constexpr uint32_t nobody = 0xffffffffu;

/// Vertices of one place and one normal are one corner; triangles that share a corner are of one group. Flooded from
/// one triangle to the next.
std::vector<uint32_t> groups_of(const Primitive& primitive) {
    std::map<std::tuple<float, float, float, float, float, float>, uint32_t> corners;
    std::vector<uint32_t> corner_of;
    for (size_t v = 0; v < primitive.positions.size(); ++v) {
        const glm::vec3 p = primitive.positions[v], n = primitive.normals[v];
        corner_of.push_back(
            corners.try_emplace({p.x, p.y, p.z, n.x, n.y, n.z}, static_cast<uint32_t>(corners.size())).first->second);
    }
    std::vector<std::vector<size_t>> triangles(corners.size());
    for (size_t i = 0; i < primitive.indices.size(); ++i)
        triangles[corner_of[primitive.indices[i]]].push_back(i / 3);
    std::vector<uint32_t> group(corners.size(), nobody);
    uint32_t next = 0;
    for (uint32_t start = 0; start < corners.size(); ++start) {
        std::vector<uint32_t> open;
        const auto reach = [&](uint32_t corner) {
            if (group[corner] != nobody)
                return;
            group[corner] = next;
            open.push_back(corner);
        };
        reach(start);
        if (open.empty())
            continue;
        while (!open.empty()) {
            const uint32_t corner = open.back();
            open.pop_back();
            for (const size_t triangle : triangles[corner])
                for (size_t i = 3 * triangle; i < 3 * triangle + 3; ++i)
                    reach(corner_of[primitive.indices[i]]);
        }
        ++next;
    }
    std::vector<uint32_t> out;
    for (const uint32_t corner : corner_of)
        out.push_back(group[corner]);
    return out;
}

/// What a box covers of the texels, from the left and upper edge.
struct Covered {
    glm::dvec2 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
};

Covered covered_by(const Draw& draw, const Lens& lens, glm::dvec2 size) {
    glm::dvec3 least(std::numeric_limits<double>::infinity()), most(-least);
    for (const glm::vec3& p : draw.primitive->positions) {
        least = glm::min(least, glm::dvec3(p));
        most = glm::max(most, glm::dvec3(p));
    }
    Covered out;
    for (const double x : {least.x, most.x})
        for (const double y : {least.y, most.y})
            for (const double z : {least.z, most.z}) {
                const glm::dvec3 place(draw.to_world * glm::dvec4(x, y, z, 1));
                if (lens.perspective() && lens.depth(place) <= 0)
                    return {glm::dvec2(0), size};
                const glm::dvec2 at = lens.place_of(place);
                out.low = glm::min(out.low, at - 1.0);
                out.high = glm::max(out.high, at + 1.0);
            }
    out.low = glm::max(out.low, glm::dvec2(0));
    out.high = glm::min(out.high, size);
    return out;
}

} // namespace

void InferredLight::number_groups() {
    for (size_t d = 0; d < world_.rays().draw_count(); ++d) {
        const Primitive* primitive = world_.rays().draw(static_cast<uint32_t>(d)).primitive;
        if (!groups_.contains(primitive))
            groups_[primitive] = groups_of(*primitive);
    }
}

/// In the world's order each blended draw takes the first slot that is free where it is, beginning with its own: 1, 2,
/// 3 and 1 again, one after another. Where none is free it takes its own.
void InferredLight::choose_slots(const World& world) {
    slots_.assign(world_.rays().draw_count(), 0);
    if (form_.transparency != ReferenceForm::Transparency::layers)
        return;
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> seen;
    for (uint32_t d = 0; d < slots_.size(); ++d)
        seen[{world_.rays().draw(d).instance, world_.rays().draw(d).primitive_index}] = d;
    std::vector<std::pair<uint32_t, Covered>> taken;
    uint32_t count = 0;
    for (uint32_t i = 0; i < world.instances.size(); ++i) {
        const std::vector<Primitive>& primitives = world.mesh_of(world.instances[i]).primitives;
        for (uint32_t p = 0; p < primitives.size(); ++p) {
            const bool blended = world.scene->materials[primitives[p].material].alpha_mode == AlphaMode::blend;
            if (!blended || primitives[p].indices.empty())
                continue;
            const uint32_t own = count++ % 3;
            const auto draw = seen.find({i, p});
            if (draw == seen.end())
                continue; // hidden
            const Covered place =
                covered_by(world_.rays().draw(draw->second), world_.lens(), glm::dvec2(width_, height_));
            if (place.low.x >= place.high.x || place.low.y >= place.high.y)
                continue;
            std::array<bool, 3> used{};
            for (const auto& [slot, other] : taken)
                if (other.low.x < place.high.x && place.low.x < other.high.x && other.low.y < place.high.y &&
                    place.low.y < other.high.y)
                    used[slot] = true;
            uint32_t slot = own;
            for (uint32_t further = 0; further < 3 && used[slot]; ++further)
                slot = (own + further) % 3;
            if (used[slot])
                slot = own;
            taken.emplace_back(slot, place);
            slots_[draw->second] = slot + 1;
        }
    }
}

} // namespace prelight::reference
