#pragma once
#include <array>
#include <map>
#include <prelight/animation.hpp>
#include <prelight/scene.hpp>
#include <span>
#include <vector>

namespace prelight {

/// Values of a sampler at a time (glTF 2.0, appendix C): `width` of them, `rotation` for quaternions,
/// which come out of unit length.
std::vector<double> sample(const AnimationSampler& sampler, double time, size_t width, bool rotation);

/// The channels of a scene's animations as poses take them, one moment after another: checked, and each list of
/// keyframes' times once, however many samplers have it. The scene's animations and nodes must stay as they are.
class Channels {
public:
    /// None.
    Channels() = default;
    /// `animation`: the only one to take; absent: all, the first that changes a property wins. Throws Error when a
    /// channel does not fit its node or its sampler.
    Channels(const Scene& scene, std::optional<uint32_t> animation);

private:
    friend class Pose;
    struct Channel {
        const float* values; ///< of its sampler
        uint32_t moved;      ///< index into `nodes_`
        uint32_t times;      ///< index into `times_`
        uint32_t width;      ///< values a keyframe
        AnimationPath path;
        Interpolation interpolation;
    };
    /// A node that channels change.
    struct Moved {
        Trs rest;
        const AnimationSampler* weights_sampler = nullptr;
        std::array<bool, 4> taken{}; ///< by AnimationPath
        bool placed() const {
            return taken[size_t(AnimationPath::translation)] || taken[size_t(AnimationPath::rotation)] ||
                   taken[size_t(AnimationPath::scale)];
        }
    };
    static constexpr uint32_t still = 0xffffffffu;
    struct ByContent {
        bool operator()(const std::vector<float>* a, const std::vector<float>* b) const;
    };
    using KnownTimes = std::map<const std::vector<float>*, uint32_t, ByContent>; ///< index into `times_`
    void add(const Scene& scene, uint32_t animation, KnownTimes& known);
    uint32_t node_at(const Scene& scene, uint32_t node);
    std::vector<Channel> channels_;
    std::vector<Moved> nodes_;
    std::vector<uint32_t> at_; ///< by node of the scene: where in `nodes_`, or `still`; empty: nothing moves
    std::vector<const std::vector<float>*> times_; ///< different ones
};

/// What animations make of the nodes at one time, or at two: now, and the moment before. Two cost little more than one:
/// most of the time goes into waiting for the memory that holds keyframes.
class Pose {
public:
    static constexpr size_t most_times = 2;
    /// The scene at rest.
    explicit Pose(const Scene& scene) : scene_(scene), times_(1) {}
    /// `times`: one or two. `channels`: of the scene; they must outlive the pose. Throws Error for a time that is not
    /// finite.
    Pose(const Scene& scene, const Channels& channels, std::span<const double> times);

    size_t times() const { return times_; }
    /// Node → parent, at one of the times.
    glm::dmat4 local(uint32_t node, size_t time) const;
    /// One for each morph target of the node's mesh; missing ones are 0.
    std::vector<double> weights(uint32_t node, size_t time) const;
    /// What moves them; null: nothing does.
    const AnimationSampler* weights_sampler(uint32_t node) const;

private:
    /// Index into Channels::nodes_, or Channels::still.
    uint32_t find(uint32_t node) const {
        return !channels_ || channels_->at_.empty() ? Channels::still : channels_->at_[node];
    }
    const Scene& scene_;
    const Channels* channels_ = nullptr; ///< null: at rest
    size_t times_;
    std::vector<Trs> trs_;                     ///< by node that moves, then by time
    std::vector<std::vector<double>> weights_; ///< the same; empty: no weights move
};

/// Morph targets of a mesh: those of its first primitive.
inline size_t morph_targets(const Mesh& mesh) {
    return mesh.primitives.empty() ? 0 : mesh.primitives[0].morph_targets.size();
}

} // namespace prelight
