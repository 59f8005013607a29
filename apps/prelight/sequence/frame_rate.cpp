#include "sequence/frame_rate.hpp"

#include "argument.hpp"

namespace prelight::app {

FrameRate parse_frame_rate(std::string_view option, const std::string& text) {
    FrameRate rate{.text = text};
    const size_t slash = text.find('/');
    if (slash == std::string::npos) {
        rate.numerator = parse_number(option, text, 0.001, 1000);
        return rate;
    }
    rate.numerator = parse_count(option, text.substr(0, slash), 1);
    rate.denominator = parse_count(option, text.substr(slash + 1), 1);
    if (rate.per_second() < 0.001 || rate.per_second() > 1000)
        throw UsageError(fmt::format("{} {}: not from 0.001 to 1000", option, text));
    return rate;
}

} // namespace prelight::app
