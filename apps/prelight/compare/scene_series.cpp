#include "scene_series.hpp"

#include <limits>

namespace prelight::app {
namespace {

/// How many lights a renderer holds is for each of them to say, when it gets them.
constexpr uint64_t no_limit = std::numeric_limits<uint64_t>::max();

} // namespace

SceneSeries::SceneSeries(std::string name, std::optional<uint32_t> lights, uint64_t seed, SceneTime time,
                         SceneEdit edit, SceneView view)
    : name_(std::move(name)), lights_(lights), seed_(seed), time_(std::move(time)), edit_(std::move(edit)),
      view_(view) {
    if (!names_file(name_))
        return;
    file_ = load_scene(name_, {}, seed_, no_limit, time_, edit_, view_);
    if (!lights_ && file_->scene.lights.empty())
        lights_ = default_lights;
}

std::unique_ptr<LoadedScene> SceneSeries::make() const {
    if (!file_)
        return load_scene(name_, lights_, seed_, no_limit, time_, edit_, view_);
    auto copy = std::make_unique<LoadedScene>(); // its world refers to the file's meshes and images
    copy->world = file_->world;
    if (lights_)
        scatter_lights(copy->world, *lights_, seed_);
    return copy;
}

std::vector<PlacedLight> SceneSeries::lights(uint32_t count) const {
    if (!file_)
        return load_scene(name_, count, seed_, no_limit, time_)->world.lights;
    World world = file_->world;
    scatter_lights(world, count, seed_);
    return world.lights;
}

} // namespace prelight::app
