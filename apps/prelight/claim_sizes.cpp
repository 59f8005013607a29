#include "claims.hpp"

#include <prelight/renderer.hpp>

namespace prelight::app {
namespace {

constexpr double pixels = 1280.0 * 720; ///< the text's picture

Stats stats_of(const ClaimScene& scene, RenderOptions options) {
    options.width = scene.width;
    options.height = scene.height;
    options.shading = Shading::phong; // the presets' own, and the same for all
    const auto renderer = create_renderer("light-prepass", &scene.device, options);
    renderer->set_world(scene.world);
    renderer->render(scene.camera);
    return renderer->stats();
}

double bytes_a_pixel(const ClaimScene& scene, uint64_t bytes) {
    return static_cast<double>(bytes) / scene.width / scene.height;
}

/// Every image of the light pre-pass with this light buffer, bytes a pixel.
double with_light_buffer(const ClaimScene& scene, const char* light_buffer) {
    RenderOptions options;
    options.settings = {{"light-buffer", light_buffer}};
    return bytes_a_pixel(scene, stats_of(scene, options).attachment_bytes_unshared);
}

} // namespace

std::vector<Claim> size_claims(const ClaimScene& scene) {
    const double target = pixels * 2 * 4 / 1e6; // 8:8:8:8 with two samples, MB
    const double saved = with_light_buffer(scene, "rgba8") - with_light_buffer(scene, "packed-rgba8");
    const auto row = [](const char* id, const char* claim, const char* how, double ours, double text) {
        return Claim{.id = id,
                     .claim = claim,
                     .source = "Lee, Prelighting",
                     .how = how,
                     .unit = "MB",
                     .a = ours,
                     .b = text,
                     .from = 0.95,
                     .to = 1.05};
    };
    return {
        row("msaa-target", "a 1280x720 MSAA buffer is 7.3mb",
            "computed: 1280 x 720 pixels x 2 samples x 4 bytes : the text's", target, 7.3),
        row("five-targets", "multiplied by 5 is 38mb", "computed: five of them : the text's", 5 * target, 38),
        row("no-msaa-light-buffers", "don't use MSAA light buffers: saves ~7.4mb",
            "computed: two 8:8:8:8 light buffers with 2 samples less two with 1 : the text's", target, 7.4),
        row("no-specular-buffer", "no separate specular buffer: saves an additional 3.7mb",
            "measured: attachments with light-buffer=rgba8 less packed-rgba8, for 1280 x 720 : the text's",
            saved * pixels / 1e6, 3.7),
    };
}

std::vector<PresetSize> preset_sizes(const ClaimScene& scene) {
    std::vector<PresetSize> sizes;
    for (const char* preset : {"engel", "round2", "prelighting"}) {
        RenderOptions options;
        options.preset = preset;
        const Stats stats = stats_of(scene, options);
        sizes.push_back({preset, bytes_a_pixel(scene, stats.attachment_bytes),
                         bytes_a_pixel(scene, stats.attachment_bytes_unshared)});
    }
    return sizes;
}

} // namespace prelight::app
