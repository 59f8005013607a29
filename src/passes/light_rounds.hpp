#pragma once
#include <resident/view.hpp>
#include <string>

namespace prelight::passes {

/// Some drivers end an invocation's loops after a number of turns, in silence. So the lights of a frame, in the frame's
/// order, are listed and walked in as many rounds as it takes, each with so few that no loop comes near that number; a
/// round adds to what those before it have left.
struct LightRounds {
    uint32_t lights = ~0u; ///< of a round, at most
    uint32_t count = 1;
    uint32_t turns = ~0u; ///< that loops over one round's lights may take
};

/// Who walks the lights: an invocation a pixel, or light_list.comp's with its many pixels.
enum class LightWalk { fragment, compute };

LightRounds light_rounds(const resident::View& view, LightWalk walk);

/// Where the frame's lights of the round lie in its order.
struct RoundLights {
    uint32_t first = 0;
    uint32_t everywhere = 0; ///< of them, first: those that are in every list
    uint32_t listed = 0;     ///< then those with a volume
};
RoundLights lights_of_round(const resident::View& view, const LightRounds& rounds, uint32_t round);

/// " 2" of the second round: what its passes' names end with.
std::string round_name(uint32_t round);

/// What cannot be added up in rounds: throws Error when it takes more than one.
void expect_one_round(const resident::View& view, const LightRounds& rounds, const std::string& what);

} // namespace prelight::passes
