// Every built-in material in every form of the lighting model that a renderer runs, packed and not, against the
// reference.
#include "garden.hpp"
#include <algorithm>
#include <prelight/material_shader.hpp>

namespace prelight {
namespace {

struct RendererForm {
    const char* name;
    const char* renderer;
    std::map<std::string, std::string> settings;
    Shading shading = Shading::ggx;
};
const std::vector<RendererForm> renderer_forms{
    {"Weighted", "light-prepass", {{"model", "weighted"}}},
    {"AtViewer", "light-prepass", {{"model", "nv"}}},
    {"Mono", "light-prepass", {{"model", "mono"}, {"light-buffer", "packed-rgba16f"}}},
    {"MonoPhong", "light-prepass", {{"light-buffer", "packed-rgba16f"}}, Shading::phong},
    {"FullMultipass", "multipass", {{"model", "full"}}},
    {"AtViewerMultipass", "multipass", {{"model", "nv"}}},
    {"FullZPrepass", "z-prepass", {{"model", "full"}}},
    {"AtViewerZPrepass", "z-prepass", {{"model", "nv"}}},
    {"FullDeferred", "deferred", {{"model", "full"}}},
    {"AtViewerDeferred", "deferred", {{"model", "nv"}}}};

class EveryMaterial : public testing::TestWithParam<RendererForm> {};

TEST_P(EveryMaterial, AgreesWithTheReference) {
    for (const auto& shader : built_in_material_shaders()) {
        SCOPED_TRACE(shader->name);
        Garden garden;
        for (size_t m = 1; m < garden.scene.materials.size(); ++m)
            garden.scene.materials[m].shader = shader;
        garden.add_lights(6, 5, 6);
        Shot shot = garden.shot();
        shot.width = 160;
        shot.height = 90;
        shot.renderer = GetParam().renderer;
        shot.settings = GetParam().settings;
        shot.shading = GetParam().shading;
        shot.exposure = shot.shading == Shading::phong ? -1 : 0;
        expect_agrees(shot, {.left_out = 0.2});
    }
}

INSTANTIATE_TEST_SUITE_P(In, EveryMaterial, testing::ValuesIn(renderer_forms),
                         [](const auto& tested) { return std::string(tested.param.name); });

} // namespace
} // namespace prelight
