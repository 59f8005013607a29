#include "scene_series.hpp"

#include <limits>

namespace prelight::app {

SceneSeries::SceneSeries(std::string name, std::optional<uint32_t> lights, uint64_t seed)
    : name_(std::move(name)), lights_(lights), seed_(seed) {
    if (!names_file(name_))
        return;
    file_ = load_scene(name_, {}, seed_, std::numeric_limits<uint64_t>::max());
    if (!lights_ && file_->scene.lights.empty())
        lights_ = default_lights;
}

std::unique_ptr<LoadedScene> SceneSeries::make(std::optional<uint32_t> lights) const {
    if (!file_)
        return load_scene(name_, lights, seed_, std::numeric_limits<uint64_t>::max());
    auto copy = std::make_unique<LoadedScene>(); // its world refers to the file's meshes and images
    copy->world = file_->world;
    if (lights)
        scatter_lights(copy->world, *lights, seed_);
    return copy;
}

} // namespace prelight::app
