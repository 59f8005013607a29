#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>
#include <scene/procedural/bounce.hpp>
#include <scene/procedural/city.hpp>
#include <scene/procedural/cookies.hpp>
#include <scene/procedural/decals.hpp>
#include <scene/procedural/glass.hpp>
#include <scene/procedural/lights.hpp>
#include <scene/procedural/materials.hpp>
#include <scene/procedural/motion.hpp>
#include <scene/procedural/multipass.hpp>
#include <scene/procedural/round2.hpp>
#include <scene/procedural/shadows.hpp>
#include <scene/procedural/spheres.hpp>

namespace prelight {
namespace {

constexpr uint32_t max_lights = 65536;

struct Entry {
    BuiltinScene scene;
    Scene (*make)(uint32_t lights, uint64_t seed);
};

/// A new built-in scene is one line here.
constexpr auto entries = std::to_array<Entry>({
    {{"city", "a wet street at night: facades, cars, neon, lamps, string lights", 1024}, make_city},
    {{"city-sparks", "the same street with sparks of welding, each a moving light: 8 in 9 of the lights", 9216},
     make_city_sparks},
    {{"city-smoke", "city-sparks with the steam of eight vents: 8,192 soft billboards, lit by all lights", 9216},
     make_city_smoke},
    {{"city-glass", "the same street with glass shelters and canopies of cloth, blended", 1024}, make_city_glass},
    {{"spheres", "shininess x metalness grid of spheres", 8}, make_spheres_scene},
    {{"lights", "baseline for speed: 144 spheres, 121 columns, small point lights", 1024}, make_lights_scene},
    {{"motion", "all that moves: turning boxes, a bent column, a morphing sphere, camera, lights", 24},
     make_motion_scene},
    {{"shadows", "thin walls, poles, a fence, columns far away: sun, point light, narrow and wide spot", 4},
     make_shadows_scene},
    {{"cookies", "a room whose lights throw pictures and have measured profiles: window, lantern, dice, wall lamps", 7},
     make_cookies_scene},
    {{"materials", "every built-in material on the same sphere, lights that go round", 9}, make_materials_scene},
    {{"decals", "cracks, paint, bolts, a puddle and a burn on brick walls and a floor, lights that go round", 8},
     make_decals_scene},
    {{"glass", "blended surfaces: crossing panes, bottles, a lamp in its shade, a lantern in smoke, a dark floor", 16},
     make_glass_scene},
    {{"round2", "one textured model under six directional lights, as in the Round 2 sample", 6}, make_round2_scene},
    {{"multipass", "a few meshes and materials to turn, lights to add and remove, as in the multipass sample", 6},
     make_multipass_scene},
    {{"bounce", "a room with a sunlit patch, and small lights on it in place of its indirect light", 65},
     make_bounce_scene},
});

} // namespace

std::vector<BuiltinScene> builtin_scenes() {
    std::vector<BuiltinScene> list;
    for (const Entry& entry : entries)
        list.push_back(entry.scene);
    return list;
}

Scene make_scene(std::string_view name, uint32_t lights, uint64_t seed) {
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.scene.name == name; });
    if (found == entries.end()) {
        std::string known;
        for (const Entry& entry : entries)
            known += fmt::format("{}{}", known.empty() ? "" : ", ", entry.scene.name);
        throw UsageError(fmt::format("scene {}: unknown; built-in scenes are {}", name, known));
    }
    if (lights < 1 || lights > max_lights)
        throw UsageError(fmt::format("scene {}: lights: {} is outside 1 … {}", name, lights, max_lights));
    return found->make(lights, seed);
}

} // namespace prelight
