#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <scene/procedural/city_plan.hpp>
#include <scene/procedural/city_textures.hpp>

namespace prelight::city {
namespace {

constexpr float lamp_height = 6.1f, lamp_arm = 1.9f;

/// A lamp post whose arm reaches to +x.
Mesh lamp_post() {
    MeshBuilder b;
    b.use(Surface::metal);
    b.cone({0, 0, 0}, {0, 0.9f, 0}, 0.13f, 0.11f, 14);
    b.cone({0, 0.9f, 0}, {0, 1.0f, 0}, 0.14f, 0.09f, 14);
    b.cone({0, 1.0f, 0}, {0, 5.4f, 0}, 0.075f, 0.055f, 12);
    b.sphere({0, 5.4f, 0}, glm::vec3(0.08f), 12, 8);
    std::vector<glm::vec3> arm;
    for (uint32_t i = 0; i <= 8; ++i) {
        const float t = static_cast<float>(i) / 8;
        arm.emplace_back(lamp_arm * t, 5.4f + 0.85f * std::sin(t * pi / 2), 0);
    }
    b.tube(arm, 0.04f, 10);
    b.box({lamp_arm - 0.35f, lamp_height + 0.05f, -0.14f}, {lamp_arm + 0.35f, lamp_height + 0.18f, 0.14f});
    b.use(Glow::warm_white);
    b.box({lamp_arm - 0.30f, lamp_height, -0.11f}, {lamp_arm + 0.30f, lamp_height + 0.05f, 0.11f},
          all_faces & ~unsigned{top});
    return b.finish("lamp post");
}

void add_lamps(Plan& plan) {
    const uint32_t mesh = plan.add_mesh(lamp_post());
    const auto lamp = [&](glm::vec3 foot, float yaw, glm::vec3 colour) {
        plan.place(mesh, foot, yaw);
        const glm::vec3 head =
            foot + glm::vec3(lamp_arm * std::cos(yaw), lamp_height - 0.06f, -lamp_arm * std::sin(yaw));
        plan.add_site(Rank::lamp, {.light = {.kind = LightKind::spot,
                                             .colour = colour,
                                             .intensity = 300,
                                             .range = 17,
                                             .inner_cone = 0.55f,
                                             .outer_cone = 1.2f},
                                   .position = head});
    };
    const glm::vec3 sodium(1, 0.62f, 0.30f), led(0.92f, 0.95f, 1);
    for (const float side : {-1.0f, 1.0f})
        for (float z = side > 0 ? 6.5f : 13; z > street_far + 4; z -= 15) {
            if (std::abs(z - cross_z) < cross_half + 3)
                continue;
            lamp({side * (road_half + 0.5f), kerb_height, z}, side > 0 ? pi : 0, sodium);
        }
    for (const float side : {-1.0f, 1.0f})
        for (const float x : {-50.0f, -34.0f, -18.0f, 16.0f, 32.0f, 48.0f})
            lamp({x + side * 2, kerb_height, cross_z + side * (cross_half + 0.5f)}, side > 0 ? pi / 2 : -pi / 2, led);
}

/// A signal at the crossing: post, box, three lenses of which one shines. Faces +d of `frame`.
void signal(Plan& plan, const Frame& frame, bool go) {
    MeshBuilder b;
    b.frame = frame;
    b.use(Surface::metal);
    b.cone({0, 0, 0}, {0, 3.4f, 0}, 0.06f, 0.05f, 12);
    b.box({-0.16f, 2.5f, 0.04f}, {0.16f, 3.5f, 0.26f});
    constexpr std::array<Glow, 3> colours{Glow::green, Glow::amber, Glow::red};
    for (uint32_t i = 0; i < 3; ++i) {
        const bool on = i == (go ? 0u : 2u);
        const glm::vec3 lens(0, 2.67f + 0.32f * static_cast<float>(i), 0.26f);
        if (on)
            b.use(colours[i]);
        else
            b.use(Surface::board, 0.05f * glow_colour(colours[i]));
        b.sphere(lens, {0.11f, 0.11f, 0.04f}, 16, 8);
        b.use(Surface::metal);
        b.box(lens + glm::vec3(-0.13f, 0.115f, 0), lens + glm::vec3(0.13f, 0.13f, 0.16f));
        if (on)
            plan.add_point(Rank::tail, frame.point(lens + glm::vec3(0, 0, 0.7f)), glow_colour(colours[i]), 3.5f, 7);
    }
    plan.build(b, "signal", frame.origin);
}

void add_signals(Plan& plan) {
    const float x = road_half + 0.6f, near_z = cross_z + cross_line + 0.4f, far_z = cross_z - cross_line - 0.4f;
    const auto facing = [](glm::vec3 origin, glm::vec3 d) {
        return Frame{origin, glm::cross(glm::vec3(0, 1, 0), d), {0, 1, 0}, d};
    };
    signal(plan, facing({x, kerb_height, near_z}, {0, 0, 1}), true);
    signal(plan, facing({-x, kerb_height, far_z}, {0, 0, -1}), true);
    signal(plan, facing({-x, kerb_height, near_z}, {0, 0, 1}), true);
    signal(plan, facing({x + 3.0f, kerb_height, far_z + 3.6f}, {1, 0, 0}), false);
    signal(plan, facing({-x - 3.0f, kerb_height, near_z - 3.6f}, {-1, 0, 0}), false);
}

/// A street tree with a string of lights in its crown; bulbs are returned relative to its foot.
Mesh tree(Plan& plan, std::vector<glm::vec3>& bulbs) {
    MeshBuilder b;
    const glm::vec3 centre(0, 4.0f, 0), radii(1.55f, 1.5f, 1.55f);
    b.use(Surface::bark);
    b.cone({0, 0, 0}, {0.05f, 2.6f, 0.03f}, 0.15f, 0.09f, 12);
    for (uint32_t i = 0; i < 7; ++i) {
        const float a = 2 * pi * static_cast<float>(i) / 7, reach = plan.uniform(0.5f, 1.1f);
        b.cone({0.04f, 2.0f + 0.09f * static_cast<float>(i), 0.02f},
               {reach * std::cos(a), plan.uniform(3.4f, 4.6f), reach * std::sin(a)}, 0.05f, 0.012f, 7);
    }
    b.use(Surface::leaves);
    for (uint32_t i = 0; i < 260; ++i) {
        const float y = plan.uniform(-1, 1), a = plan.uniform(0, 2 * pi);
        const float ring = std::sqrt(1 - y * y), depth = plan.uniform(0.55f, 1.0f);
        const glm::vec3 out(ring * std::cos(a), y, ring * std::sin(a));
        // Leaves hang outwards, each turned a little its own way.
        const float lean_x = plan.uniform(-0.7f, 0.7f), lean_z = plan.uniform(-0.7f, 0.7f);
        const glm::vec3 n = glm::normalize(out + glm::vec3(lean_x, 0.5f, lean_z));
        const glm::vec3 u = glm::normalize(glm::cross(glm::vec3(0.3f, 0.2f, 1), n)), v = glm::cross(n, u);
        const float size = plan.uniform(0.38f, 0.62f);
        b.quad(centre + radii * out * depth - (u + v) * (size / 2), u * size, v * size, TexRect{});
    }
    b.use(Glow::warm_white);
    for (uint32_t i = 0; i < 44; ++i) {
        const float t = (static_cast<float>(i) + 0.5f) / 44, y = 1 - 2 * t, a = t * 8.5f * 2 * pi;
        const float ring = std::sqrt(1 - y * y);
        bulbs.push_back(centre + radii * 1.04f * glm::vec3(ring * std::cos(a), y, ring * std::sin(a)));
        b.gem(bulbs.back(), 0.028f);
    }
    b.use(Surface::metal); // grille round the trunk
    b.box({-0.55f, 0.0f, -0.55f}, {0.55f, 0.012f, 0.55f}, all_faces & ~unsigned{bottom});
    return b.finish("tree");
}

void add_trees(Plan& plan) {
    std::array<std::vector<glm::vec3>, 2> bulbs;
    const std::array<uint32_t, 2> meshes{plan.add_mesh(tree(plan, bulbs[0])), plan.add_mesh(tree(plan, bulbs[1]))};
    uint32_t next = 0;
    for (const float side : {-1.0f, 1.0f})
        for (float z = side > 0 ? -1 : 5.5f; z > street_far + 6; z -= 15) {
            if (std::abs(z - cross_z) < cross_line + 2)
                continue;
            const uint32_t which = next++ % 2;
            const glm::vec3 foot(side * (road_half + 0.85f), kerb_height, z);
            plan.place(meshes[which], foot);
            for (const glm::vec3& bulb : bulbs[which])
                plan.bulbs.push_back({foot + bulb, glow_colour(Glow::warm_white)});
        }
}

Mesh bin() {
    MeshBuilder b;
    b.use(Surface::metal);
    b.cone({0, 0, 0}, {0, 0.85f, 0}, 0.20f, 0.24f, 18);
    b.cone({0, 0.85f, 0}, {0, 0.93f, 0}, 0.27f, 0.25f, 18);
    b.use(Surface::rubber);
    b.cone({0, 0.93f, 0}, {0, 0.95f, 0}, 0.14f, 0.10f, 16);
    return b.finish("bin");
}

Mesh bollard() {
    MeshBuilder b;
    b.use(Surface::metal);
    b.cone({0, 0, 0}, {0, 0.85f, 0}, 0.06f, 0.055f, 12);
    b.sphere({0, 0.87f, 0}, {0.075f, 0.06f, 0.075f}, 12, 8);
    b.use(Surface::board, glm::vec3(0.75f));
    b.cone({0, 0.70f, 0}, {0, 0.76f, 0}, 0.0605f, 0.0605f, 12, false);
    return b.finish("bollard");
}

/// Faces +z.
Mesh bench() {
    MeshBuilder b;
    b.use(Surface::wood, glm::vec3(0.75f));
    for (uint32_t i = 0; i < 4; ++i) {
        const float d = 0.12f * static_cast<float>(i);
        b.box({-0.85f, 0.43f, d - 0.2f}, {0.85f, 0.465f, d - 0.11f});
        if (i < 3)
            b.box({-0.85f, 0.55f + d, -0.27f}, {0.85f, 0.64f + d, -0.235f});
    }
    b.use(Surface::metal);
    for (const float x : {-0.65f, 0.61f}) {
        b.box({x, 0, -0.25f}, {x + 0.04f, 0.43f, -0.19f});
        b.box({x, 0, 0.18f}, {x + 0.04f, 0.43f, 0.24f});
        b.box({x, 0.395f, -0.19f}, {x + 0.04f, 0.43f, 0.18f});
        b.box({x, 0.43f, -0.3f}, {x + 0.04f, 0.9f, -0.27f});
    }
    return b.finish("bench");
}

Mesh manhole() {
    MeshBuilder b;
    b.use(Surface::metal); // well above the road's markings
    b.cone({0, -0.01f, 0}, {0, 0.012f, 0}, 0.34f, 0.34f, 28);
    for (int i = -2; i <= 2; ++i) {
        const float z = 0.1f * static_cast<float>(i), half = std::sqrt(0.30f * 0.30f - z * z);
        b.box({-half, 0.010f, z - 0.022f}, {half, 0.018f, z + 0.022f}, all_faces & ~unsigned{bottom});
    }
    return b.finish("manhole");
}

/// Along the kerb from z towards −z: the first place for a bin that is clear of the posts and trees
/// among the nodes from `first` on.
float bin_place(const Scene& scene, size_t first, float x, float z) {
    constexpr double clear = 0.5; // metres between the middles
    const auto taken = [&](const Node& node) {
        return std::hypot(node.local[3].x - double(x), node.local[3].z - double(z)) < clear;
    };
    while (std::any_of(scene.nodes.begin() + static_cast<std::ptrdiff_t>(first), scene.nodes.end(), taken))
        z -= 0.1f;
    return z;
}

} // namespace

void add_props(Plan& plan) {
    const size_t first = plan.scene.nodes.size();
    add_lamps(plan);
    add_signals(plan);
    add_trees(plan);
    const uint32_t bin_mesh = plan.add_mesh(bin()), bollard_mesh = plan.add_mesh(bollard());
    const uint32_t bench_mesh = plan.add_mesh(bench()), manhole_mesh = plan.add_mesh(manhole());
    for (const float side : {-1.0f, 1.0f})
        for (uint32_t i = 0; i < 5; ++i)
            for (const float z : {cross_z + cross_line + 1.2f, cross_z - cross_line - 1.2f}) {
                const float step = 1.3f * static_cast<float>(i) * (z > cross_z ? 1.0f : -1.0f);
                plan.place(bollard_mesh, {side * (road_half + 0.5f), kerb_height, z + step});
            }
    for (const float side : {-1.0f, 1.0f}) {
        for (float z = 3; z > street_far + 8; z -= plan.uniform(16, 24)) {
            if (std::abs(z - cross_z) < cross_line + 1)
                continue;
            const float x = side * (road_half + 0.75f);
            plan.place(bin_mesh, {x, kerb_height, bin_place(plan.scene, first, x, z)});
            plan.place(bench_mesh, {side * (house_line - 0.9f), kerb_height, z - 3}, side < 0 ? pi / 2 : -pi / 2);
        }
    }
    for (float z = 4; z > street_far; z -= 21)
        plan.place(manhole_mesh, {plan.uniform(-1.2f, 1.2f), 0, z});
}

} // namespace prelight::city
