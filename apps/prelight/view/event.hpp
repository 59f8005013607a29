#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace prelight::app::viewer {

/// Steps of the session's clock in a second. Whatever moves, moves by steps, however fast pictures are drawn.
inline constexpr uint32_t steps_per_second = 60;

/// One thing that happened: input (`key W down`) or what a panel asks for (`set light-culling tiles`). A line of a
/// recording.
struct Event {
    uint32_t step = 0; ///< of the session's clock: before it is taken
    std::string verb;
    std::vector<std::string> words; ///< as the verb's arguments say

    /// Of an argument that is a number.
    double number(size_t i) const;
    uint32_t count(size_t i) const { return static_cast<uint32_t>(number(i)); }
    /// Of an argument on|off|toggle, where it was `now`.
    bool turned(size_t i, bool now) const;
    bool operator==(const Event&) const = default;
};

/// An event's first word, and what has to follow.
struct Verb {
    std::string_view name;
    /// One argument a letter: t text, n number, c count from 0, s on|off|toggle, k key, d down|up, b left|middle|right,
    /// p device|surface.
    std::string_view arguments;
    std::string_view meaning; ///< for docs
};
std::span<const Verb> verbs();

/// Numbers of an event lie within ±this.
inline constexpr double largest_number = 1e9;
inline constexpr uint32_t largest_side = 16384; ///< pixels, of `resize`

/// Throws Error "REASON": an unknown verb, too few or too many arguments, one that is not what it should be.
void check_event(const Event& event);
/// "12 key W down"; words with spaces or quotes are quoted.
std::string event_line(const Event& event);
/// The event of such a line. Throws Error "REASON".
Event parse_event(std::string_view line);

} // namespace prelight::app::viewer
