#include <prelight/scene.hpp>

namespace prelight {
namespace {

/// Whether `wanted` holds for any node of the tree.
template <class Wanted>
bool any_node(const Scene& scene, std::optional<uint32_t> scene_index, Wanted wanted) {
    std::vector<uint32_t> stack = scene.scenes.at(scene_index.value_or(scene.default_scene)).nodes;
    while (!stack.empty()) {
        const Node& node = scene.nodes[stack.back()];
        stack.pop_back();
        if (wanted(node))
            return true;
        stack.insert(stack.end(), node.children.begin(), node.children.end());
    }
    return false;
}

} // namespace

bool is_lit(const Scene& scene, std::optional<uint32_t> scene_index) {
    return scene.environment || scene.ambient != glm::vec3(0) || any_node(scene, scene_index, [&](const Node& node) {
               return node.light ||
                      (node.emitter && *node.emitter < scene.emitters.size() && scene.emitters[*node.emitter].lights);
           });
}

bool has_camera(const Scene& scene, std::optional<uint32_t> scene_index) {
    return any_node(scene, scene_index, [](const Node& node) { return node.camera.has_value(); });
}

} // namespace prelight
