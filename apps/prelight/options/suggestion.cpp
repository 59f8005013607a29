#include "suggestion.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <numeric>

namespace prelight::app {
namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// A longer word is no misspelt name, and comparing it would take long.
constexpr size_t longest_word = 64;

/// Letters of both, whatever their order: --zise has all of --size.
size_t common_letters(std::string_view a, std::string_view b) {
    std::string x(a), y(b), both;
    for (std::string* word : {&x, &y}) {
        std::ranges::transform(*word, word->begin(), lower);
        std::ranges::sort(*word);
    }
    std::ranges::set_intersection(x, y, std::back_inserter(both));
    return both.size();
}

} // namespace

size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    std::iota(last.begin(), last.end(), size_t(0));
    for (size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (size_t j = 1; j <= b.size(); ++j) {
            const char x = lower(a[i - 1]), y = lower(b[j - 1]);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (x == y ? 0 : 1)});
            if (i > 1 && j > 1 && x == lower(b[j - 2]) && y == lower(a[i - 2]))
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before.swap(last);
        last.swap(row);
    }
    return last[b.size()];
}

std::string closest(std::string_view word, const std::vector<std::string>& candidates) {
    if (word.empty() || word.size() > longest_word)
        return {};
    const size_t letters = word.size() - std::min(word.find_first_not_of('-'), word.size());
    const size_t most = (letters + 2) / 3;
    std::string nearest;
    size_t least = most + 1, shared = 0;
    for (const std::string& candidate : candidates) {
        const size_t distance = edit_distance(word, candidate), common = common_letters(word, candidate);
        if (distance > most || distance >= letters || distance > least || (distance == least && common <= shared))
            continue;
        least = distance;
        shared = common;
        nearest = candidate;
    }
    if (!nearest.empty() || letters < 2)
        return nearest;
    const auto begins = [&](const std::string& candidate) { return candidate.starts_with(word); };
    return std::ranges::count_if(candidates, begins) == 1 ? *std::ranges::find_if(candidates, begins) : std::string();
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
    const std::string nearest = closest(word, candidates);
    return nearest.empty() ? std::string() : "; did you mean " + nearest + "?";
}

} // namespace prelight::app
