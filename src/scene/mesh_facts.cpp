#include "mesh_facts.hpp"
#include <algorithm>

namespace prelight {

namespace {

size_t joints_followed(const Primitive& primitive) {
    size_t joints = 0;
    for (const JointSet& set : primitive.joint_sets)
        for (size_t v = 0; v < set.joints.size(); ++v)
            for (int i = 0; i < 4; ++i)
                if (set.weights[v][i] != 0)
                    joints = std::max<size_t>(joints, set.joints[v][i] + 1);
    return joints;
}

/// Whose vertices a joint or a target moves.
void add_movers(const Primitive& primitive, const std::vector<bool>& seen, MeshFacts& facts) {
    for (uint32_t v = 0; v < seen.size(); ++v) {
        if (!seen[v])
            continue;
        bool moved = false;
        for (const JointSet& set : primitive.joint_sets)
            for (int i = 0; i < 4; ++i)
                if (set.weights[v][i] != 0) {
                    facts.joint_boxes[set.joints[v][i]].add(glm::dvec3(primitive.positions[v]));
                    moved = true;
                }
        if (!moved)
            facts.weightless.add(glm::dvec3(primitive.positions[v]));
        for (size_t t = 0; t < primitive.morph_targets.size(); ++t) {
            if (facts.targets.size() <= t)
                facts.targets.resize(t + 1);
            facts.targets[t].add(glm::dvec3(0));
            if (v < primitive.morph_targets[t].positions.size())
                facts.targets[t].add(glm::dvec3(primitive.morph_targets[t].positions[v]));
        }
    }
}

} // namespace

MeshFacts facts_of(const Mesh& mesh) {
    MeshFacts facts;
    for (const Primitive& primitive : mesh.primitives) {
        facts.triangles += primitive.indices.size() / 3;
        std::vector<bool> seen(primitive.positions.size());
        for (uint32_t index : primitive.indices)
            seen[index] = true;
        const double reach = facing_reach(primitive);
        auto& used = facts.used.emplace_back();
        const auto count = size_t(std::count(seen.begin(), seen.end(), true));
        facts.vertices += count;
        for (uint32_t i = 0; i < seen.size(); ++i) {
            if (!seen[i])
                continue;
            facts.box.add(glm::dvec3(primitive.positions[i]) - reach);
            facts.box.add(glm::dvec3(primitive.positions[i]) + reach);
            if (count != seen.size())
                used.push_back(i);
        }
        add_movers(primitive, seen, facts);
        facts.joints = std::max(facts.joints, joints_followed(primitive));
    }
    return facts;
}

std::vector<MeshFacts> facts_of(const Scene& scene) {
    std::vector<MeshFacts> all;
    for (const Mesh& mesh : scene.meshes)
        all.push_back(facts_of(mesh));
    return all;
}

} // namespace prelight
