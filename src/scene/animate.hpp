#pragma once
#include <array>
#include <prelight/animation.hpp>
#include <prelight/scene.hpp>
#include <vector>

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
    /// What moves them; null: nothing does.
    const AnimationSampler* weights_sampler(uint32_t node) const;

private:
    /// What a channel has changed of a node.
    struct Moved {
        Trs trs;
        std::vector<double> weights;
        const AnimationSampler* weights_sampler = nullptr;
        std::array<bool, 4> taken{}; ///< by AnimationPath
        bool is_placed() const {
            return taken[size_t(AnimationPath::translation)] || taken[size_t(AnimationPath::rotation)] ||
                   taken[size_t(AnimationPath::scale)];
        }
    };
    static constexpr uint32_t still = 0xffffffffu;
    void apply(uint32_t animation, double time);
    Moved& moved_at(uint32_t node);
    const Moved* find(uint32_t node) const;
    const Scene& scene_;
    std::vector<uint32_t> at_; ///< by node: where in `moved_`, or `still`; empty: nothing moves
    std::vector<Moved> moved_;
};

/// Morph targets of a mesh: those of its first primitive.
inline size_t morph_targets(const Mesh& mesh) {
    return mesh.primitives.empty() ? 0 : mesh.primitives[0].morph_targets.size();
}

} // namespace prelight
