#include <algorithm>
#include <scene/gltf/triangles.hpp>

namespace prelight::gltf {

std::vector<uint32_t> triangle_list(std::vector<uint32_t> indices, Mode mode) {
    if (mode == Mode::triangles) {
        indices.resize(indices.size() / 3 * 3);
        return indices;
    }
    std::vector<uint32_t> out;
    const size_t triangles = indices.size() < 3 ? 0 : indices.size() - 2;
    out.reserve(triangles * 3);
    for (size_t i = 0; i < triangles; ++i) {
        if (mode == Mode::strip) // every second triangle turns the other way
            out.insert(out.end(), {indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]});
        else
            out.insert(out.end(), {indices[i + 1], indices[i + 2], indices[0]});
    }
    return out;
}

std::vector<uint32_t> compact(std::vector<uint32_t>& indices) {
    if (indices.empty())
        return {};
    std::vector<uint32_t> used;
    const uint32_t highest = *std::max_element(indices.begin(), indices.end());
    if (highest / 2 <= indices.size()) { // dense: a table from vertex to place
        std::vector<uint32_t> place(size_t(highest) + 1, 0);
        for (const uint32_t index : indices)
            place[index] = 1;
        for (uint32_t vertex = 0; vertex <= highest; ++vertex)
            if (place[vertex] != 0) {
                place[vertex] = uint32_t(used.size());
                used.push_back(vertex);
            }
        for (uint32_t& index : indices)
            index = place[index];
        return used;
    }
    used = indices;
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (uint32_t& index : indices)
        index = uint32_t(std::lower_bound(used.begin(), used.end(), index) - used.begin());
    return used;
}

} // namespace prelight::gltf
