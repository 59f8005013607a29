#pragma once
#include "scene_source.hpp"

#include <future>
#include <prelight/renderer.hpp>

namespace prelight::app {

/// A scene whose moments are shown one after the other. This is the one place that knows how a renderer gets from one
/// to the next: today by a new World for each. What a moment shows does not depend on those before it.
class SceneAtTime {
public:
    /// `loaded`: the scene at time 0. `time`, `view`, `added`: what it was loaded with; of `time` the moment is not
    /// used.
    SceneAtTime(std::unique_ptr<LoadedScene> loaded, const SceneTime& time, const SceneView& view,
                const std::optional<AddedLights>& added);

    const Scene& scene() const { return loaded_->scene; }
    /// At time 0.
    const World& start() const { return loaded_->world; }
    /// False: every moment is the same.
    bool moves() const;
    /// Seconds from the animations' start to the last keyframe of those that play; absent: none plays.
    std::optional<double> length() const;

    /// Begins what the host has to do for that time, in another thread. `time` ≥ 0, seconds.
    void prepare(double time);
    /// Afterwards the renderer shows the scene at that time; nothing is done when it does already. Gives that world,
    /// which stays as it is until the next call. Throws Error; the renderer has no world then.
    const World& show(double time, Renderer& renderer);

private:
    std::unique_ptr<World> take(double time);

    std::unique_ptr<LoadedScene> loaded_;
    SceneTime time_;
    SceneView view_;
    std::optional<AddedLights> added_;
    const World* shown_ = nullptr; ///< the renderer's
    double shown_time_ = 0;
    std::unique_ptr<World> current_; ///< what shown_ points to; null: loaded_->world
    double next_time_ = 0;
    std::future<std::unique_ptr<World>> next_; ///< last: its end waits for the thread
};

} // namespace prelight::app
