#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <scene/animate.hpp>
#include <scene/finite.hpp>
#include <scene/gltf/kinds.hpp>
#include <scene/gltf/node_extras.hpp>
#include <scene/gltf/nodes.hpp>
#include <scene/gltf/primitives.hpp>

namespace prelight::gltf {
namespace {

/// Sets the node's transform, and its parts where the file gives them.
void read_transform(const Item& item, Node& node) {
    if (item.has("matrix")) {
        const auto values = item.numbers<16>("matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
        glm::dmat4& m = node.local;
        for (int i = 0; i < 16; ++i)
            m[i / 4][i % 4] = values[size_t(i)];
        if (m[0].w != 0 || m[1].w != 0 || m[2].w != 0 || m[3].w != 1) {
            item.warn("matrix: its last row is not 0 0 0 1; it is taken for that");
            m[0].w = m[1].w = m[2].w = 0;
            m[3].w = 1;
        }
    } else {
        const auto t = item.numbers<3>("translation", {0, 0, 0});
        const auto r = item.numbers<4>("rotation", {0, 0, 0, 1});
        const auto s = item.numbers<3>("scale", {1, 1, 1});
        if (const double length = glm::length(glm::dvec4(r[0], r[1], r[2], r[3])); !is_unit(length))
            item.warn("rotation is no unit quaternion: its length is {:.4g}; {}", length,
                      length > 0 ? "it is made one" : "it turns nothing");
        node.trs = Trs{{t[0], t[1], t[2]}, {r[3], r[0], r[1], r[2]}, {s[0], s[1], s[2]}};
        node.local = node.trs->matrix();
    }
    if (!is_finite(node.local)) {
        item.warn("its transform is not finite; it is left out");
        node.local = glm::dmat4(1);
        if (node.trs)
            node.trs = Trs{};
    }
}

/// One attribute of instances; nothing, with a warning, for a kind that glTF does not allow.
const Elements* read_instance_attribute(const Document& document, Accessors& accessors, const Item& attributes,
                                        const char* name, uint32_t width) {
    const auto index = attributes.index(name, document.count(Table::accessors));
    if (!index)
        return nullptr;
    const Elements& found = accessors.get(*index);
    const bool quaternion = width == 4, small = found.component == Component::i8 || found.component == Component::i16;
    if (found.width == width && (found.component == Component::f32 || (quaternion && small && found.normalized)))
        return &found;
    const char* wanted = quaternion ? "VEC4 of floats or normalized bytes or shorts" : "VEC3 of floats";
    attributes.warn("{}: {}; it is left out", name, kind_mismatch(found, wanted));
    return nullptr;
}

/// EXT_mesh_gpu_instancing: TRANSLATION, ROTATION, SCALE, each optional, all as long.
std::vector<glm::dmat4> read_instances(Document& document, Accessors& accessors, const Item& extension) {
    const auto attributes = extension.object("attributes");
    const auto find = [&](const char* name, uint32_t width) {
        return attributes ? read_instance_attribute(document, accessors, *attributes, name, width) : nullptr;
    };
    const Elements* translation = find("TRANSLATION", 3);
    const Elements* rotation = find("ROTATION", 4);
    const Elements* scale = find("SCALE", 3);
    uint32_t count = 0;
    for (const Elements* elements : {translation, rotation, scale}) {
        if (elements && count != 0 && elements->count != count)
            extension.fail("its attributes are not equally long");
        if (elements)
            count = elements->count;
    }
    if (count == 0) {
        extension.warn("has no TRANSLATION, ROTATION or SCALE; the mesh is drawn once");
        return {};
    }
    // The instance here, and the one that the world makes of it.
    document.charge(extension.label(), count, sizeof(glm::dmat4) + sizeof(Instance));
    std::vector<glm::dmat4> out;
    out.reserve(count);
    uint32_t bad = 0, first_bad = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const glm::dvec3 t = translation ? glm::dvec3(glm::vec3(translation->vec(i))) : glm::dvec3(0);
        const glm::dvec4 r = rotation ? glm::dvec4(rotation->vec(i)) : glm::dvec4(0, 0, 0, 1);
        const glm::dvec3 s = scale ? glm::dvec3(glm::vec3(scale->vec(i))) : glm::dvec3(1);
        const glm::dmat4 placed = Trs{t, {r.w, r.x, r.y, r.z}, s}.matrix();
        if (std::isfinite(glm::dot(r, glm::dvec4(1))) && is_finite(placed))
            out.push_back(placed);
        else if (bad++ == 0)
            first_bad = i;
    }
    if (bad > 0)
        extension.warnings().add("instance not finite", extension.label(),
                                 fmt::format("instance {} is not finite; it is left out", first_bad), bad);
    if (out.empty())
        out.emplace_back(0); // none is left to see, and none at all would be one at the node
    return out;
}

/// Each node at most once a child, and no cycle. A cycle whose nodes have one parent each has no
/// root, so it is what a walk from the roots never meets.
void check_forest(const Document& document, const std::vector<Node>& nodes) {
    std::vector<uint32_t> parent(nodes.size(), no_image);
    for (uint32_t i = 0; i < nodes.size(); ++i)
        for (const uint32_t child : nodes[i].children) {
            if (parent[child] != no_image)
                document.fail(document.label(Table::nodes, child),
                              fmt::format("is a child of node {} and of node {}", parent[child], i));
            parent[child] = i;
        }
    std::vector<bool> met(nodes.size());
    std::vector<uint32_t> stack;
    for (uint32_t i = 0; i < nodes.size(); ++i)
        if (parent[i] == no_image)
            stack.push_back(i);
    while (!stack.empty()) {
        const uint32_t i = stack.back();
        stack.pop_back();
        met[i] = true;
        stack.insert(stack.end(), nodes[i].children.begin(), nodes[i].children.end());
    }
    for (uint32_t i = 0; i < nodes.size(); ++i)
        if (!met[i])
            document.fail(document.label(Table::nodes, i), "is its own ancestor (cycle)");
}

} // namespace

void read_nodes(Document& document, Accessors& accessors, const Places& cameras, const Places& lights, Scene& scene) {
    const size_t count = document.count(Table::nodes);
    // The node here, and its place now and before while it is resolved.
    document.charge("nodes", count, sizeof(Node) + 2 * sizeof(glm::dmat4) + 16);
    scene.nodes.resize(count);
    for (size_t i = 0; i < count; ++i) {
        const Item item = document.item(Table::nodes, i);
        Node& node = scene.nodes[i];
        node.name = item.text("name");
        read_transform(item, node);
        node.children = item.indices("children", count);
        node.mesh = item.index("mesh", scene.meshes.size());
        if (const auto camera = item.index("camera", cameras.size()))
            node.camera = cameras[*camera];
        if (const auto light = item.extension("KHR_lights_punctual"))
            node.light = lights[light->required_index("light", lights.size())];
        if (const auto visibility = item.extension("KHR_node_visibility"))
            node.visible = visibility->flag("visible", true);
        node.skin = item.index("skin", document.count(Table::skins));
        if (node.mesh) {
            node.weights = read_weights(document, item, scene.meshes[*node.mesh]);
            // The instance that the world makes of it, and weights now and before.
            document.charge(item.label(), 1, sizeof(Instance));
            document.charge(item.label(), morph_targets(scene.meshes[*node.mesh]), 4 * sizeof(double));
        }
        read_node_extras(document, item, node, scene);
        if (const auto instancing = item.extension("EXT_mesh_gpu_instancing"); instancing && node.mesh)
            node.instances = read_instances(document, accessors, *instancing);
    }
    check_forest(document, scene.nodes);
}

void read_scenes(Document& document, Scene& scene) {
    std::vector<bool> is_child(scene.nodes.size());
    for (const Node& node : scene.nodes)
        for (const uint32_t child : node.children)
            is_child[child] = true;
    const size_t count = document.count(Table::scenes);
    document.charge("scenes", count, sizeof(SceneRoot));
    std::vector<size_t> last_scene(scene.nodes.size(), count); // that named the node
    for (size_t i = 0; i < count; ++i) {
        const Item item = document.item(Table::scenes, i);
        SceneRoot root{item.text("name"), item.indices("nodes", scene.nodes.size())};
        std::vector<uint32_t> once;
        for (const uint32_t node : root.nodes) {
            if (is_child[node])
                item.fail(fmt::format("node {} is not a root: it is a child of another", node));
            if (last_scene[node] == i)
                item.warn("node {} stands twice in it; it is shown once", node);
            else
                once.push_back(node);
            last_scene[node] = i;
        }
        root.nodes = std::move(once);
        scene.scenes.push_back(std::move(root));
    }
    if (count == 0) {
        scene.scenes.emplace_back();
        for (uint32_t i = 0; i < scene.nodes.size(); ++i)
            if (!is_child[i])
                scene.scenes[0].nodes.push_back(i);
    }
    scene.default_scene = document.root().index("scene", scene.scenes.size()).value_or(0);
}

} // namespace prelight::gltf
