#include <iterator>
#include <scene/procedural/builder.hpp>
#include <scene/procedural/city.hpp>
#include <scene/procedural/glass_maps.hpp>

namespace prelight {
namespace {

constexpr uint32_t puffs = 8192; ///< of all emitters

/// Vents in the road and in the pavements (0.14 m up), each some metres from where somebody welds: there a thousand
/// sparks would light every puff.
constexpr glm::dvec3 vents[] = {{-5.4, 0.14, 1.4}, {1.6, 0, -3.6},     {-6.3, 0.14, -7},  {6.4, 0.14, -4},
                                {-1.5, 0, -10.5},  {6.2, 0.14, -14.5}, {-6.2, 0.14, -22}, {0.4, 0, -19}};

/// Every light that reaches it shows.
Material smoke_material(Scene& scene) {
    const Sampler sampler{.wrap_s = Wrap::clamp_to_edge, .wrap_t = Wrap::clamp_to_edge};
    Material smoke = sheet_material("smoke", glm::vec3(0.95f, 0.95f, 0.97f), 0.5f, 1);
    smoke.double_sided = false;
    smoke.softness = 0.4f;
    smoke.base_colour_texture = {.image = append(scene.images, smoke_puff()), .sampler = sampler};
    smoke.normal_texture = {.image = append(scene.images, puff_slopes()), .sampler = sampler};
    return smoke;
}

} // namespace

Scene make_city_smoke(uint32_t lights, uint64_t seed) {
    Scene scene = make_city_sparks(lights, seed);
    scene.name = "city-smoke";
    const uint32_t material = append(scene.materials, smoke_material(scene));
    for (size_t i = 0; i < std::size(vents); ++i) {
        Emitter smoke{.count = puffs / std::size(vents),
                      .seed = seed * 1000 + i,
                      .lifetime_from = 1.5f,
                      .lifetime_to = 3,
                      .speed_from = 0.4f,
                      .speed_to = 1.4f,
                      .cone = 0.5f,
                      .radius = 0.12f,
                      .gravity = -0.5f,
                      .drag = 0.7f,
                      .lights = false,
                      .size = 0.2f,
                      .material = material,
                      .shape = ParticleShape::billboard,
                      .sizes = {0.3f, 0.7f, 0.9f, 1},
                      .opacities = {0, 1, 0.7f, 0.3f, 0},
                      .spin = 0.6f};
        const PlacedCamera upwards = look_at({}, vents[i], vents[i] + glm::dvec3(0.25, 1, 0.1), {1, 0, 0});
        glm::dmat4 local(upwards.axes);
        local[3] = {vents[i], 1};
        add_root(scene, "smoke", local).emitter = append(scene.emitters, std::move(smoke));
    }
    return scene;
}

} // namespace prelight
