#pragma once
#include <optional>
#include <scene/animate.hpp>
#include <vector>

namespace prelight {

/// Every node of a scene in one pose: its place in the world, and what its mesh is shaped by, at each of the pose's
/// times.
class NodeTree {
public:
    /// `root`: the one of Scene::scenes whose roots stand in the world's origin.
    NodeTree(const Scene& scene, uint32_t root, Pose pose);

    size_t times() const { return pose_.times(); }
    const glm::dmat4& world(uint32_t node, size_t time) const {
        return world_[node * times() + time];
    } ///< node → world
    /// Weights of the morph targets of the node's mesh.
    std::vector<double> weights(uint32_t node, size_t time) const { return pose_.weights(node, time); }
    const AnimationSampler* weights_sampler(uint32_t node) const { return pose_.weights_sampler(node); }
    /// Mesh → world for each of the skin's joints. Throws Error when one is not there or not finite.
    const std::vector<glm::dmat4>& joints(uint32_t skin, size_t time);

private:
    void place(const std::vector<uint32_t>& roots);
    const Scene& scene_;
    Pose pose_;
    std::vector<glm::dmat4> world_;                              ///< by node, then by time
    std::vector<std::optional<std::vector<glm::dmat4>>> joints_; ///< by skin, then by time; made when asked for
};

} // namespace prelight
