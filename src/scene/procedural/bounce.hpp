#pragma once
#include <prelight/scene.hpp>

namespace prelight {

/// A closed room of coloured boxes with one window. The first light is the sun, which shines through it (with the
/// setting `shadows`) on a patch of the floor and of what stands there; the `lights` − 1 others are virtual point
/// lights on that patch (Keller, "Instant Radiosity", 1997): fake indirect light, the first bounce. Each stands for an
/// equal share of what falls through the window, spread evenly over it (a low-discrepancy sequence that begins where
/// `seed` says), has the colour of the surface there, and shines like a Lambert surface as far as a spot can: with
/// as much light in all. They cast no shadows.
Scene make_bounce_scene(uint32_t lights, uint64_t seed);

} // namespace prelight
