#pragma once
#include "scene_source.hpp"

namespace prelight::app {

/// One scene with different numbers of lights; its geometry stays what it is with its own. A file is
/// read once.
class SceneSeries {
public:
    /// As `--lights`, `--seed` and `--time` say; `edit` is done to the scene, `view` says from where it is seen. A file
    /// that has no lights and is given no number gets `default_lights`. Throws Error, UsageError.
    SceneSeries(std::string name, std::optional<uint32_t> lights, uint64_t seed, SceneTime time, SceneEdit edit = {},
                SceneView view = {});

    static constexpr uint32_t default_lights = 256;

    /// Changes a file's environment, also in what make() has given already.
    void edit(const SceneEdit& edit) { edit(file_->scene); }

    /// The scene with the number of lights that the command asks for. Must not outlive this object.
    /// Throws Error.
    std::unique_ptr<LoadedScene> make() const;
    /// Its lights when a built-in scene has `count` of them, or a file's has so many more.
    std::vector<PlacedLight> lights(uint32_t count) const;
    /// How many that is.
    uint64_t total(uint32_t count) const { return count + (file_ ? file_->world.lights.size() : 0); }
    /// Lights that make() adds to a file's.
    uint64_t added() const { return file_ ? lights_.value_or(0) : 0; }

private:
    std::string name_;
    std::optional<uint32_t> lights_;
    uint64_t seed_;
    SceneTime time_;
    SceneEdit edit_;
    SceneView view_;
    std::unique_ptr<LoadedScene> file_; ///< with no lights added; null for a built-in scene
};

} // namespace prelight::app
