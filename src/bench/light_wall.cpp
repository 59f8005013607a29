#include "light_wall.hpp"
#include <algorithm>
#include <cmath>
#include <reference/trace.hpp>

namespace prelight::bench {
namespace {

// Half floats hold these roughnesses exactly, so that the normal buffer adds no error of its own.
constexpr float roughnesses[] = {0.75f, 0.625f, 0.5f};

Primitive stripe(float left, float right, uint32_t material) {
    Primitive primitive;
    primitive.positions = {{left, -1.5f, 0}, {right, -1.5f, 0}, {right, 1.5f, 0}, {left, 1.5f, 0}};
    primitive.normals.assign(4, {0, 0, 1});
    primitive.indices = {0, 1, 2, 0, 2, 3};
    primitive.material = material;
    return primitive;
}

float brightest(const Image& image) {
    float most = 0;
    for (const glm::vec3& p : image.pixels)
        most = std::max({most, p.x, p.y, p.z});
    return most;
}

} // namespace

LightWall::LightWall(uint32_t lights, uint32_t width, uint32_t height) {
    add_stripes();
    add_lights(lights);
    Camera lens;
    lens.yfov = 2 * std::atan(0.25); // one metre up and down at the wall
    world_.cameras = {look_at(lens, {0, 0, 4}, {0, 0, 0})};

    using Specular = ReferenceForm::Specular;
    const auto trace = [&](Specular way, reference::ReferenceBuffers* buffers) {
        const ReferenceForm form{.shading = Shading::phong, .mono_specular = true, .specular = way};
        return reference::trace(world_, camera(), width, height, 0, form, buffers).linear;
    };
    reference::ReferenceBuffers buffers;
    trace(Specular::stored, &buffers);
    const float factor = static_cast<float>(peak) / brightest(buffers.diffuse_light);
    for (PlacedLight& light : world_.lights)
        light.light.intensity *= factor;
    for (const Specular way :
         {Specular::stored, Specular::luv, Specular::fifth_channel, Specular::luminance, Specular::bent})
        specular_[way] = trace(way, &buffers); // of white metal: the specular sum itself
    diffuse_ = std::move(buffers.diffuse_light);
}

void LightWall::add_stripes() {
    world_.scene = &scene_;
    for (uint32_t i = 0; i < 3; ++i) {
        scene_.materials.push_back({.name = "stripe", .metallic = 1, .roughness = roughnesses[i]});
        const float left = i == 0 ? -4.0f : -1.8f + 1.2f * static_cast<float>(i);
        const float right = i == 2 ? 4.0f : -0.6f + 1.2f * static_cast<float>(i);
        scene_.meshes.push_back({.name = "stripe", .primitives = {stripe(left, right, i)}});
        world_.instances.push_back({.mesh = i});
    }
    world_.bounds_min = {-4, -1.5, 0};
    world_.bounds_max = {4, 1.5, 0};
    world_.triangles = 6;
}

void LightWall::add_lights(uint32_t count) {
    for (uint32_t i = 0; i < count; ++i) {
        // Places by the plastic number's sequence, hues in turn.
        const auto part = [&](double step) { return std::fmod(0.5 + step * i, 1.0); };
        const double hue = 2.0943951 * i;
        Light light{.kind = LightKind::point, .intensity = 1.0f / static_cast<float>(count)};
        light.colour =
            glm::vec3(0.7 + 0.3 * std::cos(hue), 0.7 + 0.3 * std::cos(hue - 2.1), 0.7 + 0.3 * std::cos(hue + 2.1));
        const glm::dvec3 place(3.0 * part(0.7548776662466927) - 1.5, 1.6 * part(0.5698402909980532) - 0.8,
                               1.2 + part(0.37));
        world_.lights.push_back({light, place});
    }
}

} // namespace prelight::bench
