#pragma once
#include <resident/view.hpp>

namespace prelight {

/// A world on a device as one camera sees it, for tests of passes.
struct WorldView {
    resident::GpuScene scene;
    resident::LightSet lights;
    resident::View view;
    WorldView(const gpu::Context& context, const World& world, const resident::ViewSettings& settings,
              const resident::GpuSceneSettings& scene_settings = {})
        : scene(context, world, scene_settings), lights(scene), view(scene, lights, settings) {}
};

} // namespace prelight
