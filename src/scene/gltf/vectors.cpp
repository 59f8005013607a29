#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <scene/gltf/vectors.hpp>

namespace prelight::gltf {

void drop_triangles_at(Primitive& primitive, const std::vector<uint32_t>& bad_places) {
    std::vector<bool> bad(primitive.positions.size());
    for (const uint32_t place : bad_places)
        bad[place] = true;
    std::vector<uint32_t> kept;
    for (size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        const uint32_t* corner = &primitive.indices[i];
        if (!bad[corner[0]] && !bad[corner[1]] && !bad[corner[2]])
            kept.insert(kept.end(), corner, corner + 3);
    }
    primitive.indices = std::move(kept);
}

void unit_normals(const Item& item, Primitive& primitive) {
    std::vector<glm::vec3>& normals = primitive.normals;
    uint64_t bad_count = 0;
    for (glm::vec3& normal : normals) {
        const glm::dvec3 n(normal);
        const double length = glm::length(n);
        const bool bad = !(length > 1e-20);
        bad_count += bad;
        normal = bad ? glm::vec3(0) : glm::vec3(n / length);
    }
    if (bad_count == 0)
        return;
    std::vector<glm::dvec3> sums(normals.size());
    for (size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        const uint32_t* corner = &primitive.indices[i];
        const glm::dvec3 a(primitive.positions[corner[0]]);
        const glm::dvec3 normal =
            glm::cross(glm::dvec3(primitive.positions[corner[1]]) - a, glm::dvec3(primitive.positions[corner[2]]) - a);
        for (int c = 0; c < 3; ++c)
            sums[corner[c]] += normal;
    }
    for (size_t i = 0; i < normals.size(); ++i)
        if (normals[i] == glm::vec3(0))
            normals[i] = glm::length(sums[i]) > 0 ? glm::vec3(glm::normalize(sums[i])) : glm::vec3(0, 0, 1);
    constexpr const char* reason = "NORMAL: zero normals and those that are not finite are taken from the triangles";
    item.warnings().add(reason, item.label(), reason, bad_count);
}

namespace {

/// Whole numbers of 16 bits; 0, counted as bad, for what is none.
bool to_joints(const glm::vec4& value, glm::vec<4, uint16_t>& out) {
    bool good = true;
    for (int k = 0; k < 4; ++k) {
        const float whole = std::round(value[k]);
        const bool fits = whole >= 0 && whole <= 65535 && std::abs(whole - value[k]) < 1e-2f;
        out[k] = fits ? uint16_t(whole) : uint16_t(0);
        good = good && fits;
    }
    return good;
}

/// False when the file has no further set.
bool read_joint_set(Document& document, const Item& item, Attributes& attributes, uint32_t set, Primitive& primitive) {
    const std::string joints_name = fmt::format("JOINTS_{}", set), weights_name = fmt::format("WEIGHTS_{}", set);
    const bool joints = attributes.has(joints_name), weights = attributes.has(weights_name);
    if (joints != weights)
        item.warn("{} and {} must stand together; what there is of them is left out", joints_name, weights_name);
    if (!joints || !weights)
        return false;
    const auto& used = attributes.used();
    document.charge(item.label(), used.size(), joint_set_bytes);
    JointSet& out = primitive.joint_sets.emplace_back();
    out.joints.resize(used.size());
    out.weights.resize(used.size());
    std::vector<uint32_t> no_joint;
    const Attributes::Values source = attributes.find(joints_name, Semantic::joints);
    const std::string label = source.elements->label; // of Draco data the next attribute takes its place
    attributes.gather(item, joints_name, source, glm::vec4(-1), "", [&](uint32_t i, glm::vec4 v) {
        if (!to_joints(v, out.joints[i]))
            no_joint.push_back(i);
    });
    uint64_t negative = 0;
    uint32_t first = 0;
    attributes.gather(item, weights_name, attributes.find(weights_name, Semantic::weights), glm::vec4(0),
                      "its weights are 0", [&](uint32_t i, glm::vec4 v) {
                          for (int k = 0; k < 4; ++k) {
                              if (v[k] < 0 && negative++ == 0)
                                  first = i;
                              v[k] = std::max(v[k], 0.f);
                              if (v[k] == 0) // where nothing follows it, a joint may have any number
                                  out.joints[i][k] = 0;
                          }
                          out.weights[i] = v;
                      });
    if (negative > 0)
        item.warnings().add("negative weights", item.label(),
                            fmt::format("{}: vertex {} has a negative weight; 0 is used", weights_name, used[first]),
                            negative);
    for (const uint32_t i : no_joint)
        if (out.weights[i] != glm::vec4(0))
            item.fail(fmt::format("{}: {}: vertex {} follows what is no joint's number", joints_name, label, used[i]));
    return true;
}

/// Weights that do not sum up to 1 are scaled where the mesh is deformed; a wrong sum is told here.
void check_sums(const Item& item, const Attributes& attributes, const Primitive& primitive) {
    constexpr double rounding = 0.02; // of four bytes, and of exporters that round
    uint64_t wrong = 0, none = 0;
    double first_sum = 0;
    uint32_t first_wrong = 0, first_none = 0;
    for (uint32_t i = 0; i < attributes.used().size(); ++i) {
        double sum = 0;
        for (const JointSet& set : primitive.joint_sets)
            for (int k = 0; k < 4; ++k)
                sum += double(set.weights[i][k]);
        if (sum == 0 && none++ == 0)
            first_none = attributes.used()[i];
        if (sum != 0 && std::abs(sum - 1) > rounding && wrong++ == 0) {
            first_wrong = attributes.used()[i];
            first_sum = sum;
        }
    }
    if (wrong > 0)
        item.warnings().add("weights do not sum up to 1", item.label(),
                            fmt::format("WEIGHTS: those of vertex {} sum up to {:.4g} instead of 1; they are scaled",
                                        first_wrong, first_sum),
                            wrong);
    if (none > 0)
        item.warnings().add("no weights", item.label(),
                            fmt::format("WEIGHTS: vertex {} has none; it follows the skin's first joint", first_none),
                            none);
}

} // namespace

void read_joints(Document& document, const Item& item, Attributes& attributes, Primitive& primitive) {
    uint32_t set = 0;
    while (read_joint_set(document, item, attributes, set, primitive))
        ++set;
    if (set > 0)
        check_sums(item, attributes, primitive);
}

} // namespace prelight::gltf
