#pragma once
#include <array>
#include <prelight/animation.hpp>
#include <prelight/scene.hpp>
#include <unordered_map>

namespace prelight {

/// Values of a sampler at a time (glTF 2.0, appendix C): `width` of them, `rotation` for quaternions,
/// which come out of unit length.
std::vector<double> sample(const AnimationSampler& sampler, double time, size_t width, bool rotation);

/// What animations make of the nodes at one time.
class Pose {
public:
    /// The scene at rest.
    explicit Pose(const Scene& scene) : scene_(scene) {}
    /// `animation`: the only one to take; absent: all, the first that changes a property wins.
    /// Throws Error when a channel does not fit its node or its sampler.
    Pose(const Scene& scene, double time, std::optional<uint32_t> animation);

    /// Node → parent.
    glm::dmat4 local(uint32_t node) const;
    /// One for each morph target of the node's mesh; missing ones are 0.
    std::vector<double> weights(uint32_t node) const;

private:
    void apply(uint32_t animation, double time);
    const Scene& scene_;
    std::unordered_map<uint32_t, Trs> placed_;
    std::unordered_map<uint32_t, std::vector<double>> weights_;
    std::unordered_map<uint32_t, std::array<bool, 4>> taken_; ///< by AnimationPath
};

/// Morph targets of a mesh: those of its first primitive.
inline size_t morph_targets(const Mesh& mesh) {
    return mesh.primitives.empty() ? 0 : mesh.primitives[0].morph_targets.size();
}

} // namespace prelight
