#pragma once
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <prelight/export.hpp>
#include <prelight/glm_defaults.hpp>
#include <string>
#include <vector>

namespace prelight {

/// A node's translation, rotation and scale as glTF gives them; animation changes one of the three.
struct Trs {
    glm::dvec3 translation{0};       ///< metres, in the parent's space
    glm::dquat rotation{1, 0, 0, 0}; ///< need not be of unit length; zero turns nothing
    glm::dvec3 scale{1};             ///< factors along the node's axes

    /// Translation × rotation × scale.
    PRELIGHT_API glm::dmat4 matrix() const;
};

/// What a channel changes of its node.
enum class AnimationPath {
    translation, ///< 3 values a keyframe, metres in the parent's space
    rotation,    ///< 4 values a keyframe: x, y, z, w of a unit quaternion
    scale,       ///< 3 values a keyframe
    weights,     ///< one value for each morph target of the node's mesh
};

/// How values between two keyframes are found (glTF 2.0, appendix C).
enum class Interpolation {
    step,         ///< the earlier keyframe's
    linear,       ///< a straight line; for rotations the shorter great arc (slerp)
    cubic_spline, ///< Hermite, with tangents in the file
};

/// Keyframes. Before the first and after the last their values hold.
struct AnimationSampler {
    std::vector<float> times; ///< seconds, finite, strictly increasing, at least one
    /// Keyframe after keyframe; with cubic_spline each is in-tangent, value, out-tangent.
    std::vector<float> values;
    Interpolation interpolation = Interpolation::linear; ///< between two keyframes
};

/// What a sampler's values change.
struct AnimationChannel {
    uint32_t sampler = 0; ///< index into Animation::samplers
    uint32_t node = 0;    ///< index into Scene::nodes; it has a Node::trs unless `path` is weights
    AnimationPath path = AnimationPath::translation; ///< which of the node's properties
};

/// Movements of a scene's nodes that belong together.
struct Animation {
    std::string name;                         ///< of the file; may be empty
    std::vector<AnimationSampler> samplers{}; ///< the keyframes
    std::vector<AnimationChannel> channels{}; ///< what they move
};

/// Joints that a mesh follows.
struct Skin {
    std::string name;                       ///< of the file; may be empty
    std::vector<uint32_t> joints{};         ///< indices into Scene::nodes
    std::vector<glm::dmat4> inverse_bind{}; ///< mesh → joint space, as many; empty: all identity
};

/// A point in time, and the one before it that motion is measured from.
struct Moment {
    double time = 0;            ///< seconds from the animations' start
    double interval = 1.0 / 60; ///< seconds ≥ 0: the "previous" state is that at time − interval
};

} // namespace prelight
