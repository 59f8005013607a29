#pragma once
#include "session.hpp"

namespace prelight::app {

struct LoadedScene;

/// How much of each pixel the scene covers, 0 … 1: 0 where nothing is drawn, the alpha of blended surfaces over it, and
/// at edges the share of samples that are covered. Drawn by the command's renderer with black materials before white.
/// What shines through transmission counts as covered; a custom material covers as its base colour's alpha says. The
/// scene is as it was afterwards. Throws Error.
std::vector<float> coverage_of(const Session& session, const RenderCommand& command, LoadedScene& loaded,
                               const PlacedCamera& camera);

/// A display-encoded picture over black as one over a colour, likewise encoded. Both are mixed as linear light, as the
/// samples of an edge are.
void put_over(Image& over_black, const std::vector<float>& coverage, glm::vec3 colour);
/// The same as colours that give the picture again where they are put over black with their coverage.
void take_off_black(Image& over_black, const std::vector<float>& coverage);

} // namespace prelight::app
