#include <cmath>
#include <fmt/format.h>
#include <scene/finite.hpp>
#include <scene/write/node_extras.hpp>
#include <scene/write/transform.hpp>

namespace prelight::write {
namespace {

bool is_diagonal(const glm::dmat4& matrix) {
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            if (row != column && matrix[column][row] != 0)
                return false;
    return true;
}

Json three(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

/// Exact: numbers are written as they are, either as translation and scale or as a whole matrix.
/// Only a turned matrix with a scale of zero, which glTF does not take as a matrix, is decomposed.
void set_transform(Json& entry, const glm::dmat4& local, const Placement& placement) {
    const glm::dvec3 diagonal(local[0][0], local[1][1], local[2][2]);
    const bool flat = placement.scale.x * placement.scale.y * placement.scale.z == 0;
    if (!is_diagonal(local) && !flat) {
        Json& matrix = entry["matrix"];
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                matrix.push_back(local[column][row]);
        return;
    }
    if (placement.translation != glm::dvec3(0))
        entry["translation"] = three(placement.translation);
    const glm::dquat& q = placement.rotation;
    if (!is_diagonal(local))
        entry["rotation"] = {q.x, q.y, q.z, q.w};
    const glm::dvec3 scale = is_diagonal(local) ? diagonal : placement.scale;
    if (scale != glm::dvec3(1))
        entry["scale"] = three(scale);
}

/// Exact as well: what animation changes must stand there in parts.
void set_parts(Json& entry, const Trs& trs) {
    if (trs.translation != glm::dvec3(0))
        entry["translation"] = three(trs.translation);
    glm::dquat q = trs.rotation;
    if (const double length = glm::length(q); !(std::abs(length - 1) < 1e-3)) // glTF wants unit length
        q = length > 1e-12 ? q / length : glm::dquat(1, 0, 0, 0);
    if (q != glm::dquat(1, 0, 0, 0))
        entry["rotation"] = {q.x, q.y, q.z, q.w};
    if (trs.scale != glm::dvec3(1))
        entry["scale"] = three(trs.scale);
}

class NodeWriter {
public:
    NodeWriter(const Scene& scene, const std::vector<std::optional<uint32_t>>& meshes, Document& document)
        : scene_(scene), meshes_(meshes), document_(document) {}

    void write(size_t index) {
        const Node& node = scene_.nodes[index];
        object_ = label("node", index, node.name);
        Json entry = Json::object();
        set_name(entry, node.name);
        if (node.trs) {
            if (!is_finite(node.trs->matrix()))
                document_.fail(object_, "its translation, rotation or scale is not finite");
            set_parts(entry, *node.trs);
        } else {
            set_transform(entry, node.local, placed(node.local, "its transform"));
        }
        if (!node.children.empty())
            entry["children"] = node.children;
        if (node.camera)
            entry["camera"] = *node.camera;
        if (node.light)
            entry["extensions"]["KHR_lights_punctual"] = {{"light", *node.light}};
        if (!node.visible) {
            document_.use("KHR_node_visibility");
            entry["extensions"]["KHR_node_visibility"] = {{"visible", false}};
        }
        set_node_extras(entry, scene_, node, object_, document_);
        if (node.mesh && meshes_.at(*node.mesh)) {
            entry["mesh"] = *meshes_[*node.mesh];
            if (node.skin)
                entry["skin"] = *node.skin;
            if (!node.weights.empty())
                entry["weights"] = reals(node.weights);
            if (!node.instances.empty())
                entry["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = instances(node);
        }
        document_.add("nodes", std::move(entry));
    }

private:
    Placement placed(const glm::dmat4& matrix, std::string_view what) const {
        const auto placement = decompose(matrix);
        if (!placement)
            document_.fail(object_, fmt::format("{} is not finite or has shear", what));
        return *placement;
    }

    /// The extension knows single precision only.
    Json instances(const Node& node) {
        std::vector<glm::vec3> translations, scales;
        std::vector<glm::vec4> rotations;
        for (const glm::dmat4& matrix : node.instances) {
            const Placement placement = placed(matrix, "an instance");
            translations.emplace_back(placement.translation);
            const glm::dquat& q = placement.rotation;
            rotations.emplace_back(q.x, q.y, q.z, q.w);
            scales.emplace_back(placement.scale);
        }
        document_.use("EXT_mesh_gpu_instancing");
        return {{"TRANSLATION", document_.add_vectors(translations, ViewKind::other)},
                {"ROTATION", document_.add_vectors(rotations, ViewKind::other)},
                {"SCALE", document_.add_vectors(scales, ViewKind::other)}};
    }

    const Scene& scene_;
    const std::vector<std::optional<uint32_t>>& meshes_;
    Document& document_;
    std::string object_; ///< for messages
};

} // namespace

void add_nodes(const Scene& scene, const std::vector<std::optional<uint32_t>>& meshes, Document& document) {
    NodeWriter writer(scene, meshes, document);
    for (size_t i = 0; i < scene.nodes.size(); ++i)
        writer.write(i);
    for (const SceneRoot& root : scene.scenes) {
        Json entry = Json::object();
        set_name(entry, root.name);
        if (!root.nodes.empty())
            entry["nodes"] = root.nodes;
        document.add("scenes", std::move(entry));
    }
    if (!scene.scenes.empty())
        document.root["scene"] = scene.default_scene;
}

} // namespace prelight::write
