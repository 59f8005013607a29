#pragma once
#include <cstdint>
#include <prelight/scene.hpp>

namespace prelight {

/// A night street after rain: houses with lit windows and shops, wet asphalt, lamps, neon signs,
/// cars and string lights. Metres, +Y up, the street along −Z, a crossing at z = −26 m.
///
/// `lights` is the exact number of lights, 1 to 65,536 (checked by make_scene). They are handed out
/// by importance: street lamps and head lights in turn, neon, shops, tail lights and signals; then
/// windows and small lights share what is left. Small lights hang on the strings first and then lie
/// on fronts and pavements; the more there are the shorter their range, so that the number of
/// lights on a point stays about the same (mean near 30 from 1,024 to 65,536). The objects depend
/// on `seed` only. Cameras: "street" (first), "crossing", "above".
Scene make_city(uint32_t lights, uint64_t seed);

/// The same street with eight places where somebody welds: a ninth of the lights are the city's, all others are
/// sparks, each a particle of an emitter. With 9,216 lights: `city` with 1,024, and 8,192 sparks.
Scene make_city_sparks(uint32_t lights, uint64_t seed);

/// The same street with sheets of alphaMode BLEND that stand apart from its fronts: shelters of clear and tinted glass
/// on the pavements, canopies of cloth above shops. The lights are `city`'s.
Scene make_city_glass(uint32_t lights, uint64_t seed);

/// `city-sparks` with steam over eight vents: 8,192 particles that are soft billboards and no lights. The lights are
/// `city-sparks`'s.
Scene make_city_smoke(uint32_t lights, uint64_t seed);

} // namespace prelight
