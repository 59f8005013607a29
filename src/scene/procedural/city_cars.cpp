#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <scene/procedural/city_plan.hpp>
#include <scene/procedural/city_textures.hpp>

namespace prelight::city {
namespace {

/// Cross-section of a body at `z` (the front is at −z): half width, lower and upper edge. Metres.
struct Station {
    float z, half, low, high;
};

/// A cabin: a truncated pyramid of windows below a roof.
struct Cabin {
    float front, rear, half; ///< at the belt line, y = 0.9
    float roof_front, roof_rear, roof_half, roof;
};

struct Shape {
    std::vector<Station> stations;
    Cabin cabin;
    float front_axle, rear_axle, wheel; ///< z of the axles, radius
};

Shape saloon() {
    return {{{-2.25f, 0.70f, 0.36f, 0.58f},
             {-2.21f, 0.78f, 0.28f, 0.66f},
             {-2.05f, 0.86f, 0.22f, 0.72f},
             {-1.60f, 0.90f, 0.20f, 0.80f},
             {-0.90f, 0.91f, 0.20f, 0.90f},
             {0, 0.92f, 0.20f, 0.94f},
             {1.20f, 0.92f, 0.20f, 0.96f},
             {1.80f, 0.90f, 0.20f, 0.96f},
             {2.12f, 0.86f, 0.24f, 0.93f},
             {2.24f, 0.80f, 0.30f, 0.88f},
             {2.28f, 0.72f, 0.38f, 0.80f}},
            {-1.0f, 1.75f, 0.80f, -0.15f, 1.05f, 0.62f, 1.43f},
            -1.40f,
            1.38f,
            0.32f};
}

Shape van() {
    return {{{-2.35f, 0.74f, 0.38f, 0.70f},
             {-2.31f, 0.84f, 0.28f, 0.80f},
             {-2.10f, 0.92f, 0.24f, 0.92f},
             {-1.70f, 0.95f, 0.22f, 1.02f},
             {-0.90f, 0.96f, 0.22f, 1.08f},
             {0.6f, 0.96f, 0.22f, 1.10f},
             {1.90f, 0.96f, 0.22f, 1.10f},
             {2.30f, 0.93f, 0.26f, 1.08f},
             {2.36f, 0.86f, 0.32f, 1.02f}},
            {-1.65f, 2.30f, 0.88f, -0.85f, 2.15f, 0.74f, 1.92f},
            -1.50f,
            1.52f,
            0.34f};
}

/// From the right sill over the top to the left sill.
std::vector<glm::vec3> section(const Station& s) {
    const float h = s.high - s.low;
    const std::array<glm::vec2, 6> right{
        {{0.90f, 0}, {0.99f, 0.18f}, {1, 0.55f}, {0.97f, 0.86f}, {0.86f, 0.985f}, {0.45f, 1.02f}}};
    std::vector<glm::vec3> points;
    for (const glm::vec2& p : right)
        points.emplace_back(p.x * s.half, s.low + p.y * h, s.z);
    for (size_t i = right.size(); i-- > 0;)
        points.emplace_back(-right[i].x * s.half, s.low + right[i].y * h, s.z);
    return points;
}

void body(MeshBuilder& b, const Shape& shape) {
    std::vector<glm::vec3> points;
    for (const Station& s : shape.stations) {
        const auto ring = section(s);
        points.insert(points.end(), ring.begin(), ring.end());
    }
    const auto columns = static_cast<uint32_t>(section(shape.stations[0]).size());
    b.patch(points, columns);
    const auto rear = section(shape.stations.back());
    auto front = section(shape.stations.front());
    std::reverse(front.begin(), front.end());
    b.polygon(rear);
    b.polygon(front);
}

/// A flat four-sided panel p0 p1 p2 p3 (counter-clockwise from outside) as a grid of cells: glass
/// where neither index is even, paint elsewhere.
void panel(MeshBuilder& b, const std::array<glm::vec3, 4>& p, const std::vector<float>& us,
           const std::vector<float>& vs, glm::vec3 paint) {
    const auto at = [&](float u, float v) { return glm::mix(glm::mix(p[0], p[1], u), glm::mix(p[3], p[2], u), v); };
    for (size_t j = 0; j + 1 < vs.size(); ++j)
        for (size_t i = 0; i + 1 < us.size(); ++i) {
            if (i % 2 == 1 && j % 2 == 1)
                b.use(Surface::car_glass);
            else
                b.use(Surface::car_paint, paint);
            b.polygon(
                std::array{at(us[i], vs[j]), at(us[i + 1], vs[j]), at(us[i + 1], vs[j + 1]), at(us[i], vs[j + 1])});
        }
}

void cabin(MeshBuilder& b, const Cabin& c, glm::vec3 paint) {
    constexpr float belt = 0.88f;
    const glm::vec3 fr(c.half, belt, c.front), fl(-c.half, belt, c.front), rr(c.half, belt, c.rear),
        rl(-c.half, belt, c.rear), tfr(c.roof_half, c.roof, c.roof_front), tfl(-c.roof_half, c.roof, c.roof_front),
        trr(c.roof_half, c.roof, c.roof_rear), trl(-c.roof_half, c.roof, c.roof_rear);
    const std::vector<float> v{0, 0.12f, 0.90f, 1}, screen{0, 0.06f, 0.94f, 1}, sides{0, 0.16f, 0.50f, 0.54f, 0.84f, 1};
    panel(b, {fr, fl, tfl, tfr}, screen, v, paint);
    panel(b, {rl, rr, trr, trl}, screen, v, paint);
    panel(b, {rr, fr, tfr, trr}, sides, v, paint);
    panel(b, {fl, rl, trl, tfl}, sides, v, paint);
    constexpr uint32_t n = 7;
    std::vector<glm::vec3> roof;
    for (uint32_t row = 0; row < n; ++row)
        for (uint32_t column = 0; column < n; ++column) {
            const float u = static_cast<float>(column) / (n - 1), w = static_cast<float>(row) / (n - 1);
            glm::vec3 p = glm::mix(glm::mix(tfr, tfl, u), glm::mix(trr, trl, u), w);
            p.y += 0.9f * u * (1 - u) * w * (1 - w);
            roof.push_back(p);
        }
    b.use(Surface::car_paint, paint);
    b.patch(roof, n);
}

void wheels(MeshBuilder& b, const Shape& shape) {
    const float side = shape.stations[shape.stations.size() / 2].half, r = shape.wheel;
    for (const float z : {shape.front_axle, shape.rear_axle})
        for (const float sign : {-1.0f, 1.0f}) {
            const auto x = [&](float at) { return sign * (side + at); };
            b.use(Surface::rubber);
            b.cone({x(-0.3f), r + 0.06f, z}, {x(0.006f), r + 0.06f, z}, r + 0.05f, r + 0.05f, 28);
            b.cone({x(-0.2f), r, z}, {x(0.018f), r, z}, r, r, 28, false);
            b.cone({x(0.018f), r, z}, {x(0.03f), r, z}, r, r * 0.9f, 28);
            b.use(Surface::board, glm::vec3(0.45f));
            b.cone({x(0.02f), r, z}, {x(0.036f), r, z}, r * 0.66f, r * 0.60f, 20);
            b.use(Surface::rubber);
            for (uint32_t i = 0; i < 5; ++i) { // gaps between the spokes
                const float a = 2 * pi * static_cast<float>(i) / 5;
                const glm::vec3 c(x(0.03f), r + 0.40f * r * std::cos(a), z + 0.40f * r * std::sin(a));
                b.cone(c, c + glm::vec3(sign * 0.012f, 0, 0), r * 0.12f, r * 0.12f, 8);
            }
        }
}

/// `lit`: head lights shine, tail lights glow.
Mesh make_car(const Shape& shape, glm::vec3 paint, bool lit, bool taxi) {
    MeshBuilder b;
    b.use(Surface::car_paint, paint);
    body(b, shape);
    cabin(b, shape.cabin, paint);
    wheels(b, shape);
    const Station& nose = shape.stations[2];
    const Station& tail = shape.stations[shape.stations.size() - 2];
    const float front = shape.stations.front().z, rear = shape.stations.back().z;
    b.use(Surface::rubber); // underbody, grille, bumper line
    b.box({-0.78f, 0.14f, front + 0.35f}, {0.78f, 0.42f, rear - 0.35f});
    b.box({-0.42f, 0.40f, front - 0.015f}, {0.42f, 0.52f, front + 0.1f});
    b.box({-0.74f, 0.34f, rear - 0.1f}, {0.74f, 0.46f, rear + 0.03f});
    for (const float sign : {-1.0f, 1.0f}) { // sills between the wheels, lines below the windows
        const float x = sign * (shape.stations[shape.stations.size() / 2].half - 0.03f);
        b.box({x - 0.05f, 0.17f, shape.front_axle + 0.4f}, {x + 0.05f, 0.29f, shape.rear_axle - 0.4f});
        const float line = sign * shape.cabin.half;
        b.box({line - 0.02f, 0.90f, shape.cabin.front + 0.12f}, {line + 0.02f, 0.925f, shape.cabin.rear - 0.1f});
    }
    b.use(Surface::chrome);
    b.box({-0.46f, 0.525f, front - 0.02f}, {0.46f, 0.545f, front + 0.1f});
    b.use(Surface::board, glm::vec3(0.6f));
    b.box({-0.26f, 0.50f, rear - 0.05f}, {0.26f, 0.61f, rear + 0.012f});
    for (const float sign : {-1.0f, 1.0f}) {
        if (lit)
            b.use(Glow::cool_white);
        else
            b.use(Surface::chrome);
        b.sphere({sign * 0.64f, nose.high - 0.09f, nose.z - 0.09f}, {0.15f, 0.065f, 0.12f}, 16, 10);
        if (lit)
            b.use(Glow::red);
        else
            b.use(Surface::board, {0.25f, 0.01f, 0.01f});
        b.box({sign * 0.62f - 0.13f, tail.high - 0.20f, tail.z - 0.1f},
              {sign * 0.62f + 0.13f, tail.high - 0.09f, rear + 0.015f});
        b.use(Surface::car_paint, paint);
        b.sphere({sign * (shape.cabin.half + 0.16f), 0.98f, shape.cabin.front + 0.42f}, {0.11f, 0.07f, 0.06f}, 12, 8);
    }
    if (taxi) {
        b.use(Glow::yellow);
        b.box({-0.22f, shape.cabin.roof + 0.04f, 0.35f}, {0.22f, shape.cabin.roof + 0.20f, 0.50f});
    }
    return b.finish(lit ? "car, lights on" : "parked car");
}

/// The lights of a car at `position` with its front turned by `yaw`.
void car_lights(Plan& plan, const Shape& shape, glm::vec3 position, float yaw) {
    const glm::vec3 forward(-std::sin(yaw), 0, -std::cos(yaw)), right(std::cos(yaw), 0, -std::sin(yaw));
    const auto point = [&](float x, float y, float z) {
        return position + x * right + glm::vec3(0, y, 0) - z * forward;
    };
    for (const float sign : {-1.0f, 1.0f}) {
        const glm::vec3 aim = glm::normalize(forward + sign * 0.03f * right - glm::vec3(0, 0.075f, 0));
        plan.add_site(Rank::head, {.light = {.kind = LightKind::spot,
                                             .colour = glow_colour(Glow::cool_white),
                                             .intensity = 170,
                                             .range = 32,
                                             .inner_cone = 0.10f,
                                             .outer_cone = 0.42f},
                                   .position = point(sign * 0.64f, 0.63f, shape.stations[0].z - 0.1f),
                                   .direction = aim});
        plan.add_point(Rank::tail, point(sign * 0.62f, 0.75f, shape.stations.back().z + 0.9f), glow_colour(Glow::red),
                       2.0f, 5);
    }
}

struct Parked {
    float x, z, yaw;
};

} // namespace

void add_cars(Plan& plan) {
    static constexpr std::array<glm::vec3, 6> paints{{{0.42f, 0.015f, 0.012f},
                                                      {0.02f, 0.05f, 0.20f},
                                                      {0.45f, 0.46f, 0.48f},
                                                      {0.012f, 0.013f, 0.015f},
                                                      {0.04f, 0.14f, 0.11f},
                                                      {0.75f, 0.40f, 0.02f}}};
    const std::array<Shape, 2> shapes{saloon(), van()};
    std::array<uint32_t, 8> driving{}, standing{};
    for (uint32_t i = 0; i < driving.size(); ++i) {
        const Shape& shape = shapes[i % 4 == 3 ? 1 : 0];
        driving[i] = plan.add_mesh(make_car(shape, paints[i % paints.size()], true, i == 5));
        standing[i] = plan.add_mesh(make_car(shape, paints[i % (paints.size() - 1)], false, false));
    }
    const std::array<Parked, 14> traffic{{{1.55f, -4, 0},
                                          {-1.6f, -10, pi},
                                          {1.5f, -42, 0},
                                          {-1.5f, -46, pi},
                                          {1.6f, -58, 0},
                                          {-1.6f, -66, pi},
                                          {-1.5f, -86, pi},
                                          {1.5f, -92, 0},
                                          {13.8f, cross_z - 1.9f, pi / 2},
                                          {20.5f, cross_z - 1.8f, pi / 2},
                                          {-14.2f, cross_z + 1.9f, -pi / 2},
                                          {-33, cross_z + 1.8f, -pi / 2},
                                          {36, cross_z + 1.9f, -pi / 2},
                                          {-41, cross_z - 1.9f, pi / 2}}};
    uint32_t next = 5;
    for (const Parked& car : traffic) {
        const uint32_t which = next++ % driving.size();
        const glm::vec3 position(car.x, 0, car.z);
        plan.place(driving[which], position, car.yaw);
        car_lights(plan, shapes[which % 4 == 3 ? 1 : 0], position, car.yaw);
    }
    for (const float side : {-1.0f, 1.0f})
        for (float z = -0.5f; z > street_far + 6; z -= 6) {
            if (std::abs(z - cross_z) < cross_line + 6 || !plan.chance(0.62))
                continue;
            const float yaw = (side > 0 ? 0 : pi) + plan.uniform(-0.03f, 0.03f);
            const uint32_t which = plan.random.below(standing.size());
            const float x = side * plan.uniform(3.9f, 4.0f), shift = plan.uniform(-0.4f, 0.4f);
            plan.place(standing[which], {x, 0, z + shift}, yaw);
        }
}

} // namespace prelight::city
