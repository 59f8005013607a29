#include "mesh_facts.hpp"
#include <algorithm>

namespace prelight {

MeshFacts facts_of(const Mesh& mesh) {
    MeshFacts facts;
    for (const Primitive& primitive : mesh.primitives) {
        facts.triangles += primitive.indices.size() / 3;
        std::vector<bool> seen(primitive.positions.size());
        for (uint32_t index : primitive.indices)
            seen[index] = true;
        auto& used = facts.used.emplace_back();
        const auto count = size_t(std::count(seen.begin(), seen.end(), true));
        facts.vertices += count;
        for (uint32_t i = 0; i < seen.size(); ++i) {
            if (!seen[i])
                continue;
            facts.box.add(glm::dvec3(primitive.positions[i]));
            if (count != seen.size())
                used.push_back(i);
        }
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
