#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <scene/finite.hpp>
#include <scene/node_tree.hpp>
#include <utility>

namespace prelight {

NodeTree::NodeTree(const Scene& scene, uint32_t root, Pose pose)
    : scene_(scene), pose_(std::move(pose)), world_(scene.nodes.size() * times(), glm::dmat4(1)),
      joints_(scene.skins.size() * times()) {
    const std::vector<uint32_t>& own = scene.scenes[root].nodes;
    if (!scene.skins.empty()) { // joints may stand in another tree
        std::vector<bool> is_child(scene.nodes.size());
        for (const Node& node : scene.nodes)
            for (const uint32_t child : node.children)
                is_child[child] = true;
        std::vector<uint32_t> roots;
        for (uint32_t i = 0; i < scene.nodes.size(); ++i)
            if (!is_child[i])
                roots.push_back(i);
        place(roots);
        if (std::none_of(own.begin(), own.end(), [&](uint32_t node) { return is_child[node]; }))
            return; // the scene's are among them
    }
    place(own);
}

void NodeTree::place(const std::vector<uint32_t>& roots) {
    // A stack of our own: a chain of a million nodes must not exhaust the program's.
    std::vector<uint32_t> stack;
    const std::array<glm::dmat4, Pose::most_times> origin{glm::dmat4(1), glm::dmat4(1)};
    const auto put = [&](uint32_t node, const glm::dmat4* parent) {
        for (size_t t = 0; t < times(); ++t)
            world_[node * times() + t] = parent[t] * pose_.local(node, t);
        stack.push_back(node);
    };
    for (const uint32_t root : roots)
        put(root, origin.data());
    while (!stack.empty()) {
        const uint32_t node = stack.back();
        stack.pop_back();
        for (const uint32_t child : scene_.nodes[node].children)
            put(child, &world_[node * times()]);
    }
}

const std::vector<glm::dmat4>& NodeTree::joints(uint32_t index, size_t time) {
    const auto fail = [&](std::string_view reason) {
        throw Error(fmt::format("{}: skin {}: {}", scene_.name, index, reason));
    };
    if (index >= scene_.skins.size())
        fail("is not there");
    std::optional<std::vector<glm::dmat4>>& joints = joints_[index * times() + time];
    if (joints)
        return *joints;
    const Skin& skin = scene_.skins[index];
    if (skin.joints.empty())
        fail("has no joints");
    if (!skin.inverse_bind.empty() && skin.inverse_bind.size() < skin.joints.size())
        fail("has fewer inverse bind matrices than joints");
    std::vector<glm::dmat4> matrices;
    matrices.reserve(skin.joints.size());
    for (size_t i = 0; i < skin.joints.size(); ++i) {
        if (skin.joints[i] >= scene_.nodes.size())
            fail(fmt::format("joint {} is not there", i));
        const glm::dmat4& own = world(skin.joints[i], time);
        matrices.push_back(skin.inverse_bind.empty() ? own : own * skin.inverse_bind[i]);
        if (!is_finite(matrices.back()))
            fail(fmt::format("the matrix of joint {} is not finite", i));
    }
    return joints.emplace(std::move(matrices));
}

} // namespace prelight
