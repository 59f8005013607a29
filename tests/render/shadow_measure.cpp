#include "shadow_measure.hpp"
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <reference/light_tree.hpp>
#include <reference/ray_scene.hpp>

namespace prelight {
namespace {

constexpr double gap = 0.02; // metres

/// 1 where `differs(a, b)` for a pixel within `reach`.
template <class Differs>
std::vector<uint8_t> near_changes(uint32_t width, uint32_t height, int reach, Differs&& differs) {
    std::vector<uint8_t> edge(size_t(width) * height), out(edge.size());
    const auto w = int(width), h = int(height);
    const auto at = [&](int x, int y) { return size_t(y) * width + size_t(x); };
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x)
            edge[at(x, y)] =
                (x + 1 < w && differs(at(x, y), at(x + 1, y))) || (y + 1 < h && differs(at(x, y), at(x, y + 1)));
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x)
            for (int v = std::max(y - reach, 0); v <= std::min(y + reach, h - 1); ++v)
                for (int u = std::max(x - reach, 0); u <= std::min(x + reach, w - 1); ++u)
                    out[at(x, y)] |= edge[at(u, v)];
    return out;
}

float brightness(const Image& image, size_t i) { return image.pixels[i].r + image.pixels[i].g + image.pixels[i].b; }

} // namespace

ShadowErrors shadow_errors(Device& device, const Shot& shot, int reach) {
    const Image linear = render_linear(device, shot), picture = tonemap(linear, Tonemap::none);
    const ReferenceForm form = form_of(shot);
    const auto render = [&](const ReferenceForm& f) {
        return render_reference(*shot.world, shot.camera, shot.width, shot.height, shot.exposure, f);
    };
    const ReferencePicture reference = render(form);
    const Image truth = tonemap(reference.linear, Tonemap::none);
    const std::vector<uint8_t> left_out = reference.left_out();
    const std::vector<uint8_t> beside = near_changes(shot.width, shot.height, reach, [&](size_t a, size_t b) {
        return reference.shadow_mask[a] != reference.shadow_mask[b] ||
               reference.mask_outcome[a] != reference.mask_outcome[b];
    });
    ShadowErrors errors;
    const double pixels = double(picture.pixels.size());
    for (size_t i = 0; i < picture.pixels.size(); ++i) {
        if (beside[i] || left_out[i])
            continue;
        ++errors.judged;
        const glm::vec3 darker = truth.pixels[i] - picture.pixels[i];
        errors.darkened += std::max({darker.r, darker.g, darker.b}) > 2 / 255.0f;
    }
    errors.darkened /= std::max(errors.judged, 1.0);
    errors.judged /= pixels;
    if (shot.world->lights.size() != 1)
        return errors;

    ReferenceForm without = form;
    without.shadows = false;
    const ReferencePicture lit = render(without);
    const reference::Textures textures(*shot.world->scene, true);
    const reference::RayScene rays(*shot.world, shot.camera.position, textures);
    const reference::LightTree tree(*shot.world, shot.camera.position);
    // Where one object ends and another begins is where things touch: only changes on the same object leave out.
    const std::vector<uint8_t> on_object = near_changes(shot.width, shot.height, reach, [&](size_t a, size_t b) {
        return reference.instance[a] == reference.instance[b] && reference.primitive[a] == reference.primitive[b] &&
               reference.shadow_mask[a] != reference.shadow_mask[b];
    });
    for (size_t i = 0; i < picture.pixels.size(); ++i) {
        const float dark = brightness(reference.linear, i), full = brightness(lit.linear, i);
        errors.lit += full > 0.02f && full == dark;
        errors.shadowed += full - dark >= 0.02f;
        if (on_object[i] || full - dark < 0.02f || brightness(linear, i) - dark < 0.5f * (full - dark))
            continue;
        const glm::dvec3 place = reference.position[i] - shot.camera.position;
        const reference::Incident light = tree.incident(0, place);
        errors.leaking += rays.blocked({place, light.to_light, gap, light.distance - 1e-4});
    }
    errors.leaking /= pixels;
    errors.lit /= pixels;
    errors.shadowed /= pixels;
    return errors;
}

void expect_shadows_right(const Shot& shot, int reach) {
    const ShadowErrors errors = shadow_errors(test_device(), shot, reach);
    EXPECT_GE(errors.judged, 0.15) << "enough of the picture is beyond the filter's reach";
    if (shot.world->lights.size() == 1) {
        EXPECT_GE(errors.lit, 0.02);
        EXPECT_GE(errors.shadowed, 0.02);
    }
    EXPECT_LE(errors.darkened, 0.0005);
    EXPECT_LE(errors.leaking, 0.0005);
    std::printf("    %.1f %% judged, %.4f %% of them darkened, %.4f %% leaking\n", errors.judged * 100,
                errors.darkened * 100, errors.leaking * 100);
    expect_validation_clean(test_device());
}

} // namespace prelight
