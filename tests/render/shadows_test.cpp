// Shadow maps against the reference's shadow rays [S1] [S2], in every architecture.
#include "garden.hpp"
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

using Settings = std::map<std::string, std::string>;

/// Each renderer on a device once for each way in which it finds lights.
std::vector<Shot> every_way(const Shot& shot) {
    std::vector<Shot> shots;
    for (const RendererInfo& info : renderer_infos())
        for (const SettingInfo& setting : info.settings)
            if (info.needs_device && (setting.key == "light-culling" || setting.key == "lights" || setting.key == "order"))
                for (const std::string& value : setting.values) {
                    if (value == "auto")
                        continue; // one of the others
                    Shot& one = shots.emplace_back(shot);
                    one.renderer = info.name;
                    one.settings["model"] = "nv";
                    one.settings[setting.key] = value;
                    if (value != "tiles")
                        continue;
                    one.settings["list-shading"] = "compute";
                    Shot other = one;
                    other.settings["list-shading"] = "fragment";
                    shots.push_back(other);
                }
    return shots;
}

std::string name_of(const Shot& shot) {
    std::string name = shot.renderer;
    for (const auto& [key, value] : shot.settings)
        name += " " + key + "=" + value;
    return name;
}

/// A garden with one light of each kind, all of which cast shadows.
struct ShadowGarden : Garden {
    ShadowGarden() {
        add_light({.kind = LightKind::directional, .colour = {1, 0.9f, 0.8f}, .intensity = 0.8f}, at(0, 5, 0),
                  glm::normalize(glm::dvec3(-0.5, -1, -0.3)));
        add_light(point(9, 7), at(-1, 2.6, 2.2));
        add_light(spot(0.6f, 12, 40), at(4, 5, 3), glm::normalize(glm::dvec3(-0.7, -1, -0.6)));
        add_light(spot(1.3f, 9, 9), at(-4, 3.2, 1), glm::normalize(glm::dvec3(0.3, -1, -0.3)));
    }
    Shot shot() const {
        Shot shot = Garden::shot();
        shot.settings = {{"shadows", "on"}, {"shadow-filter", "hard"}, {"shadow-detail", "8"}, {"shadow-budget", "67108864"}};
        return shot;
    }
};

TEST(Shadows, S1_EveryArchitectureAgreesWithShadowRays) {
    const ShadowGarden garden;
    Shot form = garden.shot();
    const ReferencePicture reference = render_reference(garden.world, garden.camera, form.width, form.height, 0,
                                                        {.fresnel = ReferenceForm::Fresnel::nv, .shadows = true});
    size_t shadowed = 0;
    for (const uint64_t mask : reference.shadow_mask)
        shadowed += mask != 0;
    EXPECT_GT(shadowed, reference.shadow_mask.size() / 10) << "the scene has shadows to compare";
    for (const Shot& shot : every_way(form)) {
        SCOPED_TRACE(name_of(shot));
        const Image image = render_linear(test_device(), shot);
        expect_within(compare(image, reference.linear, reference.left_out()), half_float_bound);
    }
    expect_validation_clean(test_device());
}

TEST(Shadows, Debug) {
    const ShadowGarden garden;
    for (size_t i = 0; i < 4; ++i) {
        World world = garden.world;
        world.lights = {garden.world.lights[i]};
        Shot shot = garden.shot();
        shot.world = &world;
        expect_within(against_reference(test_device(), shot), {});
        rename("/tmp/shad_pics/Shadows.Debug.png", ("/tmp/shad_pics/d" + std::to_string(i) + ".png").c_str());
        rename("/tmp/shad_pics/Shadows.Debug.reference.png", ("/tmp/shad_pics/r" + std::to_string(i) + ".png").c_str());
    }
}

} // namespace
} // namespace prelight
