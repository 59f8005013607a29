#include <prelight/scene.hpp>

namespace prelight {

bool is_lit(const Scene& scene, std::optional<uint32_t> scene_index) {
    if (scene.environment || scene.ambient != glm::vec3(0))
        return true;
    std::vector<uint32_t> stack = scene.scenes.at(scene_index.value_or(scene.default_scene)).nodes;
    while (!stack.empty()) {
        const Node& node = scene.nodes[stack.back()];
        stack.pop_back();
        if (node.light || node.emitter)
            return true;
        stack.insert(stack.end(), node.children.begin(), node.children.end());
    }
    return false;
}

} // namespace prelight
