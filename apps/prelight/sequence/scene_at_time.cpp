#include "sequence/scene_at_time.hpp"

#include <algorithm>

namespace prelight::app {

SceneAtTime::SceneAtTime(std::unique_ptr<LoadedScene> loaded, const SceneTime& time, const SceneView& view,
                         const std::optional<AddedLights>& added)
    : loaded_(std::move(loaded)), time_(time), view_(view), added_(added) {}

bool SceneAtTime::moves() const { return !scene().animations.empty() || !scene().emitters.empty(); }

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
    if (!moves() || time == 0 || (shown_ && shown_time_ == time))
        return;
    next_time_ = time;
    next_ = std::async(std::launch::async, [this, at = time_, time]() mutable {
        at.moment = Moment{.time = time};
        return std::make_unique<World>(resolve_at(scene(), at, view_, added_));
    });
}

/// Null: the world at time 0, which is there.
std::unique_ptr<World> SceneAtTime::take(double time) {
    if (time == 0)
        return {};
    if (!next_.valid() || next_time_ != time)
        prepare(time);
    return next_.get();
}

const World& SceneAtTime::show(double time, Renderer& renderer) {
    if (shown_ && (!moves() || shown_time_ == time))
        return *shown_;
    std::unique_ptr<World> world = moves() ? take(time) : nullptr;
    const World& wanted = world ? *world : start();
    shown_ = nullptr;
    renderer.set_world(wanted);
    current_ = std::move(world); // not before: the renderer pointed into the one that goes now
    shown_ = &wanted;
    shown_time_ = time;
    return wanted;
}

} // namespace prelight::app
