#include "random_scene.hpp"
#include <scene/procedural/random.hpp>
#include <shared/normal_encoding.h>

namespace prelight {

Primitive cube() {
    Primitive out;
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        const float sign = face % 2 ? -1.0f : 1.0f;
        const auto first = static_cast<uint32_t>(out.positions.size());
        for (int corner = 0; corner < 4; ++corner) {
            const float u = corner == 1 || corner == 2 ? 1.0f : -1.0f, v = corner >= 2 ? 1.0f : -1.0f;
            glm::vec3 p(0), n(0);
            p[axis] = n[axis] = sign;
            p[(axis + 1) % 3] = u * sign;
            p[(axis + 2) % 3] = v;
            out.positions.push_back(p);
            out.normals.push_back(n);
        }
        for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u})
            out.indices.push_back(first + i);
    }
    return out;
}

RandomScene::RandomScene(uint64_t seed) {
    Random random(seed * 7919 + 1);
    const auto number = [&](double low, double high) { return random.uniform(low, high); };
    const auto material = [&] {
        const glm::vec3 colour = hue_colour(number(0, 1), number(0, 0.9));
        add_material({.name = "random",
                      .base_colour = glm::vec4(colour * static_cast<float>(number(0.2, 1)), 1),
                      .metallic = random.below(3) == 0 ? 1.0f : 0.0f,
                      .roughness = shared::roughness_decode(static_cast<float>(140 + random.below(116)) / 255)});
    };
    material();
    add(square(8), glm::rotate(glm::dmat4(1), -1.5707963267948966, {1, 0, 0}));
    for (uint32_t i = 0, count = 4 + random.below(7); i < count; ++i) {
        material();
        glm::dmat4 m = glm::translate(glm::dmat4(1), {number(-4, 4), number(0.2, 2.5), number(-4, 4)});
        m = glm::rotate(m, number(0, 6.28), glm::normalize(glm::dvec3(number(-1, 1), number(0.1, 1), number(-1, 1))));
        const glm::dvec3 size(number(0.4, 1.2), number(0.4, 1.2), number(0.4, 1.2));
        add(random.below(2) ? sphere(48) : cube(), glm::scale(m, size * glm::dvec3(random.below(4) ? 1 : -1, 1, 1)));
    }
    for (uint32_t i = 0, count = 1 + random.below(24); i < count; ++i) {
        const uint32_t kind = random.below(8);
        const double range = kind == 7 ? INFINITY : number(0.8, 7);
        const double outer = number(0.1, 1.55);
        Light light{.kind = kind == 0   ? LightKind::directional
                            : kind <= 3 ? LightKind::spot
                                        : LightKind::point,
                    .colour = hue_colour(number(0, 1), 0.7),
                    .intensity = static_cast<float>(kind == 0 || kind == 7 ? number(0.2, 1) : range * range / 3),
                    .range = kind == 0 ? std::numeric_limits<float>::infinity() : static_cast<float>(range),
                    .inner_cone = static_cast<float>(outer * number(0, 0.9)),
                    .outer_cone = static_cast<float>(outer)};
        add_light(light, {number(-5, 5), number(0.1, 4), number(-5, 5)},
                  glm::normalize(glm::dvec3(number(-1, 1), number(-1, 0.1), number(-1, 1))));
    }
    Camera lens{.yfov = number(0.4, 1.3), .znear = number(0.01, 0.5)};
    if (random.below(2))
        lens.zfar = number(30, 200);
    if (random.below(4) == 0)
        lens = {.kind = ProjectionKind::orthographic, .ymag = number(2, 4), .znear = 0, .zfar = 60};
    const double turn = number(0, 6.28), distance = number(3, 9);
    camera = look_at(lens, {distance * std::cos(turn), number(1, 6), distance * std::sin(turn)}, {0, 0.4, 0});
    world.ambient = {0.02f, 0.02f, 0.03f};
}

} // namespace prelight
