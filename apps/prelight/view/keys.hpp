#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace prelight::app::viewer {

/// What a key does by itself: events as panels ask for them. Keys that are held (W A S D Q E, arrows) are the
/// camera's and not here.
struct KeyBinding {
    std::string_view key;
    std::string_view shown;          ///< in the help; empty: as another one
    std::string_view meaning;        ///< in the help
    std::vector<std::string> events; ///< each "VERB ARGUMENTS"; $x and $y: where the mouse is
};
std::span<const KeyBinding> key_bindings();

/// What keys that are held and the mouse do, for the help.
struct Habit {
    std::string_view keys, meaning;
};
std::span<const Habit> habits();

/// One of the names that `key` events have: "A" … "Z", "0" … "9", "Space", "Left", "Shift", …
bool is_key(std::string_view name);

} // namespace prelight::app::viewer
