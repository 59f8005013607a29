#pragma once
#include <optional>
#include <prelight/framing.hpp>

namespace prelight::app {

class Given;

/// `--view-from` and `--fit`. Absent: the scene's camera, where it has one. Throws UsageError, also when a --camera was
/// asked for too.
std::optional<Framing> parse_view(const Given& given);

} // namespace prelight::app
