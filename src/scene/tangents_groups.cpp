#include <algorithm>
#include <scene/tangents_groups.hpp>

namespace prelight::tangents {
namespace {

class Builder {
public:
    explicit Builder(std::vector<Face>& all) : faces(all) { result.of_corner.resize(faces.size(), {none, none, none}); }

    Groups build() {
        for (uint32_t face = 0; face < faces.size(); ++face)
            for (uint32_t corner = 0; corner < 3; ++corner)
                if (!faces[face].with_any && result.of_corner[face][corner] == none)
                    grow(face, faces[face].corners[corner]);
        return std::move(result);
    }

private:
    /// Depth first, the neighbour across the corner's own edge before the other one: the order
    /// matters only to faces without texture area, and there it is part of the definition. A stack
    /// of our own, since a fan can have millions of triangles.
    void grow(uint32_t first, uint32_t vertex) {
        const auto id = static_cast<uint32_t>(result.groups.size());
        Group group{.vertex = vertex, .preserving = faces[first].preserving, .faces = {}};
        stack.assign(1, first);
        while (!stack.empty()) {
            const uint32_t index = stack.back();
            stack.pop_back();
            if (index == none || !join(index, id, group))
                continue;
            const Face& face = faces[index];
            const uint32_t corner = corner_at(face, vertex);
            stack.push_back(face.neighbours[(corner + 2) % 3]);
            stack.push_back(face.neighbours[corner]);
        }
        std::sort(group.faces.begin(), group.faces.end());
        result.groups.push_back(std::move(group));
    }

    bool join(uint32_t index, uint32_t id, Group& group) {
        Face& face = faces[index];
        auto& assigned = result.of_corner[index];
        const uint32_t corner = corner_at(face, group.vertex);
        if (assigned[corner] != none)
            return false;
        const bool untouched = assigned == std::array{none, none, none};
        if (face.with_any && untouched)
            face.preserving = group.preserving;
        if (face.preserving != group.preserving)
            return false;
        assigned[corner] = id;
        group.faces.push_back(index);
        return true;
    }

    std::vector<Face>& faces;
    std::vector<uint32_t> stack;
    Groups result;
};

} // namespace

uint32_t corner_at(const Face& face, uint32_t vertex) {
    return face.corners[0] == vertex ? 0 : face.corners[1] == vertex ? 1 : 2;
}

Groups build_groups(std::vector<Face>& faces) { return Builder(faces).build(); }

} // namespace prelight::tangents
