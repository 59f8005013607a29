#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <scene/animate.hpp>
#include <scene/finite.hpp>
#include <scene/gltf/node_extras.hpp>
#include <scene/gltf/nodes.hpp>
#include <scene/gltf/primitives.hpp>

namespace prelight::gltf {
namespace {

/// Sets the node's transform, and its parts where the file gives them.
void read_transform(const Item& item, Node& node) {
    if (item.has("matrix")) {
        const auto values = item.numbers<16>("matrix", {});
        glm::dmat4& m = node.local;
        for (int i = 0; i < 16; ++i)
            m[i / 4][i % 4] = values[size_t(i)];
        if (m[0].w != 0 || m[1].w != 0 || m[2].w != 0 || m[3].w != 1)
            item.fail("matrix: its last row is not 0 0 0 1");
    } else {
        const auto t = item.numbers<3>("translation", {0, 0, 0});
        const auto r = item.numbers<4>("rotation", {0, 0, 0, 1});
        const auto s = item.numbers<3>("scale", {1, 1, 1});
        node.trs = Trs{{t[0], t[1], t[2]}, {r[3], r[0], r[1], r[2]}, {s[0], s[1], s[2]}};
        node.local = node.trs->matrix();
    }
    if (!is_finite(node.local))
        item.fail("its transform is not finite");
}

/// EXT_mesh_gpu_instancing: TRANSLATION, ROTATION, SCALE, each optional, all as long.
std::vector<glm::dmat4> read_instances(Document& document, Accessors& accessors,
                                       const Item& extension) {
    const auto attributes = extension.object("attributes");
    const auto find = [&](const char* name, uint32_t width) -> const Elements* {
        const auto index =
            attributes ? attributes->index(name, document.count(Table::accessors)) : std::nullopt;
        if (!index)
            return nullptr;
        const Elements& found = accessors.get(*index);
        if (found.width != width)
            attributes->fail(fmt::format("{}: its type is not fit for that", name));
        return &found;
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
    if (count == 0)
        extension.fail("has no TRANSLATION, ROTATION or SCALE");
    // The instance here, and the one that the world makes of it.
    document.charge(extension.label(), count, sizeof(glm::dmat4) + sizeof(Instance));
    std::vector<glm::dmat4> out;
    out.reserve(count);
    for (uint32_t i = 0; i < count; ++i) {
        const glm::dvec3 t =
            translation ? glm::dvec3(glm::vec3(translation->vec(i))) : glm::dvec3(0);
        const glm::dvec4 r = rotation ? glm::dvec4(rotation->vec(i)) : glm::dvec4(0, 0, 0, 1);
        const glm::dvec3 s = scale ? glm::dvec3(glm::vec3(scale->vec(i))) : glm::dvec3(1);
        if (!std::isfinite(glm::dot(r, glm::dvec4(1))))
            extension.fail(fmt::format("rotation {} is not finite", i));
        out.push_back(Trs{t, {r.w, r.x, r.y, r.z}, s}.matrix());
        if (!is_finite(out.back()))
            extension.fail(fmt::format("instance {} is not finite", i));
    }
    return out;
}

/// Each node at most once a child, and no cycle. A cycle whose nodes have one parent each has no
/// root, so it is what a walk from the roots never meets.
void check_forest(const Document& document, const std::vector<Node>& nodes) {
    std::vector<uint32_t> parent(nodes.size(), no_image);
    for (uint32_t i = 0; i < nodes.size(); ++i)
        for (const uint32_t child : nodes[i].children) {
            if (parent[child] != no_image)
                document.fail(
                    document.label(Table::nodes, child),
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

void read_nodes(Document& document, Accessors& accessors, Scene& scene) {
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
        node.camera = item.index("camera", scene.cameras.size());
        if (const auto light = item.extension("KHR_lights_punctual"))
            node.light = light->required_index("light", scene.lights.size());
        node.skin = item.index("skin", document.count(Table::skins));
        if (node.mesh) {
            node.weights = read_weights(document, item, scene.meshes[*node.mesh]);
            // The instance that the world makes of it, and weights now and before.
            document.charge(item.label(), 1, sizeof(Instance));
            document.charge(item.label(), morph_targets(scene.meshes[*node.mesh]), 4 * sizeof(double));
        }
        read_node_extras(document, item, node, scene);
        if (const auto instancing = item.extension("EXT_mesh_gpu_instancing");
            instancing && node.mesh)
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
        for (const uint32_t node : root.nodes) {
            if (is_child[node])
                item.fail(fmt::format("node {} is not a root: it is a child of another", node));
            if (last_scene[node] == i)
                item.fail(fmt::format("node {} stands twice in it", node));
            last_scene[node] = i;
        }
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
