// Emitters: particles as a closed form of time.
#include <cmath>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <prelight/error.hpp>
#include <scene/emit.hpp>
#include <scene/procedural/builder.hpp>

namespace prelight {
namespace {

glm::dmat4 tilted() { return glm::rotate(translation({3, 2, -1}), 0.7, glm::normalize(glm::dvec3(1, 2, 0.5))); }

double age_of(const Emitter& e, const Particle& p) { return p.share * static_cast<double>(e.lifetime_from); }

/// An emitter whose particles all live equally long: their age follows from their share.
Emitter even(float lifetime) { return {.count = 50, .seed = 7, .lifetime_from = lifetime, .lifetime_to = lifetime}; }

TEST(Emitter, ThrowsIntoItsConeWithItsSpeeds) {
    Emitter e = even(2);
    e.cone = 0.4f;
    e.gravity = 0;
    e.speed_from = 1, e.speed_to = 3;
    const glm::dvec3 axis = -glm::dvec3(tilted()[2]);
    double slowest = 9, fastest = 0, widest = 0;
    for (uint32_t i = 0; i < 2000; ++i) {
        const Particle p = particle_at(e, tilted(), i, 5.3);
        const glm::dvec3 way = p.position - glm::dvec3(tilted()[3]);
        const double speed = glm::length(p.velocity), angle = std::acos(glm::dot(axis, p.velocity) / speed);
        EXPECT_NEAR(glm::length(way - p.velocity * age_of(e, p)), 0, 1e-9);
        slowest = std::min(slowest, speed), fastest = std::max(fastest, speed), widest = std::max(widest, angle);
    }
    EXPECT_NEAR(slowest, 1, 0.01);
    EXPECT_NEAR(fastest, 3, 0.01);
    EXPECT_LE(widest, 0.4 + 1e-6);
    EXPECT_GT(widest, 0.39);
}

/// The same flight in steps of 20 µs (Heun's method), from where a twin without any force shows the start.
Particle in_steps(const Emitter& e, const glm::dmat4& node, uint32_t number, double time) {
    const Particle end = particle_at(e, node, number, time);
    Emitter free = e;
    free.gravity = free.drag = 0;
    free.ground.reset();
    Particle p = particle_at(free, node, number, time);
    const double age = age_of(e, end);
    p.position -= p.velocity * age;
    const int steps = 1 + static_cast<int>(age / 2e-5);
    const double dt = age / steps;
    const auto force = [&](glm::dvec3 v) {
        return glm::dvec3(0, -static_cast<double>(e.gravity), 0) - static_cast<double>(e.drag) * v;
    };
    for (int i = 0; i < steps; ++i) {
        const glm::dvec3 a = force(p.velocity), guess = p.velocity + a * dt, b = force(guess);
        p.position += 0.5 * dt * (p.velocity + guess);
        p.velocity += 0.5 * dt * (a + b);
        if (e.ground && p.position.y < *e.ground && p.velocity.y < 0) {
            p.position.y = 2 * *e.ground - p.position.y;
            p.velocity = {p.velocity.x * e.slip, -p.velocity.y * e.bounce, p.velocity.z * e.slip};
        }
    }
    return p;
}

TEST(Emitter, ClosedFormsAreWhatSmallStepsGive) {
    Emitter dragged = even(2);
    dragged.drag = 1.7f;
    Emitter smoke = even(3);
    smoke.gravity = -1.5f;
    smoke.drag = 0.3f;
    Emitter bouncing = even(1.6f);
    bouncing.ground = 0.25f;
    bouncing.bounce = 0.6f;
    bouncing.radius = 0.3f;
    int bounced = 0;
    for (const Emitter& e : {dragged, smoke, bouncing})
        for (uint32_t i = 0; i < 40; ++i) {
            const Particle p = particle_at(e, tilted(), i, 11.2), steps = in_steps(e, tilted(), i, 11.2);
            EXPECT_NEAR(glm::length(p.position - steps.position), 0, 1e-3) << "particle " << i;
            if (e.ground) {
                EXPECT_GE(p.position.y, *e.ground - 1e-6);
                bounced += p.velocity.y > 0.1 && p.share > 0.45;
            }
        }
    EXPECT_GT(bounced, 3);
}

TEST(Emitter, WhatNeverBouncesLiesStill) {
    Emitter e = even(5);
    e.ground = 0;
    e.bounce = 0;
    for (uint32_t i = 0; i < 50; ++i) {
        const Particle p = particle_at(e, translation({0, 0.5, 0}), i, 3);
        if (p.share > 0.5) {
            EXPECT_EQ(p.position.y, 0);
            EXPECT_EQ(p.velocity, glm::dvec3(0));
        }
    }
}

TEST(Emitter, BeginsAnewWithAnotherThrow) {
    Emitter e = even(1);
    const Particle first = particle_at(e, tilted(), 4, 0), again = particle_at(e, tilted(), 4, 1);
    EXPECT_EQ(again.life, first.life + 1);
    EXPECT_NEAR(again.share, first.share, 1e-12);
    EXPECT_GT(glm::length(again.velocity - first.velocity), 1e-3);
    EXPECT_EQ(particle_at(e, tilted(), 4, -1).life, first.life - 1) << "time before the start";
    e.colours = {{4, 2, 0}, {2, 1, 0}, {0, 0, 0}};
    EXPECT_EQ(particle_colour(e, 0.25), glm::vec3(3, 1.5f, 0));
    EXPECT_EQ(particle_colour(e, 0.5), glm::vec3(2, 1, 0));
}

struct Fountain {
    Scene scene;
    Fountain() {
        scene.name = "fountain";
        scene.scenes = {{.name = "fountain", .nodes = {}}};
        scene.materials = {{.name = "spark", .unlit = true}};
        add_light(scene, {.name = "lamp"}, {0, 5, 0});
        scene.emitters = {{.count = 30,
                           .seed = 3,
                           .colours = {{5, 4, 3}, {1, 0, 0}},
                           .intensity = 2,
                           .range = 1.5f,
                           .size = 0.02f,
                           .streak = 0.02f}};
        add_root(scene, "fountain", tilted()).emitter = 0;
    }
};

TEST(Emitter, IsLightsAndShapesOfTheWorld) {
    const Fountain fountain;
    const World world = resolve(fountain.scene, {}, Moment{2.5});
    ASSERT_EQ(world.lights.size(), 31u);
    EXPECT_EQ(world.lights[0].light.name, "lamp") << "lights of nodes come first";
    ASSERT_EQ(world.instances.size(), 1u);
    const Primitive& shapes = world.mesh_of(world.instances[0]).primitives.at(0);
    EXPECT_EQ(world.triangles, 30u * 8);
    EXPECT_EQ(shapes.positions.size(), 30u * 6);
    for (uint32_t i = 0; i < 30; ++i) {
        const Particle p = particle_at(fountain.scene.emitters[0], tilted(), i, 2.5);
        const PlacedLight& light = world.lights[i + 1];
        EXPECT_EQ(light.position, p.position);
        EXPECT_EQ(light.light.range, 1.5f);
        EXPECT_FALSE(light.light.casts_shadow);
        EXPECT_EQ(light.light.colour, particle_colour(fountain.scene.emitters[0], p.share));
        EXPECT_LE(shapes.colours[6 * i].r, 1);
        EXPECT_NEAR(shapes.texcoords[0][6 * i].x, p.share, 1e-6);
        for (int c = 0; c < 6; ++c) {
            const glm::dvec3 corner =
                glm::dvec3(world.instances[0].transform * glm::dvec4(shapes.positions[6 * i + c], 1));
            EXPECT_TRUE(glm::all(glm::lessThanEqual(world.bounds_min, corner)) &&
                        glm::all(glm::lessThanEqual(corner, world.bounds_max)));
            // One interval earlier it was where its velocity says.
            const glm::dvec3 moved = glm::dvec3(shapes.positions[6 * i + c] - shapes.previous_positions[6 * i + c]);
            if (p.share > 0.1) { // else it may have begun in between, and has not moved
                EXPECT_NEAR(glm::length(moved - p.velocity / 60.0), 0, 0.01);
            }
        }
        // Outward faces: the volume is positive.
        double volume = 0;
        for (int t = 0; t < 8; ++t) {
            const auto at = [&](int k) {
                return glm::dvec3(shapes.positions[shapes.indices[24 * i + 3 * t + k]]) -
                       (p.position - glm::dvec3(tilted()[3]));
            };
            volume += glm::dot(at(0), glm::cross(at(1), at(2)));
        }
        EXPECT_GT(volume, 0);
    }
}

TEST(Emitter, BillboardsAreSquaresAroundTheirParticles) {
    Fountain fountain;
    Emitter& e = fountain.scene.emitters[0];
    e.shape = ParticleShape::billboard;
    e.lights = false;
    e.sizes = {1, 3};
    e.opacities = {0, 1, 0};
    e.spin = 2;
    const World world = resolve(fountain.scene, {}, Moment{2.5});
    EXPECT_EQ(world.lights.size(), 1u) << "the lamp alone";
    EXPECT_EQ(world.triangles, 30u * 2);
    const Primitive& shapes = world.mesh_of(world.instances.at(0)).primitives.at(0);
    ASSERT_EQ(shapes.facing.size(), 30u * 4);
    for (uint32_t i = 0; i < 30; ++i) {
        const Particle p = particle_at(e, tilted(), i, 2.5);
        const double size = 0.02 * (1 + 2 * p.share), area = size * size * 4;
        glm::dvec2 middle(0);
        double twice = 0; // the area, counter-clockwise
        for (uint32_t c = 0; c < 4; ++c) {
            const glm::dvec2 a = shapes.facing[4 * i + c], b = shapes.facing[4 * i + (c + 1) % 4];
            middle += a;
            twice += a.x * b.y - a.y * b.x;
            EXPECT_NEAR(glm::length(glm::dvec3(shapes.positions[4 * i + c]) - (p.position - glm::dvec3(tilted()[3]))),
                        0, 1e-6);
            EXPECT_NEAR(shapes.colours[4 * i + c].a, 1 - std::abs(2 * p.share - 1), 1e-6);
            const glm::dvec3 place(world.instances[0].transform * glm::dvec4(shapes.positions[4 * i + c], 1));
            EXPECT_TRUE(glm::all(glm::lessThanEqual(world.bounds_min + size, place + 1e-6)) &&
                        glm::all(glm::lessThanEqual(place + size, world.bounds_max + 1e-6)));
        }
        EXPECT_NEAR(glm::length(middle), 0, 1e-7);
        EXPECT_NEAR(twice / 2, area, 1e-6);
        // The tangent is where the picture's u grows.
        const glm::dvec2 along = glm::dvec2(shapes.facing[4 * i + 1] - shapes.facing[4 * i]) / (2 * size);
        EXPECT_NEAR(glm::length(along - glm::dvec2(shapes.tangents[4 * i])), 0, 1e-5);
    }
    const World later = resolve(fountain.scene, {}, Moment{2.51});
    const Primitive& turned = later.mesh_of(later.instances.at(0)).primitives.at(0);
    EXPECT_NE(turned.tangents, shapes.tangents) << "they turn";
}

TEST(Emitter, AnyFrameByItselfAndByItsSeed) {
    Fountain fountain;
    const World a = resolve(fountain.scene, {}, Moment{0.4}), b = resolve(fountain.scene, {}, Moment{0.4});
    fountain.scene.emitters[0].seed = 4;
    const World other = resolve(fountain.scene, {}, Moment{0.4});
    size_t same = 0;
    for (size_t i = 1; i < a.lights.size(); ++i) {
        EXPECT_EQ(a.lights[i].position, b.lights[i].position);
        same += a.lights[i].position == other.lights[i].position;
    }
    EXPECT_EQ(same, 0u);
    const World rest = resolve(fountain.scene), zero = resolve(fountain.scene, {}, Moment{0});
    EXPECT_EQ(rest.lights[5].position, zero.lights[5].position);
    fountain.scene.emitters[0].colours.clear();
    EXPECT_THROW(resolve(fountain.scene), Error);
}

TEST(PlacedDecals, LieInTheirOrderAndMoveWithTheirNodes) {
    Fountain fountain;
    Scene& scene = fountain.scene;
    for (const int order : {2, -1, 2, 0}) {
        add_root(scene, "decal", translation({order, 0, 0})).decal = static_cast<uint32_t>(scene.decals.size());
        scene.decals.push_back({.opacity = 0.1f * static_cast<float>(scene.decals.size() + 1), .order = order});
    }
    add_root(scene, "flat", glm::scale(glm::dmat4(1), glm::dvec3(1, 0, 1))).decal = 0;
    scene.nodes[2].trs = Trs{};
    scene.animations = {
        {.name = "move", .samplers = {{.times = {0, 2}, .values = {0, 0, 0, 8, 4, 0}}}, .channels = {{.node = 2}}}};
    const World world = resolve(scene, {}, Moment{0.5});
    ASSERT_EQ(world.decals.size(), 4u) << "a flat box holds nothing";
    EXPECT_EQ(world.decals[0].decal.order, -1);
    EXPECT_EQ(world.decals[1].decal.order, 0);
    EXPECT_EQ(world.decals[2].decal.opacity, 0.1f) << "among equals in the order of nodes";
    EXPECT_EQ(glm::dvec3(world.decals[2].transform[3]), glm::dvec3(2, 1, 0)) << "a quarter of the way";
}

} // namespace
} // namespace prelight
