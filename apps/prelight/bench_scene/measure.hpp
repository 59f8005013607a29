#pragma once
#include "compare/scene_series.hpp"
#include "job.hpp"

#include <prelight/device.hpp>

namespace prelight::app {

/// One number of lights at which all jobs are timed.
struct Stop {
    std::optional<uint32_t> count; ///< as --light-counts says; nothing: the scene's own
    uint64_t lights = 0;           ///< lights in the world
};

/// A job's figures at one number of lights.
struct Run {
    const Job* job = nullptr;
    Stop stop;
    Stats stats; ///< times of the interleaved frames; pairs and device memory of a frame by itself
};

struct Measured {
    uint64_t triangles = 0;
    std::string camera;
    std::vector<Run> runs; ///< by number of lights, then in the jobs' order
    /// Limit jobs that could not be measured, one line each.
    std::vector<std::string> missing;

    const Run* find(const Job* job, const Stop& stop) const;
};

/// Renders every job at every stop. First each by itself: that counts pairs and device memory, and finds
/// out what cannot be done before anything is timed. Then all of them interleaved. Throws Error naming
/// the contender and the number of lights; a limit job that fails is left out instead. `pass_cpu`: each
/// pass by itself too, for its CPU time. `jobs` must outlive the result.
Measured measure(const std::vector<Job>& jobs, const std::vector<Stop>& stops, const SceneSeries& scenes,
                 const BenchCommand& command, Device& device, bool pass_cpu);

} // namespace prelight::app
