#pragma once
#include "entry.hpp"
#include <prelight/scene.hpp>

namespace prelight::python {

/// A scene that may be edited. Worlds and views of its memory share it as it is when they are made; so it is copied
/// before it changes, where somebody still has it.
struct SceneBox {
    std::shared_ptr<Scene> scene = std::make_shared<Scene>();
    Scene& edit() {
        if (scene.use_count() > 1)
            scene = std::make_shared<Scene>(*scene);
        return *scene;
    }
};

struct WorldBox {
    std::shared_ptr<const Scene> scene;
    World world;
};

/// What no renderer may meet: numbers out of range, textures that are not there. Throws UsageError.
void check_scene(const Scene& scene);
void check_camera(const PlacedCamera& camera);
/// All of them, as they go to a renderer.
void check_lights_given(const Scene& scene, const std::vector<PlacedLight>& lights);
/// A copy for a renderer, checked. Throws UsageError.
World checked_copy(const WorldBox& box);

/// (4, 4) with a last row of 0 0 0 1. Throws UsageError.
glm::dmat4 to_affine(const ArrayLike& given, const std::string& what);

/// A camera as functions take it: a Camera, a name or number of the world's, or None: the world's first, or where the
/// scene has none one that frames it.
struct CameraWish {
    std::optional<PlacedCamera> camera;
    std::optional<std::string> name;
};
/// Throws UsageError, TypeError.
CameraWish camera_wish(const py::object& given);
/// In a picture of this aspect. Needs no GIL. Throws UsageError.
PlacedCamera find(const CameraWish& wish, const World& world, double aspect);

} // namespace prelight::python
