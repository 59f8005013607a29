#pragma once
#include <cstdint>
#include <prelight/scene.hpp>

namespace prelight {

/// A night street after rain: houses with lit windows and shops, wet asphalt, lamps, neon signs,
/// cars and string lights. Metres, +Y up, the street along −Z, a crossing at z = −26 m. `lights`, 1
/// … 65,536, is the exact number of lights; they are handed out by importance: street lamps and
/// head lights, neon, shops, tail lights, windows, then string lights and small lights on walls and
/// pavements, whose range shrinks as their number grows so that the number of lights on a point
/// stays about the same. The objects do not depend on `lights`, only on `seed`. Cameras: "street"
/// (first), "crossing", "above".
Scene make_city(uint32_t lights, uint64_t seed);

} // namespace prelight
