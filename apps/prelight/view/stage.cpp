#include "stage.hpp"

#include "../scene_files.hpp"

#include <algorithm>
#include <utility>

namespace prelight::app::viewer {
namespace {

constexpr uint32_t most_lights = 1u << 24; ///< as the reference holds; a renderer may hold fewer, and says so

} // namespace

SceneReader::SceneReader(const RenderCommand& command) : command_(command), materials_(command_.materials) {
    materials_.check();
}

uint32_t SceneReader::scattered(const std::string& scene) const {
    return names_file(scene) ? command_.lights.value_or(0) : 0;
}

std::unique_ptr<LoadedScene> SceneReader::read(const std::string& scene, double aspect,
                                               const std::optional<Moment>& moment) {
    const bool own = scene == command_.scene;
    // Another scene has none of the names that the command line gave.
    const std::optional<uint32_t> lights = own || !names_builtin(scene) ? command_.lights : std::nullopt;
    SceneTime time{moment, own ? command_.animation : "", command_.reading};
    if (!own)
        time.reading.scene.clear();
    const bool studio_where_dark = names_file(scene) && !command_.lights;
    const SceneEdit edit = [&, environment = environment_edit(command_.environment, studio_where_dark)](Scene& made) {
        if (own)
            materials_.assign(made);
        environment(made);
        if (own && kept_edit_ && !made.environment)
            kept_edit_(made);
    };
    return load_scene(scene, lights, command_.seed, most_lights, time, edit,
                      {aspect, own ? command_.framing : std::nullopt});
}

void SceneReader::take_environment(const std::filesystem::path& file) {
    EnvironmentChoice next = command_.environment;
    next.name.clear();
    next.file = file;
    Scene probe;
    probe.scenes.emplace_back();
    environment_edit(next)(probe); // reads it
    command_.environment = next;
}

std::vector<std::filesystem::path> SceneReader::files(const std::string& scene) const {
    std::vector<std::filesystem::path> files;
    if (names_file(scene)) {
        files.emplace_back(scene);
        for (std::filesystem::path& file : files_named_in(scene))
            files.push_back(std::move(file));
    }
    for (const auto& [name, file] : command_.materials)
        files.push_back(file);
    if (!command_.environment.file.empty())
        files.push_back(command_.environment.file);
    return files;
}

Stage::Stage(std::unique_ptr<LoadedScene> loaded, uint32_t scattered, bool framed) : loaded_(std::move(loaded)) {
    World& first = loaded_->world;
    const size_t own = first.lights.size() - std::min<size_t>(first.lights.size(), scattered);
    scattered_.assign(first.lights.begin() + static_cast<std::ptrdiff_t>(own), first.lights.end());
    if (framed || !has_camera(loaded_->scene))
        framed_ = first.cameras;
    world_ = std::make_unique<World>(std::move(first));
}

void Stage::pose(const std::optional<Moment>& moment, std::optional<uint32_t> animation) {
    if (moment && (!timeline_ || timed_ != animation)) {
        timeline_.emplace(loaded_->scene, std::nullopt, moment, animation);
        timed_ = animation;
    }
    World next = moment ? timeline_->at(*moment) : resolve(loaded_->scene, {}, {}, animation);
    next.lights.insert(next.lights.end(), scattered_.begin(), scattered_.end());
    if (!framed_.empty())
        next.cameras = framed_;
    object_edits.apply(next);
    changes_.add(become(*world_, std::move(next)));
}

bool Stage::next_material(std::optional<uint32_t> node) {
    bool any = false;
    std::vector<bool> done(loaded_->scene.meshes.size());
    for (const Instance& instance : world_->instances) {
        const bool particles = instance.deformed && !world_->deformations.at(*instance.deformed).mesh;
        if (particles || (node && instance.node != *node) || instance.mesh >= done.size() || done[instance.mesh])
            continue;
        done[instance.mesh] = true;
        any |= take_next_material(loaded_->scene, loaded_->scene.meshes[instance.mesh]);
    }
    changes_.all |= any;
    return any;
}

double Stage::length(std::optional<uint32_t> animation) const {
    double longest = 0;
    for (uint32_t a = 0; a < scene().animations.size(); ++a)
        for (const AnimationSampler& sampler : scene().animations[a].samplers)
            if (!animation || *animation == a)
                longest = std::max(longest, double(sampler.times.back()));
    return longest;
}

} // namespace prelight::app::viewer
