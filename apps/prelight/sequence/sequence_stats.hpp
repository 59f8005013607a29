#pragma once
#include <prelight/renderer.hpp>

namespace prelight::app {

/// Figures of single frames, gathered to those of a run.
class SequenceStats {
public:
    /// `stats`: of a renderer that has drawn one frame since it last told.
    void add(const Stats& stats);
    /// Times as the spread over all frames, a pass's over those that had it; the largest memory; sums of what is
    /// counted a frame (pixels that clipped, pairs, tiles and casters drawn); every note once; the rest as in the last
    /// frame. `frames`: how many there were.
    Stats all() const;

private:
    struct Times {
        std::vector<double> wall, cpu, gpu, lights, culling, objects, record;
    };
    struct Pass {
        std::vector<double> gpu, cpu;
    };
    Times times_;
    std::map<std::string, Pass> passes_; ///< by name
    Stats all_;
};

} // namespace prelight::app
