// Several samples a pixel with what the reference has no form of: geometry left out, occlusion, motion blur, presets,
// views.
#include "decal_world.hpp"
#include "every_way.hpp"
#include <algorithm>
#include <cmath>

namespace prelight {
namespace {

using Settings = std::map<std::string, std::string>;

// What leaves out geometry leaves out none that shows in a sample.
TEST(SamplesBeside, GeometryLeftOut) {
    Garden garden;
    garden.add_lights(8, 4, 6);
    for (const char* renderer : {"light-prepass", "deferred", "z-prepass", "multipass"}) {
        Shot shot = in_way(with_samples(garden.shot()), {renderer, {}});
        shot.settings["index-trimming"] = "off";
        const Image whole = render_linear(test_device(), shot);
        const bool twice = std::string(renderer) == "light-prepass" || std::string(renderer) == "z-prepass";
        for (const Settings& settings : {Settings{{"index-trimming", "host"}},
                                         {{"index-trimming", "device"}},
                                         {{"index-trimming", "device"}, {"material-trimming", "depth"}},
                                         {{"index-trimming", "host"}, {"material-trimming", "depth"}},
                                         {{"index-trimming", "off"}, {"occlusion", "queries"}}}) {
            if (settings.size() > 1 && !twice)
                continue;
            Shot trimmed = shot;
            for (const auto& [key, value] : settings)
                trimmed.settings[key] = value;
            EXPECT_TRUE(render_linear(test_device(), trimmed).pixels == whole.pixels) << name_of(trimmed);
        }
    }
    expect_validation_clean(test_device());
}

/// A picture of few samples where pixels share a surface, against that of one: the same light, at four places.
void expect_near_where_flat(const Image& picture, const Image& one, const ReferencePicture& reference, double psnr) {
    std::vector<uint8_t> out = reference.left_out();
    for (size_t i = 0; i < out.size(); ++i)
        out[i] = out[i] || reference.edge[i];
    EXPECT_GE(compare_pixels(picture, one, out).psnr, psnr);
}

// Occlusion is looked for once a pixel, and its own noise and blur are not the reference's: away from edges it is what
// it is with one sample.
TEST(SamplesBeside, AmbientOcclusion) {
    Garden garden;
    garden.add_lights(4, 5, 4);
    garden.world.ambient = {0.4f, 0.4f, 0.4f};
    Shot shot = with_samples(garden.shot());
    References references;
    const ReferencePicture& reference = references.of(shot);
    for (const char* size : {"full", "half"}) {
        SCOPED_TRACE(size);
        shot.settings["ssao"] = size;
        shot.samples = 4;
        const Image four = render_linear(test_device(), shot);
        shot.samples = 1;
        expect_near_where_flat(four, render_linear(test_device(), shot), reference, 45);
    }
    expect_validation_clean(test_device());
}

// Against the mean of what is seen between the previous state and now.
TEST(SamplesBeside, MotionBlur) {
    Garden garden;
    garden.add_lights(4, 3, 4);
    Shot shot = in_way(with_samples(garden.shot()), {"deferred", {}});
    const glm::dmat3 end = garden.camera.axes;
    const auto turned = [&](double share) {
        return glm::dmat3(glm::rotate(glm::dmat4(1), 0.05 * share, glm::dvec3(0, 1, 0))) * end;
    };
    constexpr int moments = 24;
    Image mean(shot.width, shot.height);
    for (int i = 0; i < moments; ++i) {
        shot.camera.axes = turned(double(i) / moments);
        const Image moment = render_linear(test_device(), shot);
        for (size_t p = 0; p < mean.pixels.size(); ++p)
            mean.pixels[p] += moment.pixels[p] / float(moments);
    }
    shot.camera.axes = end;
    const Image sharp = render_linear(test_device(), shot);
    shot.settings["motion-blur"] = "on";
    shot.camera.previous = CameraPose{garden.camera.position, end};
    EXPECT_TRUE(render_linear(test_device(), shot).pixels == sharp.pixels) << "nothing moved";
    shot.camera.previous = CameraPose{garden.camera.position, turned(1)};
    EXPECT_GT(compare_pixels(render_linear(test_device(), shot), mean).psnr, compare_pixels(sharp, mean).psnr + 6);
    expect_validation_clean(test_device());
}

TEST(SamplesBeside, EveryPresetTellsWhatGaveWay) {
    Garden garden;
    garden.add_lights(4, 5, 4);
    for (const RendererInfo& info : renderer_infos())
        for (const std::string& preset : info.presets) {
            if (!info.needs_device)
                continue;
            SCOPED_TRACE(preset);
            RenderOptions options{.width = 160, .height = 90, .msaa = 4, .preset = preset};
            options.settings = {{"shadows", "on"}, {"shadow-budget", "1048576"}};
            const auto renderer = create_renderer(info.name, &test_device(), options);
            renderer->set_world(garden.world);
            renderer->render(garden.camera);
            RenderOptions once = options;
            once.msaa = 1;
            const auto other = create_renderer(info.name, &test_device(), once);
            other->set_world(garden.world);
            other->render(garden.camera);
            EXPECT_GT(compare_pixels(renderer->read("linear"), other->read("linear")).psnr, 25);
            const std::vector<std::string> notes = renderer->stats().notes;
            const std::map<std::string, std::string> wanted{
                {"round2", "depth"}, {"prelighting", "shadow-memory"}, {"killzone2", "g-buffer"}};
            if (wanted.contains(preset)) {
                EXPECT_THAT(notes, testing::Contains(testing::HasSubstr(wanted.at(preset))));
            } else {
                EXPECT_THAT(notes, testing::IsEmpty());
            }
        }
    expect_validation_clean(test_device());
}

/// Quarters: how many surfaces a pixel has.
void expect_edges(const Image& edges) {
    size_t some = 0, two = 0;
    for (const glm::vec3& pixel : edges.pixels) {
        const float surfaces = 4 * pixel.r;
        EXPECT_NEAR(surfaces, std::round(surfaces), 4 * 0.5 / 255 + 1e-4);
        some += surfaces > 0 ? 1 : 0;
        two += std::round(surfaces) == 2 ? 1 : 0;
    }
    EXPECT_GT(two, 0u);
    EXPECT_LT(some, edges.pixels.size());
}

TEST(SamplesBeside, EveryViewOfEveryRenderer) {
    DecalGarden garden;
    garden.add_lights(4, 5, 4);
    for (const RendererInfo& info : renderer_infos()) {
        if (!info.needs_device || info.name == "inferred") // which has one sample a pixel
            continue;
        for (const char* light : {"edges", "pixel"}) {
            const bool has = std::any_of(info.settings.begin(), info.settings.end(), [&](const SettingInfo& setting) {
                return setting.key == "msaa-light" && std::count(setting.values.begin(), setting.values.end(), light);
            });
            if (!has && std::string(light) == "pixel")
                continue;
            RenderOptions options{.width = 96, .height = 54, .msaa = 4};
            if (has)
                options.settings["msaa-light"] = light;
            const auto of = [&](const std::vector<std::string>& views) {
                options.views = views;
                auto renderer = create_renderer(info.name, &test_device(), options);
                renderer->set_world(garden.world);
                renderer->render(garden.camera);
                return renderer;
            };
            const auto all = of(info.views);
            for (const std::string& view : info.views) {
                SCOPED_TRACE(info.name + " " + view);
                const Image together = all->read(view);
                EXPECT_EQ(together.width, 96u);
                if (std::string(light) == "pixel")
                    continue;
                if (has && view == "edges")
                    expect_edges(together);
                const Image alone = of({view})->read(view);
                if (view != "final") { // which is tone mapped in another pass where a linear picture is wanted
                    EXPECT_TRUE(together.pixels == alone.pixels);
                }
            }
        }
    }
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
