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
    const char* engel = "Engel, ShaderX7 8.5";
    return {
        row("shadowed-directional", "a directional light with shadows, reflections: 0.7 ms, deferred 3.3 ms",
            engel, "ms", "needs shadows"),
        row("more-directionals",
            "by increasing the number of directional lights, the cost per light will go down",
            engel, "ms", "needs shadows"),
    };
}

} // namespace prelight::app
