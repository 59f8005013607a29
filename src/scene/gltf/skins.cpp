#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <scene/deform.hpp>
#include <scene/finite.hpp>
#include <scene/gltf/animations.hpp>
#include <scene/gltf/kinds.hpp>

namespace prelight::gltf {
namespace {

std::vector<glm::dmat4> read_inverse_bind(Document& document, Accessors& accessors, const Item& item, size_t joints) {
    const auto accessor = item.index("inverseBindMatrices", document.count(Table::accessors));
    if (!accessor)
        return {};
    const Elements& source = accessors.get_any(*accessor);
    if (source.columns != 4 || source.component != Component::f32)
        item.fail("inverseBindMatrices: " + kind_mismatch(source, "MAT4 of floats"));
    if (source.count < joints)
        item.fail(fmt::format("has {} joints, but {} inverse bind matrices", joints, source.count));
    document.charge(item.label(), joints, sizeof(glm::dmat4));
    std::vector<glm::dmat4> matrices(joints);
    for (uint32_t i = 0; i < joints; ++i) {
        glm::dmat4& m = matrices[i];
        for (uint32_t c = 0; c < 4; ++c)
            m[int(c)] = glm::dvec4(source.column(i, c));
        if (!is_finite(m)) {
            item.warn("inverse bind matrix {} is not finite; it is taken for the identity", i);
            m = glm::dmat4(1);
        }
        // Some files have it rounded.
        const double off = std::max({std::abs(m[0].w), std::abs(m[1].w), std::abs(m[2].w), std::abs(m[3].w - 1)});
        if (off > 1e-3)
            item.warn("inverse bind matrix {}: its last row is not 0 0 0 1; it is taken for that", i);
        m[0].w = m[1].w = m[2].w = 0;
        m[3].w = 1;
    }
    return matrices;
}

/// The largest number of a joint that the mesh's vertices follow.
uint32_t largest_joint(const Mesh& mesh) {
    uint32_t largest = 0;
    for (const Primitive& primitive : mesh.primitives)
        for (const JointSet& set : primitive.joint_sets)
            for (const auto& joints : set.joints)
                for (int i = 0; i < 4; ++i)
                    largest = std::max<uint32_t>(largest, joints[i]);
    return largest;
}

/// A skin that the node cannot follow is taken away with a warning; a joint that is not there is an
/// error.
void check_skins(Document& document, Scene& scene) {
    std::vector<std::optional<uint32_t>> largest(scene.meshes.size()); // by mesh, found once
    for (size_t i = 0; i < scene.nodes.size(); ++i) {
        Node& node = scene.nodes[i];
        const std::string label = document.label(Table::nodes, i);
        if (!node.skin)
            continue;
        if (!node.mesh || !has_joints(scene.meshes[*node.mesh])) {
            document.warn("a skin without a mesh that has joints is not used", label);
            node.skin.reset();
            continue;
        }
        if (!largest[*node.mesh])
            largest[*node.mesh] = largest_joint(scene.meshes[*node.mesh]);
        if (*largest[*node.mesh] >= scene.skins[*node.skin].joints.size())
            document.fail(label, fmt::format("its mesh follows joint {}, but skin {} has {}", *largest[*node.mesh],
                                             *node.skin, scene.skins[*node.skin].joints.size()));
        if (!node.instances.empty()) {
            document.warn("instances of a mesh with a skin are drawn once", label);
            node.instances.clear();
        }
    }
}

} // namespace

void read_skins(Document& document, Accessors& accessors, Scene& scene) {
    const size_t count = document.count(Table::skins);
    document.charge("skins", count, sizeof(Skin));
    for (size_t i = 0; i < count; ++i) {
        const Item item = document.item(Table::skins, i);
        Skin& skin = scene.skins.emplace_back();
        skin.name = item.text("name");
        skin.joints = item.indices("joints", scene.nodes.size());
        // The joint here, and its matrix now and before while it is resolved.
        document.charge(item.label(), skin.joints.size(), sizeof(uint32_t) + 2 * sizeof(glm::dmat4));
        if (skin.joints.empty())
            item.fail("has no joints");
        item.index("skeleton", scene.nodes.size()); // checked, but the joints say all
        skin.inverse_bind = read_inverse_bind(document, accessors, item, skin.joints.size());
    }
    check_skins(document, scene);
}

} // namespace prelight::gltf
