#include "sequence/scene_at_time.hpp"

#include <algorithm>

namespace prelight::app {

SceneAtTime::SceneAtTime(std::unique_ptr<LoadedScene> loaded, const SceneTime& time, const SceneView& view,
                         size_t added, bool on_device)
    : loaded_(std::move(loaded)), time_(time),
      added_(loaded_->world.lights.end() - static_cast<ptrdiff_t>(added), loaded_->world.lights.end()),
      own_camera_(view.framing || !has_camera(loaded_->scene)), on_device_(on_device) {}

std::optional<double> SceneAtTime::length() const {
    if (scene().animations.empty())
        return {};
    const uint32_t only = time_.animation.empty() ? 0 : find_animation(scene(), time_.animation);
    double length = 0;
    for (uint32_t i = 0; i < scene().animations.size(); ++i)
        if (time_.animation.empty() || i == only)
            for (const AnimationSampler& sampler : scene().animations[i].samplers)
                if (!sampler.times.empty())
                    length = std::max(length, double(sampler.times.back()));
    return length;
}

void SceneAtTime::prepare(double time) {
    if (!timeline_ || (shown_ && shown_time_ == time))
        return;
    next_time_ = time;
    next_ = std::async(std::launch::async, [this, time] { return timeline_->at(Moment{.time = time}); });
}

World SceneAtTime::take(double time) {
    if (!next_.valid() || next_time_ != time)
        prepare(time);
    return next_.get();
}

void SceneAtTime::set_lights(Renderer& renderer) const {
    std::vector<PlacedLight> lights = timeline_->world().lights;
    lights.insert(lights.end(), added_.begin(), added_.end());
    renderer.set_lights(lights);
}

const World& SceneAtTime::show(double time, Renderer& renderer) {
    if (!moves()) {
        if (!shown_)
            renderer.set_world(start());
        shown_ = true;
        return start();
    }
    if (!timeline_) {
        std::optional<uint32_t> animation;
        if (!time_.animation.empty())
            animation = find_animation(scene(), time_.animation);
        timeline_.emplace(scene(), std::nullopt, Moment{.time = time}, animation, !on_device_);
        renderer.set_world(timeline_->world());
        if (!added_.empty())
            set_lights(renderer);
    } else if (!shown_ || shown_time_ != time) {
        shown_ = false; // until it is
        WorldChanges changes = timeline_->take(take(time));
        const bool relight = !added_.empty() && (changes.lights || changes.all);
        changes.lights = changes.lights && !relight;
        renderer.update_world(changes);
        if (relight)
            set_lights(renderer);
    }
    shown_ = true;
    shown_time_ = time;
    return timeline_->world();
}

const PlacedCamera& SceneAtTime::camera(const std::string& name) const {
    const World& world = timeline_ && !own_camera_ ? timeline_->world() : start();
    return name.empty() ? world.cameras.at(0) : find_camera(world, name);
}

} // namespace prelight::app
