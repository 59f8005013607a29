#pragma once
#include "scene_source.hpp"

#include <future>
#include <prelight/renderer.hpp>
#include <prelight/timeline.hpp>

namespace prelight::app {

/// A scene whose moments are shown one after the other. This is the one place that knows how a renderer gets from one
/// to the next: it is told what changed. What a moment shows does not depend on those before it.
class SceneAtTime {
public:
    /// `loaded`: the scene at time 0, with `added` lights of the program's own, the last of its world's. `time`,
    /// `view`: what it was loaded with; of `time` the moment is not used. `on_device`: the renderers that are shown it
    /// deform skins and morph targets themselves.
    SceneAtTime(std::unique_ptr<LoadedScene> loaded, const SceneTime& time, const SceneView& view, size_t added,
                bool on_device);

    const Scene& scene() const { return loaded_->scene; }
    /// At time 0.
    const World& start() const { return loaded_->world; }
    /// Changes the scene's environment, before the first show().
    void edit(const SceneEdit& edit) { edit(loaded_->scene); }
    /// False: every moment is the same.
    bool moves() const { return timeline_ || !scene().animations.empty() || !scene().emitters.empty(); }
    /// Seconds from the animations' start to the last keyframe of those that play; absent: none plays.
    std::optional<double> length() const;

    /// Begins what the host has to do for that time, in another thread. `time` ≥ 0, seconds.
    void prepare(double time);
    /// Afterwards the renderer shows the scene at that time; nothing is done when it does already. Always the same
    /// renderer. Gives the world, but for lights of the program's own, which stays as it is until the next call. Throws
    /// Error.
    const World& show(double time, Renderer& renderer);
    /// Of the moment that was shown last, before the first of time 0: by name or index, empty: the first. Throws
    /// UsageError.
    const PlacedCamera& camera(const std::string& name) const;

private:
    World take(double time);
    void set_lights(Renderer& renderer) const;

    std::unique_ptr<LoadedScene> loaded_;
    SceneTime time_;
    std::vector<PlacedLight> added_;
    bool own_camera_; ///< the camera is the program's, and stands still
    bool on_device_;
    std::optional<Timeline> timeline_; ///< of a scene that moves, from the first show() on
    bool shown_ = false;
    double shown_time_ = 0, next_time_ = 0;
    std::future<World> next_; ///< last: its end waits for the thread
};

} // namespace prelight::app
