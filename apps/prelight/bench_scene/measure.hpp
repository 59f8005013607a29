#pragma once
#include "compare/scene_series.hpp"
#include "job.hpp"

#include "time_budget.hpp"

#include <functional>
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
    /// Of the stops that were measured, in their order: how many frames of each job. The budget may have had less.
    std::vector<std::pair<Stop, uint32_t>> frames;
    std::vector<Stop> left_out; ///< for want of time

    const Run* find(const Job* job, const Stop& stop) const;
};

/// Renders every job at every stop. First each by itself: that counts pairs and device memory, and finds
/// out what cannot be done before anything is timed. Then all of them interleaved. Throws Error naming
/// the contender and the number of lights; a limit job that fails is left out instead. `pass_cpu`: each
/// pass by itself too, for its CPU time. `jobs` must outlive the result. `done` is called after each stop, with what
/// there is. With a limited `budget` there are as many frames as fit, one of each job at the first stop in any case,
/// and the last stops are left out where not even that fits.
Measured measure(const std::vector<Job>& jobs, const std::vector<Stop>& stops, const SceneSeries& scenes,
                 const BenchCommand& command, Device& device, bool pass_cpu, const TimeBudget& budget,
                 const std::function<void(const Measured&)>& done);

} // namespace prelight::app
