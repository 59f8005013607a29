#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <prelight/error.hpp>
#include <scene/deform.hpp>
#include <scene/tangents.hpp>

namespace prelight {
namespace {

glm::vec3 unit_normal_or(const glm::dvec3& v, const glm::vec3& fallback) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return largest > 0 && std::isfinite(largest) ? glm::vec3(glm::normalize(v / largest)) : fallback;
}

/// The inverse transpose times the determinant's absolute value.
glm::dmat3 normal_matrix(const glm::dmat3& m, bool mirrored) {
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    return mirrored ? -cofactors : cofactors;
}

/// One primitive in one shape.
class Deformer {
public:
    Deformer(const Primitive& primitive, const Shape& shape) : primitive_(primitive), shape_(shape) {
        for (size_t i = 0; i < std::min(primitive.morph_targets.size(), shape.weights.size()); ++i)
            if (shape.weights[i] != 0)
                active_.push_back({&primitive.morph_targets[i], shape.weights[i]});
    }

    /// World space with a skin, else object space.
    std::vector<glm::dvec3> positions() const {
        std::vector<glm::dvec3> out(primitive_.positions.begin(), primitive_.positions.end());
        morph(out, &MorphTarget::positions);
        if (!shape_.joints.empty())
            for (uint32_t v = 0; v < out.size(); ++v)
                out[v] = glm::dvec3(joint_matrix(v) * glm::dvec4(out[v], 1));
        return out;
    }

    /// Normals, tangents and the winding of triangles, into a copy of the primitive.
    void turn(Primitive& out, bool turned) const {
        std::vector<glm::dvec3> normals(primitive_.normals.begin(), primitive_.normals.end());
        morph(normals, &MorphTarget::normals);
        std::vector<glm::dvec3> tangents;
        for (const glm::vec4& tangent : primitive_.tangents)
            tangents.emplace_back(tangent);
        morph(tangents, &MorphTarget::tangents);
        for (uint32_t v = 0; v < primitive_.positions.size(); ++v) {
            const glm::dmat3 linear = shape_.joints.empty() ? glm::dmat3(1) : glm::dmat3(joint_matrix(v));
            const bool mirrored = glm::determinant(linear) < 0;
            if (!normals.empty())
                out.normals[v] = unit_normal_or(normal_matrix(linear, mirrored) * normals[v], primitive_.normals[v]);
            if (!tangents.empty())
                out.tangents[v] = glm::vec4(unit_normal_or(linear * tangents[v], glm::vec3(primitive_.tangents[v])),
                                            primitive_.tangents[v].w * (mirrored ? -1.f : 1.f));
        }
        if (turned)
            for (size_t i = 0; i + 2 < out.indices.size(); i += 3)
                std::swap(out.indices[i + 1], out.indices[i + 2]);
    }

private:
    struct Active {
        const MorphTarget* target;
        double weight;
    };

    void morph(std::vector<glm::dvec3>& values, std::vector<glm::vec3> MorphTarget::*deltas) const {
        for (const Active& active : active_) {
            const std::vector<glm::vec3>& list = active.target->*deltas;
            for (size_t v = 0; v < std::min(values.size(), list.size()); ++v)
                values[v] += active.weight * glm::dvec3(list[v]);
        }
    }

    glm::dmat4 joint_matrix(uint32_t vertex) const { return prelight::joint_matrix(primitive_, shape_.joints, vertex); }

    const Primitive& primitive_;
    const Shape& shape_;
    std::vector<Active> active_;
};

std::vector<glm::vec3> to_float(const std::vector<glm::dvec3>& places, glm::dvec3 origin, const std::string& object) {
    std::vector<glm::vec3> out;
    out.reserve(places.size());
    for (const glm::dvec3& place : places) {
        const glm::vec3& p = out.emplace_back(place - origin);
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
            throw Error(
                fmt::format("{}: its vertex {} is deformed to a place that is not finite", object, out.size() - 1));
    }
    return out;
}

/// What a deformed mesh shares with the stored one; joints and targets have done their work.
Primitive kept(const Primitive& primitive) {
    Primitive out;
    out.normals = primitive.normals;
    out.tangents = primitive.tangents;
    out.texcoords = primitive.texcoords;
    out.colours = primitive.colours;
    out.indices = primitive.indices;
    out.material = primitive.material;
    out.flat_normals = primitive.flat_normals;
    return out;
}

} // namespace

glm::dmat4 joint_matrix(const Primitive& primitive, std::span<const glm::dmat4> joints, uint32_t vertex) {
    glm::dmat4 sum(0);
    double total = 0;
    for (const JointSet& set : primitive.joint_sets)
        for (int i = 0; i < 4; ++i)
            if (const double weight = double(set.weights[vertex][i]); weight != 0) {
                sum += weight * joints[set.joints[vertex][i]];
                total += weight;
            }
    if (!(total > 0)) // glTF does not allow it; the first joint is as good as any
        return joints[0];
    return sum * (1 / total);
}

void check_joints(const Mesh& mesh, size_t joints, const std::string& object) {
    for (const Primitive& primitive : mesh.primitives)
        for (const JointSet& set : primitive.joint_sets)
            for (size_t v = 0; v < set.joints.size(); ++v)
                for (int i = 0; i < 4; ++i)
                    if (set.weights[v][i] != 0 && set.joints[v][i] >= joints)
                        throw Error(fmt::format("{}: vertex {} follows joint {}, but its skin has {}", object, v,
                                                set.joints[v][i], joints));
}

bool has_joints(const Mesh& mesh) {
    return std::all_of(mesh.primitives.begin(), mesh.primitives.end(), [](const Primitive& primitive) {
        return primitive.indices.empty() || !primitive.joint_sets.empty();
    });
}

bool is_plain(const Mesh& mesh, const Shape& shape) {
    const bool targets = std::any_of(mesh.primitives.begin(), mesh.primitives.end(),
                                     [](const Primitive& primitive) { return !primitive.morph_targets.empty(); });
    return shape.joints.empty() &&
           (!targets || std::all_of(shape.weights.begin(), shape.weights.end(), [](double w) { return w == 0; }));
}

uint64_t vertex_count(const Mesh& mesh) {
    uint64_t count = 0;
    for (const Primitive& primitive : mesh.primitives)
        count += primitive.positions.size();
    return count;
}

uint64_t deform_work(const Mesh& mesh) {
    uint64_t work = 0;
    for (const Primitive& primitive : mesh.primitives)
        work += primitive.positions.size() * (1 + primitive.morph_targets.size() + 4 * primitive.joint_sets.size());
    return work;
}

Mesh deform(const Mesh& mesh, const Shape& shape, const Shape* previous, const glm::dvec3& origin, bool turned,
            const std::string& object) {
    Mesh out{.name = mesh.name, .primitives = {}};
    for (const Primitive& primitive : mesh.primitives) {
        Primitive& made = out.primitives.emplace_back(kept(primitive));
        const Deformer deformer(primitive, shape);
        made.positions = to_float(deformer.positions(), origin, object);
        deformer.turn(made, turned);
        if (made.flat_normals)
            turn_flat_normals(made);
        if (!previous)
            continue;
        made.previous_positions = to_float(Deformer(primitive, *previous).positions(), origin, object);
        if (made.previous_positions == made.positions)
            made.previous_positions.clear();
    }
    return out;
}

} // namespace prelight
