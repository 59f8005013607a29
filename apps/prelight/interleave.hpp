#pragma once
#include <functional>
#include <prelight/renderer.hpp>
#include <string>
#include <vector>

namespace prelight::app {

/// A renderer that is timed against others; it has its world.
struct Contender {
    Renderer* renderer = nullptr;
    Stats stats;          ///< of the frames that were rendered: their spreads, and the rest of the last one
    std::string error;    ///< why it gave up; empty: it did not
    uint32_t repeats = 1; ///< frames each time that it is its turn: a short one is measured more often
};

struct Rounds {
    uint32_t frames = 5; ///< rounds: frames of each contender, ≥ 1
    /// A contender whose frames have cost this much (milliseconds) gets no further one; everyone gets
    /// one.
    double most_ms = 1e12;
    /// What a frame cost, of its figures; none: wall time.
    std::function<double(const Stats&)> cost_ms = {};
    /// Asked before each round but the first: true ends them. None: all are rendered.
    std::function<bool()> enough = {};
};

/// Renders one frame of each contender in turn, A B C A B C …, so that what else the machine does
/// meets all of them alike; each frame after a warm-up of its own. Fills `stats`, or `error` of one
/// that throws Error. `before` is called before each frame.
void render_interleaved(std::vector<Contender>& contenders, const PlacedCamera& camera, const Rounds& rounds,
                        const std::function<void(const Contender&)>& before = {});

} // namespace prelight::app
