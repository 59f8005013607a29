#include <algorithm>
#include <cmath>
#include <prelight/vary.hpp>
#include <scene/procedural/random.hpp>
#include <scene/tangents.hpp>

namespace prelight {

void rotate_lights(std::span<PlacedLight> lights, glm::dvec3 centre, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const auto turned = [&](glm::dvec3 v) { return glm::dvec3(c * v.x + s * v.z, v.y, c * v.z - s * v.x); };
    for (PlacedLight& light : lights) {
        light.position = centre + turned(light.position - centre);
        light.direction = turned(light.direction);
        light.up = turned(light.up);
    }
}

void randomize_lights(std::span<PlacedLight> lights, uint64_t seed) {
    constexpr double pi = 3.14159265358979323846;
    // 8 = count · (4/3 π r³) / (10 m)³
    const double unranged =
        std::cbrt(8 * 1000 / (4.0 / 3 * pi * static_cast<double>(std::max<size_t>(lights.size(), 8))));
    Random random(seed);
    for (PlacedLight& placed : lights) {
        const double before = placed.light.range < 1e9f ? placed.light.range : unranged; // range² is finite
        const double range = before * std::exp2(random.uniform(-1, 1));
        const double hue = random.unit(), outer = random.uniform(0.3, 1.2), inner = outer * random.unit();
        const double turn = random.uniform(0, 2 * pi), down = random.uniform(0.2, 1);
        placed.light = {.name = placed.light.name,
                        .kind = random.below(2) == 0 ? LightKind::point : LightKind::spot,
                        .colour = hue_colour(hue, 0.8),
                        .intensity = static_cast<float>(range * range / 2),
                        .range = static_cast<float>(range),
                        .inner_cone = static_cast<float>(inner),
                        .outer_cone = static_cast<float>(outer)};
        const double across = std::sqrt(1 - down * down);
        placed.direction = {across * std::cos(turn), -down, across * std::sin(turn)};
    }
}

void cycle_materials(Scene& scene) {
    const auto count = static_cast<uint32_t>(scene.materials.size());
    for (Mesh& mesh : scene.meshes)
        for (Primitive& primitive : mesh.primitives) {
            const TextureRef& before = scene.materials[primitive.material].normal_texture;
            primitive.material = (primitive.material + 1) % count;
            const TextureRef& normals = scene.materials[primitive.material].normal_texture;
            const bool mapped = normals && !primitive.texcoords[normals.texcoord].empty();
            if (mapped && (primitive.tangents.empty() || !share_tangents(before, normals)))
                generate_tangents(primitive, normals);
        }
}

} // namespace prelight
