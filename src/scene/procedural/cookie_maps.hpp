#pragma once
#include <prelight/scene.hpp>
#include <string>

namespace prelight {

// What the lights of the scene `cookies` throw.

/// An arched window of coloured panes between leads: for a spot.
TextureImage window_cookie();
/// A lantern of pierced metal, stars between bands: equirectangular.
TextureImage lantern_cookie();
/// A dice with holes for its pips, each face with a colour: six faces side by side.
TextureImage dice_cookie();
/// An IES file (LM-63-2002): a lamp that sends a narrow beam, a ring around it and some light upwards, alike in all
/// four quarters.
std::string wall_lamp_profile();

} // namespace prelight
