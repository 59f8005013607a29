#include "light_rounds.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <numeric>
#include <prelight/error.hpp>
#include <shared/bindings.h>
#include <shared/light_lists.h>

namespace prelight::passes {
namespace {

/// Turns of the loops that evaluate one light on one pixel: light_distribution.glsl and shadows.glsl, each entered loop
/// with one turn more for finding its end.
uint32_t turns_on_a_pixel(const resident::View& view) {
    uint32_t turns = view.lights().kinds() & LIGHT_KIND_DISTRIBUTION ? 16 : 0;
    if (view.shadows())
        switch (view.shadows()->options().filter) {
        case resident::ShadowFilter::hard: break;
        case resident::ShadowFilter::pcf: turns += 8 + 2; break;
        case resident::ShadowFilter::contact: turns += 12 + 16 + 4;
        }
    return turns;
}

} // namespace

LightRounds light_rounds(const resident::View& view, LightWalk walk) {
    const uint32_t limit = view.context().features().loop_turns;
    if (limit == 0)
        return {};
    // A turn or two a light to find it and one to add it; in a compute pass then eight pixels, whose loop may be
    // unrolled.
    const uint32_t pixel = turns_on_a_pixel(view);
    const uint32_t find = view.shadows() ? 5 : 3; // light_list.comp finds those with shadows once more
    const uint32_t each = walk == LightWalk::fragment ? 2 + pixel : pixel == 0 ? find : find + LIT_BLOCK * (pixel + 1);
    const uint32_t turns = limit - limit / 12; // the rest is for what does not grow with the lights
    const uint32_t lights = std::max(turns / each, 1u);
    const auto all = static_cast<uint32_t>(std::max<size_t>(view.lights().capacity(), 1));
    return {lights, (all + lights - 1) / lights, turns};
}

RoundLights lights_of_round(const resident::View& view, const LightRounds& rounds, uint32_t round) {
    // Groups lie in the order one after another, those that lists know or those that volumes are drawn for.
    const auto& counts = view.light_groups().count;
    const uint64_t everywhere = counts[static_cast<size_t>(resident::LightGroup::fullscreen)],
                   all = std::accumulate(counts.begin(), counts.end(), uint64_t(0));
    const uint64_t first = std::min(uint64_t(round) * rounds.lights, all), end = std::min(first + rounds.lights, all);
    const uint64_t middle = std::clamp(everywhere, first, end);
    return {static_cast<uint32_t>(first), static_cast<uint32_t>(middle - first), static_cast<uint32_t>(end - middle)};
}

std::string round_name(uint32_t round) { return round == 0 ? "" : fmt::format(" {}", round + 1); }

void expect_one_round(const resident::View& view, const LightRounds& rounds, const std::string& what) {
    if (rounds.count > 1)
        throw Error(
            fmt::format("{}: {} takes at most {} lights, for the driver ends loops after {} turns; {} were asked for",
                        view.context().name(), what, rounds.lights, view.context().features().loop_turns,
                        view.lights().capacity()));
}

} // namespace prelight::passes
