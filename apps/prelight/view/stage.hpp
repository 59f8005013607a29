#pragma once
#include "../command_line.hpp"
#include "../own_materials.hpp"
#include "../scene_source.hpp"
#include "light_edits.hpp"
#include "object_edits.hpp"

#include <prelight/timeline.hpp>
#include <utility>

namespace prelight::app::viewer {

/// Reads scenes as the command line says, again and again: other ones, and when they have changed.
class SceneReader {
public:
    explicit SceneReader(const RenderCommand& command);
    SceneReader(const SceneReader&) = delete;
    SceneReader& operator=(const SceneReader&) = delete;
    /// Throws Error, UsageError.
    std::unique_ptr<LoadedScene> read(const std::string& scene, double aspect, const std::optional<Moment>& moment);
    /// Whether the command line frames this scene in place of its cameras.
    bool frames(const std::string& scene) const { return scene == command_.scene && command_.framing; }
    /// The environment file takes the place of the command's. Throws Error when it is none.
    void take_environment(const std::filesystem::path& file);
    /// Does this to the command's own scene where it has no environment, whenever it is read.
    void keep_edit(SceneEdit edit) { kept_edit_ = std::move(edit); }
    /// Materials with a mistake stay as they were; the mistakes come back.
    std::vector<std::string> take_changes() { return materials_.take_changes(); }
    /// Lights that `--lights` adds to a scene's own.
    uint32_t scattered(const std::string& scene) const;
    /// What is read by name for this scene.
    std::vector<std::filesystem::path> files(const std::string& scene) const;

private:
    RenderCommand command_;
    OwnMaterials materials_;
    SceneEdit kept_edit_;
};

/// A scene at a moment, with what has been done to it.
class Stage {
public:
    /// `framed`: its camera is not the scene's.
    Stage(std::unique_ptr<LoadedScene> loaded, uint32_t scattered, bool framed);

    const Scene& scene() const { return loaded_->scene; }
    const World& world() const { return *world_; }
    /// The lights before edits, and after.
    const std::vector<PlacedLight>& own_lights() const { return world_->lights; }
    std::vector<LightEdits::Listed> lights() const { return light_edits.applied(world_->lights); }
    std::optional<PlacedLight> light(uint32_t number) const { return light_edits.one(world_->lights, number); }
    /// Changes the scene's environment, before a renderer looks at it.
    void edit(const SceneEdit& edit) { edit(loaded_->scene); }
    /// What the world is like then, where it stands: what changes waits for take_changes(). Throws Error.
    void pose(const std::optional<Moment>& moment, std::optional<uint32_t> animation);
    /// Objects of the node, or all, take the next material; false: there is none.
    bool next_material(std::optional<uint32_t> node);
    bool moves() const { return !scene().animations.empty() || !scene().emitters.empty(); }
    /// Of the animation, or of all: seconds.
    double length(std::optional<uint32_t> animation) const;

    /// What a renderer has to be told that took in the world when this was asked last.
    WorldChanges take_changes() { return std::exchange(changes_, {}); }

    LightEdits light_edits;
    ObjectEdits object_edits;

private:
    std::unique_ptr<LoadedScene> loaded_;
    std::vector<PlacedLight> scattered_; ///< stay where they are
    std::vector<PlacedCamera> framed_;   ///< of a scene without cameras, or in their place
    std::unique_ptr<World> world_;
    std::optional<Timeline> timeline_; ///< of `timed_`, from the first moment on
    std::optional<uint32_t> timed_;    ///< the animation
    WorldChanges changes_;
};

} // namespace prelight::app::viewer
