#include "deformation.hpp"
#include <algorithm>
#include <glm/matrix.hpp>

namespace prelight {
namespace {

/// Around the corners of a box, transformed.
void add_box(Bounds& out, const Bounds& box, const glm::dmat4& transform) {
    if (box.empty())
        return;
    const auto column = [&](int i) { return glm::dvec3(transform[i]); };
    const glm::dvec3 x[] = {column(0) * box.min.x, column(0) * box.max.x},
                     y[] = {column(1) * box.min.y, column(1) * box.max.y},
                     z[] = {column(2) * box.min.z + column(3), column(2) * box.max.z + column(3)};
    for (int i = 0; i < 8; ++i)
        out.add(x[i & 1] + y[i >> 1 & 1] + z[i >> 2]);
}

std::vector<glm::mat4> relative(std::span<const glm::dmat4> joints, const glm::dvec3& origin) {
    std::vector<glm::mat4> out;
    out.reserve(joints.size());
    for (glm::dmat4 joint : joints) {
        joint[3] -= glm::dvec4(origin, 0);
        out.emplace_back(joint);
    }
    return out;
}

/// One for each target: what is missing is 0, what is too much goes.
std::vector<float> weights_of(const Shape& shape, size_t targets) {
    std::vector<float> out(shape.weights.begin(), shape.weights.end());
    out.resize(targets);
    return out;
}

/// Whether more than half of the vertices follow joints that mirror them.
bool is_turned(const Mesh& mesh, std::span<const glm::dmat4> joints) {
    const auto mirrors = [](const glm::dmat4& joint) { return glm::determinant(glm::dmat3(joint)) < 0; };
    const auto count = std::count_if(joints.begin(), joints.end(), mirrors);
    if (count == 0 || count == std::ssize(joints))
        return count > 0;
    size_t mirrored = 0, vertices = 0;
    for (const Primitive& primitive : mesh.primitives) {
        vertices += primitive.positions.size();
        for (uint32_t v = 0; v < primitive.positions.size(); ++v)
            mirrored += mirrors(joint_matrix(primitive, joints, v));
    }
    return 2 * mirrored > vertices;
}

} // namespace

Bounds box_around(const MeshFacts& facts, const Shape& shape) {
    glm::dvec3 less(0), more(0); // by what targets move a vertex
    for (size_t t = 0; t < std::min(facts.targets.size(), shape.weights.size()); ++t) {
        const Bounds& target = facts.targets[t];
        const double weight = shape.weights[t];
        less += weight * (weight > 0 ? target.min : target.max);
        more += weight * (weight > 0 ? target.max : target.min);
    }
    const auto wider = [&](const Bounds& box) { return box.empty() ? box : Bounds{box.min + less, box.max + more}; };
    Bounds out;
    if (shape.joints.empty())
        return wider(facts.box);
    for (const auto& [joint, box] : facts.joint_boxes)
        if (joint < shape.joints.size())
            add_box(out, wider(box), shape.joints[joint]);
    add_box(out, wider(facts.weightless), shape.joints[0]);
    return out;
}

std::pair<Deformation, glm::dvec3> describe(const Mesh& mesh, uint32_t index, const MeshFacts& facts,
                                            const Shape& shape, const Shape& previous) {
    const Bounds box = box_around(facts, shape);
    const glm::dvec3 origin = shape.joints.empty() ? glm::dvec3(0) : 0.5 * box.min + 0.5 * box.max;
    const size_t targets = facts.targets.size();
    Deformation out{.mesh = index,
                    .joints = relative(shape.joints, origin),
                    .weights = weights_of(shape, targets),
                    .previous_joints = relative(previous.joints, origin),
                    .previous_weights = weights_of(previous, targets),
                    .turned = !shape.joints.empty() && is_turned(mesh, shape.joints)};
    const glm::dvec3 room = 1e-5 * (box.max - box.min); // floats are rounded
    out.low = glm::vec3(box.min - origin - room);
    out.high = glm::vec3(box.max - origin + room);
    return {std::move(out), origin};
}

} // namespace prelight
