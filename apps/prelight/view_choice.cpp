#include "view_choice.hpp"

#include "argument.hpp"
#include "options/given.hpp"

namespace prelight::app {

std::optional<Framing> parse_view(const Given& given) {
    if (!given.has("--view-from") && !given.has("--fit"))
        return {};
    const char* option = given.has("--view-from") ? "--view-from" : "--fit";
    if (given.has("--camera"))
        throw UsageError(fmt::format("{}: goes without --camera only: it takes its place", option));
    Framing framing;
    if (given.has("--view-from")) {
        const std::string from = given.text("--view-from");
        const size_t comma = from.find(',');
        if (comma == std::string::npos)
            throw UsageError(fmt::format("--view-from {}: not AZIMUTH,ELEVATION in degrees, as in 20,15", from));
        framing.azimuth = parse_number("--view-from", from.substr(0, comma), -36000, 36000);
        framing.elevation = parse_number("--view-from", from.substr(comma + 1), -90, 90);
    }
    if (given.has("--fit"))
        framing.fit = parse_number("--fit", given.text("--fit"), 0.01, 10);
    return framing;
}

} // namespace prelight::app
