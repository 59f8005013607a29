#pragma once
#include <memory>
#include <optional>
#include <prelight/scene.hpp>
#include <string>

namespace prelight::app {

/// A scene and its World, which points into it: made together, kept together, never copied.
struct LoadedScene {
    LoadedScene() = default;
    LoadedScene(const LoadedScene&) = delete;
    LoadedScene& operator=(const LoadedScene&) = delete;
    Scene scene;
    World world;
};

/// True when `name` means a file: it ends in .gltf or .glb, or a file of that name exists.
bool names_file(const std::string& name);

/// Makes a built-in scene with `lights` or its own default count. Throws UsageError.
Scene make_builtin(const std::string& name, std::optional<uint32_t> lights, uint64_t seed);

/// Loads a file or makes a built-in scene, resolves it, and adds lights to it as `--lights` says,
/// `max_lights` at most.
/// Warnings of the loader go to stderr. Throws Error.
std::unique_ptr<LoadedScene> load_scene(const std::string& name, std::optional<uint32_t> lights,
                                        uint64_t seed, uint64_t max_lights);

} // namespace prelight::app
