#include "scene_source.hpp"

#include "argument.hpp"
#include "options/suggestion.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <platform/program/standard_streams.hpp>
#include <prelight/scene_io.hpp>

namespace prelight::app {
namespace {

const BuiltinScene* find_builtin(const std::vector<BuiltinScene>& scenes, const std::string& name) {
    const auto found = std::ranges::find(scenes, std::string_view(name), &BuiltinScene::name);
    return found == scenes.end() ? nullptr : &*found;
}

/// A file, or "-": then messages name standard input.
Scene load_file(const std::string& name, const LoadOptions& options) {
    if (!is_standard_stream(name))
        return load_gltf(name, options);
    const std::string file = standard_input_file().string();
    const auto renamed = [&](std::string text) {
        for (size_t at = text.find(file); at != std::string::npos; at = text.find(file, at))
            text.replace(at, file.size(), "standard input");
        return text;
    };
    try {
        Scene scene = load_gltf(file, options);
        scene.name = "standard input";
        for (std::string& warning : scene.warnings)
            warning = renamed(warning);
        return scene;
    } catch (const UsageError& error) {
        throw UsageError(renamed(error.what()));
    } catch (const Error& error) {
        throw Error(renamed(error.what()));
    }
}

/// Makes the scene what the command asks for, and its world.
void prepare(LoadedScene& loaded, const SceneTime& time, const SceneEdit& edit, const SceneView& view,
             const std::optional<AddedLights>& added = {}) {
    if (!time.reading.scene.empty())
        loaded.scene.default_scene = find_scene(loaded.scene, time.reading.scene); // the edit looks at its lights
    if (edit)
        edit(loaded.scene);
    loaded.world = resolve_at(loaded.scene, time, view, added);
}

} // namespace

bool names_file(const std::string& name) {
    if (is_standard_stream(name))
        return true;
    const std::string extension = lower_extension(name);
    std::error_code ignored;
    return extension == ".gltf" || extension == ".glb" || std::filesystem::is_regular_file(name, ignored);
}

bool names_builtin(const std::string& name) { return !names_file(name) && find_builtin(builtin_scenes(), name); }

void check_scene_name(const std::string& name) {
    if (!names_file(name) && !find_builtin(builtin_scenes(), name))
        throw UsageError(fmt::format("{}: neither a file nor a built-in scene ({}){}", name, builtin_names(),
                                     did_you_mean(name, builtin_list())));
}

Scene make_builtin(const std::string& name, std::optional<uint32_t> lights, uint64_t seed) {
    const std::vector<BuiltinScene> scenes = builtin_scenes();
    const BuiltinScene* builtin = find_builtin(scenes, name);
    if (!builtin)
        throw UsageError(
            fmt::format("{}: not a built-in scene ({}){}", name, builtin_names(), did_you_mean(name, builtin_list())));
    return make_scene(name, lights.value_or(builtin->default_lights), seed);
}

World resolve_at(const Scene& scene, const SceneTime& time, const SceneView& view,
                 const std::optional<AddedLights>& added) {
    std::optional<uint32_t> animation;
    if (!time.animation.empty())
        animation = find_animation(scene, time.animation);
    World world = resolve(scene, {}, time.moment, animation);
    const bool own_camera = view.framing || !has_camera(scene);
    if (!own_camera && !added)
        return world;
    const bool later = time.moment && time.moment->time != 0;
    const std::optional<World> at_start = later ? std::optional(resolve(scene, {}, Moment{}, animation)) : std::nullopt;
    const World& start = at_start ? *at_start : world;
    const bool framed = view.framing || start.framed;
    std::vector<PlacedCamera> cameras = start.cameras;
    if (framed)
        cameras = {frame(start, view.aspect, view.framing.value_or(Framing{}))};
    if (added) {
        World lit{.scene = &scene, .instances = {}};
        lit.bounds_min = start.bounds_min;
        lit.bounds_max = start.bounds_max;
        scatter_lights(lit, added->count, added->seed);
        world.lights.insert(world.lights.end(), lit.lights.begin(), lit.lights.end());
    }
    if (own_camera)
        world.cameras = std::move(cameras);
    return world;
}

std::unique_ptr<LoadedScene> resolve_builtin(Scene scene, const SceneTime& time, const SceneEdit& edit,
                                             const SceneView& view) {
    auto loaded = std::make_unique<LoadedScene>();
    loaded->scene = std::move(scene);
    prepare(*loaded, time, edit, view);
    return loaded;
}

std::unique_ptr<LoadedScene> load_scene(const std::string& name, std::optional<uint32_t> lights, uint64_t seed,
                                        uint64_t max_lights, const SceneTime& time, const SceneEdit& edit,
                                        const SceneView& view) {
    auto loaded = std::make_unique<LoadedScene>();
    check_scene_name(name);
    const bool file = names_file(name);
    const LoadOptions options{.strict = time.reading.strict, .memory_limit = time.reading.memory_limit};
    loaded->scene = file ? load_file(name, options) : make_builtin(name, lights, seed);
    std::optional<AddedLights> added;
    if (file && lights) {
        if (*lights > max_lights)
            throw Error(fmt::format("{}: --lights {}: the renderer holds {}", name, *lights, max_lights));
        added = {*lights, seed};
    }
    prepare(*loaded, time, edit, view, added);
    // After all that can fail: a failure is one line.
    const std::vector<std::string> warnings = warnings_of(loaded->world);
    if (time.reading.strict && !warnings.empty())
        throw Error(warnings.front());
    const Log log(time.reading.log_level);
    for (const std::string& warning : warnings)
        log.warning(warning);
    return loaded;
}

} // namespace prelight::app
