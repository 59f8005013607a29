#include "pass_kind.hpp"

#include <algorithm>
#include <array>

namespace prelight::app {
namespace {

struct Beginning {
    std::string_view text;
    PassKind kind;
};

/// The first that fits decides: what finds lights comes before what evaluates them.
constexpr std::array beginnings{
    Beginning{"depth-range", PassKind::lists},   Beginning{"depth-bounds", PassKind::lists},
    Beginning{"light-list", PassKind::lists},    Beginning{"light-cull", PassKind::lists},
    Beginning{"light-bin", PassKind::lists},     Beginning{"light-cell", PassKind::lists},
    Beginning{"light-cluster", PassKind::lists}, Beginning{"light-tile", PassKind::lists},
    Beginning{"cluster", PassKind::lists},       Beginning{"tile", PassKind::lists},
    Beginning{"blended-lists", PassKind::lists}, Beginning{"blended", PassKind::material},
    Beginning{"light-", PassKind::light},        Beginning{"light ", PassKind::light},
    Beginning{"depth", PassKind::geometry},      Beginning{"normal", PassKind::geometry},
    Beginning{"decal", PassKind::geometry}, // they make the surface what light meets
    Beginning{"geometry", PassKind::geometry},   Beginning{"material", PassKind::material},
    Beginning{"behind", PassKind::material},     Beginning{"transmission", PassKind::material},
    Beginning{"shadow", PassKind::light}, // as much as the light needs it
    Beginning{"sun", PassKind::light},           Beginning{"background", PassKind::display},
    Beginning{"resolve", PassKind::display},     Beginning{"tonemap", PassKind::display},
    Beginning{"edge-blur", PassKind::display},   Beginning{"smaa", PassKind::display},
};

} // namespace

PassKind kind_of(std::string_view pass) {
    if (pass == "light") // "lights" is multi-pass forward's, with materials
        return PassKind::light;
    const auto found =
        std::ranges::find_if(beginnings, [&](const Beginning& beginning) { return pass.starts_with(beginning.text); });
    return found == beginnings.end() ? PassKind::other : found->kind;
}

const char* pass_kind_name(PassKind kind) {
    switch (kind) {
    case PassKind::geometry: return "geometry";
    case PassKind::lists: return "lists";
    case PassKind::light: return "light";
    case PassKind::material: return "material";
    case PassKind::display: return "display";
    default: return "other";
    }
}

bool has_pass_cpu(const Stats& stats) {
    return !stats.passes.empty() &&
           std::ranges::all_of(stats.passes, [](const PassStats& pass) { return pass.cpu_ms.has_value(); });
}

std::optional<double> passes_ms(const Stats& stats, PassKind kind, bool cpu) {
    std::optional<double> sum;
    if (cpu && !has_pass_cpu(stats))
        return sum;
    for (const PassStats& pass : stats.passes)
        if (kind_of(pass.name) == kind)
            sum = sum.value_or(0) + (cpu ? pass.cpu_ms->median : pass.gpu_ms.median);
    return sum;
}

} // namespace prelight::app
