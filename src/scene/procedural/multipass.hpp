#pragma once
#include <prelight/scene.hpp>

namespace prelight {

/// What the multipass sample shows: a handful of meshes on a floor, each of which can carry each of the scene's
/// materials, under point and spot lights; for turning meshes, lights and camera, for adding and removing lights.
Scene make_multipass_scene(uint32_t lights, uint64_t seed);

} // namespace prelight
