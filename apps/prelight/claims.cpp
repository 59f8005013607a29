#include "claims.hpp"

namespace prelight::app {

std::optional<double> Claim::ratio() const {
    if (!a || !b || *a <= 0 || *b <= 0)
        return {};
    return *a / *b;
}

Verdict Claim::verdict() const {
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
    }
    return "";
}

} // namespace prelight::app
