#include "forward_plan.hpp"
#include <algorithm>

namespace prelight::passes {
namespace {

constexpr float largest_sum = 65504; ///< of a pixel, as a half float holds it

ForwardStep base_of(size_t draw) { return {static_cast<uint32_t>(draw), StepKind::base, {}}; }

shared::ForwardBatch batch_of(std::span<const uint32_t> lights) {
    shared::ForwardBatch batch{.count = static_cast<uint32_t>(lights.size()), .limit = largest_sum, .lights = {}};
    std::copy(lights.begin(), lights.end(), batch.lights);
    return batch;
}

ForwardStep step_of(size_t draw, StepKind kind, std::span<const uint32_t> lights) {
    return {static_cast<uint32_t>(draw), kind, batch_of(lights)};
}

/// The first `per_pass` lights of `rest`, taken off it.
std::span<const uint32_t> take(std::span<const uint32_t>& rest, uint32_t per_pass) {
    const auto batch = rest.first(std::min<size_t>(rest.size(), per_pass));
    rest = rest.subspan(batch.size());
    return batch;
}

} // namespace

void limit_steps(ForwardPlan& plan, uint32_t most_adds) {
    std::vector<uint32_t> batches;
    for (const ForwardStep& step : plan)
        batches.resize(std::max<size_t>(batches.size(), step.draw + 1));
    for (const ForwardStep& step : plan)
        batches[step.draw] += step.kind != StepKind::base;
    for (ForwardStep& step : plan)
        step.batch.limit = 32752.0f / static_cast<float>(std::max(std::min(batches[step.draw], most_adds), 1u));
}

std::vector<shared::ForwardBatch> batches_of(std::span<const uint32_t> lights, uint32_t per_pass) {
    std::vector<shared::ForwardBatch> batches;
    do
        batches.push_back(batch_of(take(lights, per_pass)));
    while (!lights.empty());
    const float share = 32752.0f / static_cast<float>(batches.size()); // as limit_steps() has it
    for (shared::ForwardBatch& batch : batches)
        batch.limit = share;
    return batches;
}

ForwardPlan plan_base(size_t draws) {
    ForwardPlan plan;
    for (size_t d = 0; d < draws; ++d)
        plan.push_back(base_of(d));
    return plan;
}

ForwardPlan plan_by_objects(const resident::LightReach& reach, uint32_t per_pass, bool with_base) {
    ForwardPlan plan;
    for (size_t d = 0; d < reach.draws(); ++d) {
        if (with_base)
            plan.push_back(base_of(d));
        for (auto rest = reach.of(d); !rest.empty();)
            plan.push_back(step_of(d, StepKind::lights, take(rest, per_pass)));
    }
    return plan;
}

ForwardPlan plan_by_lights(const resident::LightReach& reach, uint32_t per_pass, bool with_base) {
    std::vector<uint32_t> lights = reach.lights;
    std::sort(lights.begin(), lights.end());
    lights.erase(std::unique(lights.begin(), lights.end()), lights.end());
    std::vector<std::span<const uint32_t>> rest;
    for (size_t d = 0; d < reach.draws(); ++d)
        rest.push_back(reach.of(d));
    std::vector<bool> waits(reach.draws(), with_base);

    ForwardPlan plan;
    bool backwards = false;
    for (std::span<const uint32_t> left(lights); !left.empty(); backwards = !backwards) {
        const uint32_t last = take(left, per_pass).back();
        for (size_t i = 0; i < reach.draws(); ++i) {
            const size_t d = backwards ? reach.draws() - 1 - i : i;
            // Lists are in the world's order: those up to `last` are this round's.
            const auto end = std::upper_bound(rest[d].begin(), rest[d].end(), last);
            const auto batch = rest[d].first(static_cast<size_t>(end - rest[d].begin()));
            if (batch.empty())
                continue;
            rest[d] = rest[d].subspan(batch.size());
            if (waits[d])
                plan.push_back(base_of(d));
            waits[d] = false;
            plan.push_back(step_of(d, StepKind::lights, batch));
        }
    }
    for (size_t d = 0; d < reach.draws(); ++d)
        if (waits[d])
            plan.push_back(base_of(d));
    return plan;
}

ForwardPlan plan_shaded_once(const resident::LightReach& reach, uint32_t per_pass) {
    ForwardPlan plan;
    for (size_t d = 0; d < reach.draws(); ++d) {
        auto rest = reach.of(d);
        plan.push_back(step_of(d, StepKind::base_and_lights, take(rest, per_pass)));
        while (!rest.empty())
            plan.push_back(step_of(d, StepKind::lights, take(rest, per_pass)));
    }
    return plan;
}

} // namespace prelight::passes
