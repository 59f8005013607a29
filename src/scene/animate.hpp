#pragma once
#include <array>
#include <prelight/animation.hpp>
#include <prelight/scene.hpp>
#include <span>
#include <vector>

namespace prelight {

/// Values of a sampler at a time (glTF 2.0, appendix C): `width` of them, `rotation` for quaternions,
/// which come out of unit length.
std::vector<double> sample(const AnimationSampler& sampler, double time, size_t width, bool rotation);

/// What animations make of the nodes at one time, or at two: now, and the moment before. Two cost little more than one:
/// most of the time goes into waiting for the memory that holds keyframes.
class Pose {
public:
    static constexpr size_t most_times = 2;
    /// The scene at rest.
    explicit Pose(const Scene& scene) : scene_(scene), times_(1) {}
    /// `times`: one or two. `animation`: the only one to take; absent: all, the first that changes a property wins.
    /// Throws Error when a channel does not fit its node or its sampler.
    Pose(const Scene& scene, std::span<const double> times, std::optional<uint32_t> animation);

    size_t times() const { return times_; }
    /// Node → parent, at one of the times.
    glm::dmat4 local(uint32_t node, size_t time) const;
    /// One for each morph target of the node's mesh; missing ones are 0.
    std::vector<double> weights(uint32_t node, size_t time) const;
    /// What moves them; null: nothing does.
    const AnimationSampler* weights_sampler(uint32_t node) const;

private:
    /// What channels have changed of a node.
    struct Moved {
        std::array<Trs, most_times> trs;
        std::array<std::vector<double>, most_times> weights;
        const AnimationSampler* weights_sampler = nullptr;
        std::array<bool, 4> taken{}; ///< by AnimationPath
        bool is_placed() const {
            return taken[size_t(AnimationPath::translation)] || taken[size_t(AnimationPath::rotation)] ||
                   taken[size_t(AnimationPath::scale)];
        }
    };
    static constexpr uint32_t still = 0xffffffffu;
    void apply(uint32_t animation, std::span<const double> times);
    Moved& moved_at(uint32_t node);
    const Moved* find(uint32_t node) const;
    const Scene& scene_;
    size_t times_;
    std::vector<uint32_t> at_; ///< by node: where in `moved_`, or `still`; empty: nothing moves
    std::vector<Moved> moved_;
};

/// Morph targets of a mesh: those of its first primitive.
inline size_t morph_targets(const Mesh& mesh) {
    return mesh.primitives.empty() ? 0 : mesh.primitives[0].morph_targets.size();
}

} // namespace prelight
