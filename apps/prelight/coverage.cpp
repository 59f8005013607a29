#include "coverage.hpp"

#include "scene_source.hpp"

#include <algorithm>
#include <memory>

namespace prelight::app {
namespace {

/// Large enough for whatever makes mip levels of it.
Image uniform(float value) {
    Image image(8, 4);
    std::ranges::fill(image.pixels, glm::vec3(value));
    return image;
}

/// Black without any light, as see-through as it was.
Material blackened(const Material& material) {
    Material black;
    black.name = material.name;
    black.base_colour = glm::vec4(0, 0, 0, material.base_colour.a);
    black.unlit = true;
    black.alpha_mode = material.alpha_mode;
    black.alpha_cutoff = material.alpha_cutoff;
    black.double_sided = material.double_sided;
    if (material.alpha_mode != AlphaMode::opaque)
        black.base_colour_texture = material.base_colour_texture;
    return black;
}

/// Puts materials and environment of a scene back at its end.
class KeptLook {
public:
    explicit KeptLook(Scene& scene) : scene_(scene), materials_(scene.materials), environment_(scene.environment) {}
    ~KeptLook() {
        scene_.materials = std::move(materials_);
        scene_.environment = std::move(environment_);
    }
    KeptLook(const KeptLook&) = delete;
    KeptLook& operator=(const KeptLook&) = delete;

private:
    Scene& scene_;
    std::vector<Material> materials_;
    std::shared_ptr<const Environment> environment_;
};

} // namespace

std::vector<float> coverage_of(const Session& session, const RenderCommand& command, LoadedScene& loaded,
                               const PlacedCamera& camera) {
    const KeptLook kept(loaded.scene);
    for (Material& material : loaded.scene.materials)
        material = blackened(material);
    Environment white;
    white.name = "coverage";
    white.image = uniform(0);
    white.backdrop = uniform(1);
    loaded.scene.environment = std::make_shared<const Environment>(std::move(white));
    World world = loaded.world;
    world.lights.clear();
    world.decals.clear();

    RenderOptions options = command.options;
    options.exposure = 0;
    options.count_pairs = options.pass_cpu = false;
    options.views = {"final", "linear"};
    const auto renderer = create_renderer(command.renderer, session.device.get(), options);
    renderer->set_world(world);
    renderer->render(camera);
    std::vector<float> coverage;
    for (const glm::vec3& seen : renderer->read("linear").pixels)
        coverage.push_back(1 - std::clamp(seen.g, 0.0f, 1.0f));
    return coverage;
}

void put_over(Image& over_black, const std::vector<float>& coverage, glm::vec3 colour) {
    for (size_t i = 0; i < coverage.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            float& value = over_black.pixels[i][c];
            value = srgb_encode(srgb_decode(value) + (1 - coverage[i]) * srgb_decode(colour[c]));
        }
}

void take_off_black(Image& over_black, const std::vector<float>& coverage) {
    for (size_t i = 0; i < coverage.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            float& value = over_black.pixels[i][c];
            value = coverage[i] > 0 ? srgb_encode(srgb_decode(value) / coverage[i]) : 0;
        }
}

} // namespace prelight::app
