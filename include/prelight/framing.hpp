#pragma once
#include <prelight/export.hpp>
#include <prelight/scene.hpp>

namespace prelight {

/// From where a world is looked at, and how large it shows.
struct Framing {
    double azimuth = 20;   ///< degrees about +Y: 0 looks from +Z, glTF's front, 90 from +X
    double elevation = 15; ///< degrees above the horizon, −90 … 90
    double fit = 0.8;      ///< of the picture's width or height, whichever is reached first: > 0
};

/// The camera that sees the world's triangles from there: what is drawn of their vertices spans `fit` of the picture in
/// the tighter of its dimensions, less in the other, and lies in the middle. Named "framed", 30° high. `aspect`: the
/// picture's width / height. Straight above and below, the picture's up is where the camera would come to with a
/// smaller elevation. A world without extent is taken for a metre wide.
PRELIGHT_API PlacedCamera frame(const World& world, double aspect, const Framing& framing = {});

} // namespace prelight
