#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace prelight::app {

/// How many letters have to be put in, left out, changed, or swapped with their neighbour, upper and lower case being
/// the same, to make `b` of `a` (optimal string alignment).
size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate that a misspelt word most likely means: the nearest of those that differ in at most a third of
/// the word's letters, rounded up, or else the only one that begins with it. Empty: none is near.
std::string closest(std::string_view word, const std::vector<std::string>& candidates);

/// "; did you mean CANDIDATE?", for the end of a message; empty where none is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

} // namespace prelight::app
