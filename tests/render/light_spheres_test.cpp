// Lights tested many at once are those that a test of one after the other finds.
#include <gtest/gtest.h>
#include <prelight/glm_defaults.hpp>
#include <resident/light_spheres.hpp>
#include <scene/procedural/random.hpp>

namespace prelight::resident {
namespace {

std::vector<PlacedLight> some_lights(size_t count) {
    Random random(11);
    std::vector<PlacedLight> lights(count);
    for (PlacedLight& placed : lights) {
        placed.position = {random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
        placed.light.kind = static_cast<LightKind>(random.below(3));
        placed.light.intensity = random.below(8) ? 1.0f : 0.0f;
        placed.light.range =
            random.below(6) ? static_cast<float>(random.uniform(0.1, 4)) : std::numeric_limits<float>::infinity();
        if (random.below(9) == 0)
            placed.light.colour = glm::vec3(0);
    }
    return lights;
}

TEST(LightSpheres, AreTestedTogetherAsOneByOne) {
    const std::vector<PlacedLight> lights = some_lights(700);
    LightSpheres spheres;
    spheres.assign(lights);
    const glm::dvec3 eye(0.3, -0.2, 0.7);
    SphereView view{.forward = {0, 0, -1}, .across = 0.4};
    for (const glm::dvec3 normal : {glm::dvec3(0.8, 0, -0.6), glm::dvec3(-0.8, 0, -0.6), glm::dvec3(0, 0, -1)})
        view.planes[view.plane_count++] = glm::dvec4(normal, -0.1);
    for (const bool perspective : {true, false}) {
        view.perspective = perspective;
        size_t shown = 0, hidden = 0;
        SphereBatch batch;
        for (size_t first = 0; first < lights.size(); first += sphere_batch) {
            const size_t count = std::min(sphere_batch, lights.size() - first);
            test_spheres(spheres, first, count, eye, view, batch);
            for (size_t i = 0; i < count; ++i) {
                const PlacedLight& placed = lights[first + i];
                const bool dark = placed.light.intensity == 0 || placed.light.colour == glm::vec3(0);
                const glm::dvec3 centre = placed.position - eye;
                const double radius = placed.light.range;
                bool misses = dark;
                for (size_t p = 0; p < view.plane_count && has_volume(placed.light); ++p)
                    misses |= glm::dot(glm::dvec3(view.planes[p]), centre) + view.planes[p].w < -radius;
                EXPECT_EQ(batch.shows[i] != 0, !misses) << first + i;
                ++(misses ? hidden : shown);
                if (misses || !has_volume(placed.light))
                    continue;
                const double depth = -centre.z, distance2 = perspective ? depth * depth - radius * radius : 1;
                const double share = std::min(0.785 * radius * radius / (view.across * distance2), 1.0);
                EXPECT_EQ(batch.share[i], perspective && depth <= radius ? 1 : share) << first + i;
            }
        }
        EXPECT_GT(shown, 100u);
        EXPECT_GT(hidden, 100u);
    }
}

} // namespace
} // namespace prelight::resident
