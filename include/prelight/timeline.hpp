#pragma once
#include <memory>
#include <prelight/export.hpp>
#include <prelight/scene.hpp>

namespace prelight {

/// `world` becomes `next`, another state of the same scene, where it stands; what has changed of it is told. What has
/// not stays where it is in memory, for a renderer may refer to it; one that shows the world must be told before it
/// draws.
PRELIGHT_API WorldChanges become(World& world, World&& next);

/// A scene's world at one moment after another, for a renderer that is kept: the world changes where it stands, and
/// what of it has changed goes into Renderer::update_world(). It is at any moment what resolve() gives for it, whatever
/// came before.
class PRELIGHT_API Timeline {
public:
    /// As resolve(); the scene must outlive it, and stay as it is but for its materials. Without `host_vertices` skins
    /// and morph targets are left to the device: World::deformed holds no vertices of theirs, from the first move_to()
    /// on World::bounds are those of boxes around them, and a camera of resolve()'s own stays where it was first. For
    /// renderers on a device. Throws Error.
    explicit Timeline(const Scene& scene, std::optional<uint32_t> scene_index = {},
                      const std::optional<Moment>& moment = {}, std::optional<uint32_t> animation = {},
                      bool host_vertices = true);
    ~Timeline();
    /// The world stays where it is in memory.
    Timeline(Timeline&&) noexcept;
    /// Likewise.
    Timeline& operator=(Timeline&&) noexcept;

    /// The same object as long as the timeline lives.
    const World& world() const;
    /// Whether the scene has animations or emitters, in whichever of its trees.
    bool moves() const;
    /// Cameras, bounds and ambient light change too, and nobody need be told. Throws Error; the world is as before
    /// then.
    WorldChanges move_to(const Moment& moment);
    /// The first half of move_to(), which may run in another thread while a renderer shows the world. Throws Error.
    World at(const Moment& moment) const;
    /// The second half: the world becomes what at() gave.
    WorldChanges take(World&& next);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace prelight
