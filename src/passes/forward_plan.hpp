#pragma once
#include <resident/light_reach.hpp>
#include <shared/forward.h>
#include <vector>

namespace prelight::passes {

/// base: ambient and emissive, replacing what is there and writing depth; lights: a batch added;
/// base_and_lights: both at once, replacing, depth test EQUAL.
enum class StepKind { base, lights, base_and_lights };

/// One draw call of a forward pass.
struct ForwardStep {
    uint32_t draw = 0; ///< index into Geometry::draws
    StepKind kind = StepKind::base;
    shared::ForwardBatch batch{};
};
using ForwardPlan = std::vector<ForwardStep>;

/// Where half floats add up: half of the largest one is for an object's base, half for its lights, so that the blended
/// sum of its steps never reaches infinity. `most_adds`: of an object's steps that may add to one pixel.
void limit_steps(ForwardPlan& plan, uint32_t most_adds);

// All plans: no light that reaches nothing costs a step, and none that reaches an object is left out.
// `per_pass` is 1 … FORWARD_MOST_LIGHTS.

/// The draws of one object that is drawn with base and lights at once: the first has the base, and is there without any
/// lights too.
std::vector<shared::ForwardBatch> batches_of(std::span<const uint32_t> lights, uint32_t per_pass);
/// The base of every object.
ForwardPlan plan_base(size_t draws);
/// Outer loop over objects (the XNA sample); each object's lights in batches. `with_base`: each
/// object's base directly before its lights.
ForwardPlan plan_by_objects(const resident::LightReach& reach, uint32_t per_pass, bool with_base);
/// Outer loop over lights, `per_pass` neighbours at a time (Lee); inside, every object that one
/// of them reaches, with those that reach it. `with_base`: an object's base directly before its first
/// light; the bases of objects without light come last. Draws are sorted by pipeline and material;
/// every second round walks them backwards, so that a round begins with the state the last one ended
/// with.
ForwardPlan plan_by_lights(const resident::LightReach& reach, uint32_t per_pass, bool with_base);
/// Each object with the first batch of its list, and once more for each further one.
ForwardPlan plan_shaded_once(const resident::LightReach& reach, uint32_t per_pass);

} // namespace prelight::passes
