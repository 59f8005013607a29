#pragma once
#include "scene_reading.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <prelight/framing.hpp>
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

/// True when `name` means a file: it ends in .gltf or .glb, is "-" (standard input), or a file of that name exists.
bool names_file(const std::string& name);

/// Makes a built-in scene with `lights` or its own default count. Throws UsageError.
Scene make_builtin(const std::string& name, std::optional<uint32_t> lights, uint64_t seed);

/// Throws UsageError for what is neither a file's name nor a built-in scene's.
void check_scene_name(const std::string& name);

/// True when `name` is a built-in scene's and no file's.
bool names_builtin(const std::string& name);

/// When in a scene's animations, and how its file is read.
struct SceneTime {
    std::optional<Moment> moment; ///< absent: the scene at rest
    std::string animation;        ///< name or index; empty: all
    SceneReading reading{};
};

/// What is done to a scene before it is resolved; may be empty.
using SceneEdit = std::function<void(Scene&)>;

/// How the picture is framed: as the scene is at time 0, whatever moment is shown, so that the camera stands still.
struct SceneView {
    double aspect = 16.0 / 9;       ///< width / height
    std::optional<Framing> framing; ///< in place of the scene's cameras; absent: where it has none, the default one
};

/// Point lights that `--lights` adds to a file's world, in its bounds at time 0: they stand still.
struct AddedLights {
    uint32_t count = 0;
    uint64_t seed = 1;
};

/// The world of a scene that load_scene() has read, at another moment. Throws as resolve().
World resolve_at(const Scene& scene, const SceneTime& time, const SceneView& view,
                 const std::optional<AddedLights>& added);

/// Loads a file or makes a built-in scene, resolves it at that time, and adds lights to it as
/// `--lights` says, `max_lights` at most. Where the scene has no camera, or `view` asks for another, cameras[0] is that
/// of `view`. Warnings about the file go to stderr; read strictly, the first is an Error. Throws Error; UsageError for
/// a scene or an animation that is not there.
std::unique_ptr<LoadedScene> load_scene(const std::string& name, std::optional<uint32_t> lights, uint64_t seed,
                                        uint64_t max_lights, const SceneTime& time = {}, const SceneEdit& edit = {},
                                        const SceneView& view = {});
/// The same for a built-in scene that make_builtin() has made already.
std::unique_ptr<LoadedScene> resolve_builtin(Scene scene, const SceneTime& time, const SceneEdit& edit = {},
                                             const SceneView& view = {});

} // namespace prelight::app
