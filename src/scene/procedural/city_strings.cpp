#include <array>
#include <scene/procedural/city_plan.hpp>
#include <scene/procedural/city_textures.hpp>

namespace prelight::city {
namespace {

/// A cable between two points with bulbs hanging from it, sagging by `sag` metres.
void garland(Plan& plan, glm::vec3 from, glm::vec3 to, float sag, bool colourful) {
    static constexpr std::array<Glow, 5> mix{Glow::red, Glow::amber, Glow::green, Glow::blue, Glow::pink};
    const auto bulbs = static_cast<uint32_t>(glm::length(to - from) / 0.45f);
    MeshBuilder b;
    const auto at = [&](float t) { return glm::mix(from, to, t) - glm::vec3(0, 4 * sag * t * (1 - t), 0); };
    std::vector<glm::vec3> cable;
    for (uint32_t i = 0; i <= 20; ++i)
        cable.push_back(at(static_cast<float>(i) / 20));
    b.use(Surface::rubber);
    b.tube(cable, 0.012f, 5);
    for (uint32_t i = 0; i < bulbs; ++i) {
        const Glow colour = colourful ? mix[i % mix.size()] : Glow::warm_white;
        const glm::vec3 p = at((static_cast<float>(i) + 0.5f) / static_cast<float>(bulbs)) - glm::vec3(0, 0.07f, 0);
        b.use(colour);
        b.gem(p, 0.045f);
        plan.bulbs.push_back({p - glm::vec3(0, 0.1f, 0), glow_colour(colour)});
    }
    plan.build(b, "string of lights", from);
}

} // namespace

void add_strings(Plan& plan) {
    constexpr float wall = house_line - 0.02f;
    bool colourful = false;
    for (float z = 1; z > street_far + 12; z -= 10) {
        if (std::abs(z - cross_z) < cross_line)
            continue;
        // One statement each: the order in which a call's arguments are drawn is unspecified.
        const float lean = plan.uniform(-3, 3);
        const float left_end = plan.uniform(7.4f, 8.4f), right_end = plan.uniform(7.4f, 8.4f);
        const float sag = plan.uniform(0.9f, 1.4f);
        garland(plan, {-wall, left_end, z}, {wall, right_end, z + lean}, sag, colourful);
        colourful = !colourful;
    }
    for (const float x : {-24.0f, -38.0f, 24.0f, 38.0f})
        garland(plan, {x, 8.4f, cross_z - cross_line + 0.02f}, {x + 2, 8.4f, cross_z + cross_line - 0.02f}, 1.3f, true);
}

} // namespace prelight::city
