#pragma once
#include <prelight/animation.hpp>
#include <scene/gltf/accessors.hpp>

namespace prelight::gltf {

/// Which kinds of accessor glTF 2.0 and KHR_mesh_quantization allow for which use, and what becomes of others.

enum class Semantic {
    position,
    normal,
    tangent,
    texcoord,
    colour,
    joints,
    weights,
    position_delta,
    normal_delta,
    tangent_delta
};

/// What an accessor is worth for a use.
struct Fit {
    bool usable = true;
    float divisor = 1;   ///< of Elements::vec: of integers that should have been normalized, or should not
    std::string warning; ///< what is wrong with its kind, naming it; empty: nothing
};

/// `quantized`: the file uses KHR_mesh_quantization.
Fit fit_attribute(const Elements& elements, Semantic semantic, bool quantized);
/// The output of an animation's sampler. Not usable where its kind tells nothing of its values.
Fit fit_animation(const Elements& elements, AnimationPath path);

/// "accessor 4 holds VEC3 of unsigned shorts, not WANTED"
std::string kind_mismatch(const Elements& found, std::string_view wanted);

/// What real files round to.
inline bool is_unit(double length) { return length > 0.99 && length < 1.01; }

} // namespace prelight::gltf
