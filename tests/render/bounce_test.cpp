// The scene `bounce`: small lights as fake indirect light, against the reference and against an integral of the true
// one.
#include "against_reference.hpp"
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <prelight/scene_io.hpp>
#include <reference/lighting.hpp>
#include <reference/ray_scene.hpp>
#include <span>

namespace prelight {
namespace {

double luminance(glm::dvec3 c) { return glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722)); }

TEST(Bounce, AgreesWithTheReference) {
    const Scene scene = make_scene("bounce", 65, 1);
    const World world = resolve(scene);
    Shot shot{.world = &world, .camera = world.cameras[0], .width = 240, .height = 135};
    expect_agrees(shot);
    shot.renderer = "deferred";
    expect_agrees(shot);
}

/// Fake indirect light is many small lights that the scene places: with them alone is there light where the sun is not.
TEST(FakeIndirectLight, OfManySmallLightsFillsWhatTheSunDoesNotReach) {
    const Scene scene = make_scene("bounce", 257, 1);
    const World world = resolve(scene);
    ASSERT_EQ(world.lights.size(), 257u);
    EXPECT_EQ(world.lights[0].light.kind, LightKind::directional);
    for (size_t i = 1; i < world.lights.size(); ++i) {
        ASSERT_FALSE(world.lights[i].light.casts_shadow) << "that would be 256 shadow maps";
        ASSERT_LT(world.lights[i].light.intensity, world.lights[0].light.intensity);
    }
    RenderOptions options{.width = 160,
                          .height = 90,
                          .settings = {{"shadows", "on"}, {"light-culling", "tiles"}},
                          .views = {"normal", "linear"}};
    const auto renderer = create_renderer("light-prepass", &test_device(), options);
    renderer->set_world(world);
    renderer->render(world.cameras[0]);
    const Image both = renderer->read("linear"), normal = renderer->read("normal");
    renderer->set_lights(std::span(world.lights).first(1));
    renderer->render(world.cameras[0]);
    const Image sun = renderer->read("linear");
    size_t dark = 0, filled = 0;
    for (size_t i = 0; i < sun.pixels.size(); ++i)
        if (luminance(sun.pixels[i]) < 0.01 &&
            normal.pixels[i].g < 0.99f) { // in the sun's shadow; the lights lie on the floor, which stays dark
            ++dark;
            filled += luminance(both.pixels[i]) > luminance(sun.pixels[i]) + 0.001;
        }
    EXPECT_GT(dark, sun.pixels.size() / 3);
    EXPECT_GT(filled, dark * 9 / 10);
    expect_validation_clean(test_device());
}

/// What reaches points of the room from its surfaces, once reflected.
class OneBounce {
public:
    explicit OneBounce(const World& world)
        : world_(world), textures_(*world.scene, true), rays_(world, glm::dvec3(0), textures_),
          lights_(world, glm::dvec3(0)) {}

    /// W/m² on a surface, by `count` rays that are even under a cosine (a golden spiral on the disc, lifted).
    glm::dvec3 integral(glm::dvec3 at, glm::dvec3 normal, uint32_t count) const {
        const glm::dvec3 side =
            glm::normalize(glm::cross(normal, std::abs(normal.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
        const glm::dvec3 other = glm::cross(normal, side);
        glm::dvec3 sum(0);
        for (uint32_t i = 0; i < count; ++i) {
            const double r = std::sqrt((i + 0.5) / count), angle = 2.399963229728653 * i;
            const glm::dvec3 way =
                r * std::cos(angle) * side + r * std::sin(angle) * other + std::sqrt(1 - r * r) * normal;
            reference::Hit hit;
            if (rays_.closest({at + 1e-4 * normal, way}, hit))
                sum += sunlight(hit, -way);
        }
        return sum * (std::numbers::pi / count);
    }

    /// The same from all lights but the sun: as they are, without shadows; with shadow rays; or as Lambert surfaces
    /// too.
    enum class Kind { plain, shadowed, shadowed_lambert };
    glm::dvec3 virtual_lights(glm::dvec3 at, glm::dvec3 normal, Kind kind) const {
        glm::dvec3 sum(0);
        for (uint32_t i = 1; i < world_.lights.size(); ++i) {
            const reference::Incident light = lights_.incident(i, at);
            double profile = 1;
            if (kind == Kind::shadowed_lambert) { // the cosine in place of min(√2 cos, 1)², for as much light in all
                const double cosine = std::max(glm::dot(world_.lights[i].direction, -light.to_light), 1e-6);
                profile = 2 * (1 - std::sqrt(2.0) / 3) * cosine / std::min(2 * cosine * cosine, 1.0);
            }
            if (kind == Kind::plain || !rays_.blocked({at + 1e-4 * normal, light.to_light, 0, light.distance - 0.005}))
                sum += profile * light.radiance * std::max(glm::dot(normal, light.to_light), 0.0);
        }
        return sum;
    }

private:
    /// What the surface at a hit sends on of the sun, where the sun sees it.
    glm::dvec3 sunlight(const reference::Hit& hit, glm::dvec3 view) const {
        const reference::Surface surface = reference::evaluate_surface(rays_, textures_, hit, view);
        const reference::Incident sun = lights_.incident(0, hit.position);
        reference::Lighting lighting({.fresnel = ReferenceForm::Fresnel::full}, surface);
        if (!lighting.is_lit_by(sun) || rays_.blocked({hit.position + hit.geometric_normal * hit.offset, sun.to_light}))
            return glm::dvec3(0);
        lighting.add(sun);
        return lighting.radiance(glm::dvec3(0));
    }

    const World& world_;
    reference::Textures textures_;
    reference::RayScene rays_;
    reference::LightTree lights_;
};

struct Fake {
    double ratio = 0, off = 0,
           hue = 0; ///< fake ÷ true in all; mean relative difference of irradiance; mean angle of colours, degrees
};

/// Over what the camera sees.
Fake compare_with_integral(uint32_t lights, OneBounce::Kind kind = OneBounce::Kind::plain) {
    const Scene scene = make_scene("bounce", lights + 1, 1);
    const World world = resolve(scene);
    const OneBounce bounce(world);
    const ReferencePicture seen = render_reference(world, world.cameras[0], 32, 18, 0, {});
    double fake_sum = 0, true_sum = 0, off = 0, hue = 0;
    size_t points = 0;
    for (size_t i = 0; i < seen.position.size(); ++i) {
        if (seen.instance[i] == 0xffffffffu)
            continue;
        const glm::dvec3 normal = seen.geometric_normal[i];
        const glm::dvec3 fake = bounce.virtual_lights(seen.position[i], normal, kind),
                         exact = bounce.integral(seen.position[i], normal, 512);
        fake_sum += luminance(fake);
        true_sum += luminance(exact);
        off += std::abs(luminance(fake) - luminance(exact));
        if (luminance(exact) > 1e-3 && luminance(fake) > 1e-3)
            hue += luminance(exact) *
                   glm::degrees(std::acos(std::min(glm::dot(glm::normalize(fake), glm::normalize(exact)), 1.0)));
        ++points;
    }
    EXPECT_GT(points, 500u);
    return {fake_sum / true_sum, off / true_sum, hue / true_sum};
}

TEST(Bounce, IsAsFarFromTheTrueFirstBounceAsTheDocumentationSays) {
    for (const uint32_t lights : {16u, 64u, 256u}) {
        const Fake fake = compare_with_integral(lights);
        std::printf("    %3u lights: %.3f of the true light, off by %.1f %% of it in the mean, colours by %.1f°\n",
                    lights, fake.ratio, 100 * fake.off, fake.hue);
        EXPECT_NEAR(fake.ratio, 1, lights < 64 ? 0.15 : 0.05);
        EXPECT_LT(fake.off, lights < 64 ? 0.4 : 0.25);
        EXPECT_LT(fake.hue, 5);
    }
    const Fake shadowed = compare_with_integral(256, OneBounce::Kind::shadowed);
    std::printf("    256 lights with shadow rays: %.3f, off by %.1f %%, colours by %.1f°\n", shadowed.ratio,
                100 * shadowed.off, shadowed.hue);
    EXPECT_LT(shadowed.off, 0.2);
    const Fake lambert = compare_with_integral(256, OneBounce::Kind::shadowed_lambert);
    std::printf("    and as Lambert surfaces: %.3f, off by %.1f %%, colours by %.1f°\n", lambert.ratio,
                100 * lambert.off, lambert.hue);
    EXPECT_LT(lambert.off, 0.1);
}

} // namespace
} // namespace prelight
