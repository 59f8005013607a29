#include "view_choice.hpp"

#include "argument.hpp"

namespace prelight::app {

std::optional<Framing> parse_view(const ViewText& text, const std::string& camera) {
    if (text.from.empty() && text.fit.empty())
        return {};
    const char* option = text.from.empty() ? "--fit" : "--view-from";
    if (!camera.empty())
        throw UsageError(fmt::format("{}: goes without --camera only: it takes its place", option));
    Framing framing;
    if (!text.from.empty()) {
        const size_t comma = text.from.find(',');
        if (comma == std::string::npos)
            throw UsageError(fmt::format("--view-from {}: not AZIMUTH,ELEVATION in degrees, as in 20,15", text.from));
        framing.azimuth = parse_number("--view-from", text.from.substr(0, comma), -36000, 36000);
        framing.elevation = parse_number("--view-from", text.from.substr(comma + 1), -90, 90);
    }
    if (!text.fit.empty())
        framing.fit = parse_number("--fit", text.fit, 0.01, 10);
    return framing;
}

} // namespace prelight::app
