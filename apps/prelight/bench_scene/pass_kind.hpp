#pragma once
#include <optional>
#include <prelight/renderer.hpp>
#include <string_view>

namespace prelight::app {

/// What a pass is there for. Passes that do several of these at once (multi-pass forward) are `other`.
enum class PassKind { geometry, lists, light, material, display, other };

/// By the beginning of its name, so that a pass that is split or renamed a little stays where it is.
PassKind kind_of(std::string_view pass);

/// As JSON has it: "geometry", "lists", …
const char* pass_kind_name(PassKind kind);

/// Median time of all passes of that kind together, milliseconds: CPU time alone, or device time. None
/// when there is no such pass, or when the run has no CPU time of each.
std::optional<double> passes_ms(const Stats& stats, PassKind kind, bool cpu);

/// Whether each pass has its CPU time.
bool has_pass_cpu(const Stats& stats);

} // namespace prelight::app
