#pragma once
#include <prelight/scene.hpp>
#include <resident/scene.hpp>
#include <span>

namespace prelight::passes {

/// The most lights whose ranges meet at one point of a surface, rather too many than too few: blending adds no more
/// of them to a pixel, for the others add 0. It does not depend on the camera, and costs little more than a look at
/// each light.
uint32_t light_overlap(std::span<const resident::Draw> draws, std::span<const PlacedLight> lights);

} // namespace prelight::passes
