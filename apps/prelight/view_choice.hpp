#pragma once
#include <optional>
#include <prelight/framing.hpp>
#include <string>

namespace prelight::app {

/// `--view-from` and `--fit`, as text.
struct ViewText {
    std::string from, fit;
};

/// Adds the options, as add_environment_options() does.
template <class Option>
void add_view_options(const Option& option, ViewText& text) {
    option("--view-from", text.from, "AZIMUTH,ELEVATION",
           "Frame the scene from there, in degrees: 0,0 is the front (+Z), 90,0 the right (+X), 0,90 above (default "
           "20,15, where there is no camera)");
    option("--fit", text.fit, "FACTOR", "Share of the picture that it fills in the tighter direction (default 0.8)");
}

/// Absent: the scene's camera, where it has one. Throws UsageError, also when a `camera` was asked for too.
std::optional<Framing> parse_view(const ViewText& text, const std::string& camera);

} // namespace prelight::app
