#include "claims.hpp"

namespace prelight::app {

std::optional<double> Claim::ratio() const {
    if (!a || !b || *a <= 0 || *b <= 0)
        return {};
    return *a / *b;
}

Verdict Claim::verdict() const {
    if (!built)
        return Verdict::not_built;
    const auto measured = ratio();
    if (!measured)
        return Verdict::not_measured;
    if (!apart)
        return Verdict::too_close;
    return *measured >= from && (!to || *measured <= *to) ? Verdict::agrees : Verdict::does_not;
}

const char* verdict_name(Verdict verdict) {
    switch (verdict) {
    case Verdict::agrees: return "agrees";
    case Verdict::does_not: return "does not on this device";
    case Verdict::too_close: return "too close to tell";
    case Verdict::not_measured: return "not measured";
    case Verdict::not_built: return "not built yet";
    }
    return "";
}

std::vector<Claim> unbuilt_claims() {
    const auto row = [](const char* id, const char* claim, const char* source, const char* unit,
                        const char* what) {
        return Claim{.id = id, .claim = claim, .source = source, .how = what, .unit = unit, .built = false};
    };
    const char* lee = "Lee, Prelighting";
    return {
        row("conditional-rendering", "conditional rendering: ~20% speed increase", lee, "ms",
            "needs occlusion queries and conditional rendering"),
        row("index-trimming", "trimmed index buffers: we could potentially save about ~30% on the depth pass",
            lee, "ms", "needs trimmed index buffers"),
        row("vertices-culled", ">50% of vertices get culled after they already been transformed", lee,
            "vertices", "needs trimmed index buffers"),
    };
}

} // namespace prelight::app
