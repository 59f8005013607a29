#pragma once
#include "noise.hpp"
#include "saved_bench.hpp"

namespace prelight::app {

/// Whether two runs are of the same work: scene (a file by its name), size, samples, shading, number of
/// lights, and what was asked for. Where a file does not say that, the settings in force decide, as far as
/// both have them: a version may know more than another.
bool same_work(const SavedRun& a, const SavedRun& b);

/// How a figure of a run has changed.
struct Change {
    std::string figure;
    double before = 0, after = 0;
    bool counted = false; ///< a count, not a time: any difference is one
    Judgement verdict = Judgement::within;
    /// "−12.3 %"; "new" from nothing.
    std::string difference() const;
};

/// All figures that both have; counts alone when they were made on different devices. In units of F where
/// both files have F at that number of lights; where F has changed, milliseconds are not judged.
std::vector<Change> changes_of(const SavedRun& before, const SavedRun* unit_before, const SavedRun& after,
                               const SavedRun* unit_after);

/// Prints what has changed since `before`, and returns it for the file.
nlohmann::ordered_json print_changes(const SavedBench& before, const SavedBench& after, const std::string& file);

} // namespace prelight::app
