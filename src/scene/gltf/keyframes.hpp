#pragma once
#include <prelight/animation.hpp>
#include <scene/gltf/json.hpp>

namespace prelight::gltf {

/// Makes a sampler's times finite and strictly increasing, with a warning for what is not. `values`: how many
/// belong to each keyframe. Keyframes that are not finite are left out; those out of order are sorted; of several
/// at one time the first and the last stay, a jump between them. Nothing may be left.
void repair_keyframes(const Item& item, AnimationSampler& sampler, size_t values);

} // namespace prelight::gltf
