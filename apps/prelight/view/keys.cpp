#include "keys.hpp"

#include <algorithm>
#include <array>

namespace prelight::app::viewer {
namespace {

constexpr auto named_keys = std::to_array<std::string_view>(
    {"Space",    "Escape", "Enter", "Tab",    "Backspace", "Left",  "Right", "Up",  "Down", "PageUp",
     "PageDown", "Home",   "End",   "Insert", "Delete",    "Shift", "Ctrl",  "Alt", "F1",   "F12",
     ",",        ".",      "[",     "]",      "-",         "=",     "/",     "?",   "+"});

constexpr auto all_habits = std::to_array<Habit>({
    {"left drag", "orbit"},
    {"Shift+left, middle drag", "pan"},
    {"wheel", "nearer to what is under the cursor, or away"},
    {"right drag", "look around"},
    {"W A S D", "fly; Q E: down, up; Shift: faster"},
    {"arrows", "turn"},
    {"left click", "select the object"},
});

} // namespace

std::span<const KeyBinding> key_bindings() {
    static const std::vector<KeyBinding> all{
        {"F", "F", "frame all", {"frame"}},
        {"Space", "Space", "play, pause", {"play toggle"}},
        {"1", "1", "depth", {"buffer depth"}},
        {"2", "2", "normals", {"buffer normal"}},
        {"3", "3", "light", {"buffer diffuse-light"}},
        {"4", "4", "material: its base colour", {"buffer albedo"}},
        {"0", "0, or the same key", "the picture", {"buffer final"}},
        {"H", "H", "heat map: lights a pixel", {"buffer light-count"}},
        {"L", "L", "select the light at the cursor", {"pick-light $x $y"}},
        {"O", "O", "the selected light shines alone", {"only-selected toggle"}},
        {"Insert", "Insert", "add a light", {"add-light"}},
        {"Delete", "Delete", "remove the selected light", {"remove-selected"}},
        {"N", "N", "random lights", {"random-lights"}},
        {"M", "M", "next material", {"cycle-materials"}},
        {"C", "C", "the camera goes round", {"turn-camera toggle"}},
        {"B", "B", "objects turn", {"turn-objects toggle"}},
        {"V", "V", "lights go round", {"turn-lights toggle"}},
        {"R", "R", "reload", {"reload"}},
        {"P", "P", "screenshot", {"screenshot \"\""}},
        {"G", "G", "panels", {"panels toggle"}},
        {"Tab", "Tab", "to the panels; Escape: back", {}},
        {"?", "?, F1", "this help", {"help toggle"}},
        {"/", "", "", {"help toggle"}},
        {"F1", "", "", {"help toggle"}},
        {"Escape", "Escape", "quit", {"quit"}},
    };
    return all;
}

std::span<const Habit> habits() { return all_habits; }

bool is_key(std::string_view name) {
    const bool single = name.size() == 1 && ((name[0] >= 'A' && name[0] <= 'Z') || (name[0] >= '0' && name[0] <= '9'));
    return single || std::ranges::find(named_keys, name) != named_keys.end();
}

} // namespace prelight::app::viewer
