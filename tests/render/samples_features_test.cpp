// Several samples a pixel with everything else that changes what a pixel shows, in each architecture against the
// reference's form of it.
#include "decal_world.hpp"
#include "every_way.hpp"
#include "garden.hpp"
#include <cmath>
#include <prelight/material_shader.hpp>
#include <scene/procedural/cookie_maps.hpp>

namespace prelight {
namespace {

using Settings = std::map<std::string, std::string>;

const Way architectures[] = {{"light-prepass", {}}, {"deferred", {}}, {"z-prepass", {}}, {"multipass", {}}};

Shot with_samples(Shot shot, uint32_t width = 256) {
    shot.width = width;
    shot.height = width * 9 / 16;
    shot.samples = 4;
    return shot;
}

Shot in_way(Shot shot, const Way& way) {
    shot.renderer = way.renderer;
    shot.settings.insert(way.settings.begin(), way.settings.end());
    return shot;
}

constexpr EdgeBound few_edges{.pixels = 400};
/// With msaa-light=edges pixels of one surface are lit at their centres, and not at their samples as the reference has
/// it: what changes within a pixel, as shadows, cookies and highlights do, is not the same there.
constexpr Bound lit_once{.psnr = 50, .off_share = 0.03};

/// Of a shot in each of several ways; those that light samples by themselves at all samples and at edges alone.
void expect_agree(const Shot& shot, std::span<const Way> ways = architectures, const Bound& bound = half_float_bound,
                  const EdgeBound& edges = few_edges) {
    References references;
    const auto expect = [&](const Shot& one, const Bound& within) {
        SCOPED_TRACE(name_of(one));
        const Image picture = render_linear(test_device(), one);
        save_when_wanted(picture, references.of(one));
        expect_within_on_edges(picture, references.of(one), within, edges);
        expect_validation_clean(test_device());
    };
    for (const Way& way : ways) {
        Shot one = in_way(shot, way);
        if (one.renderer == "light-prepass" || one.renderer == "deferred") {
            one.settings["msaa-light"] = "edges";
            expect(one,
                   {std::min(bound.psnr, lit_once.psnr), std::max(bound.off_share, lit_once.off_share), bound.block});
            one.settings["msaa-light"] = "samples";
        }
        expect(one, bound);
    }
}

TEST(SamplesWith, Shadows) {
    Garden garden;
    garden.add_light({.kind = LightKind::directional, .colour = {1, 0.9f, 0.8f}, .intensity = 0.8f}, garden.at(0, 5, 0),
                     glm::normalize(glm::dvec3(-0.5, -1, -0.3)));
    garden.add_light(garden.spot(0.6f, 12, 40), garden.at(4, 5, 3), glm::normalize(glm::dvec3(-0.7, -1, -0.6)));
    Shot shot = with_samples(garden.shot(), 192);
    shot.settings = {
        {"shadows", "on"}, {"shadow-filter", "hard"}, {"shadow-detail", "8"}, {"shadow-budget", "8388608"}};
    const Way ways[] = {
        {"light-prepass", {}}, {"light-prepass", {{"light-culling", "volumes"}}}, {"deferred", {}}, {"multipass", {}}};
    expect_agree(shot, ways, half_float_bound, {.pixels = 200});
}

TEST(SamplesWith, CookiesAndProfiles) {
    Garden garden;
    garden.scene.images = {window_cookie(), dice_cookie()};
    Light window = garden.spot(0.6f, 14, 70), dice = garden.point(8, 8), lamp = garden.point(9, 8);
    window.cookie = 0, dice.cookie = 1;
    lamp.profile = wall_lamp();
    garden.add_light(window, {3, 5.5, 4}, {-0.5, -1, -0.7});
    garden.add_light(dice, {2.2, 2.6, -1}, {-0.6, 0.2, -1});
    garden.add_light(lamp, {-4, 3, -2}, {0.3, -1, 0.2});
    const Way ways[] = {{"light-prepass", {}},
                        {"light-prepass", {{"list-shading", "fragment"}}},
                        {"deferred", {}},
                        {"z-prepass", {}},
                        {"multipass", {}}};
    expect_agree(with_samples(garden.shot()), ways);
}

// What a decal reaches is drawn once a sample, whatever the settings say, for the decals' buffer holds samples: here
// that is everything. On cards, for decals see the normal that was stored, and that is a fragment's. Orthographic, for
// lavapipe (Mesa 22.3) divides by w at the pixel's centre.
TEST(SamplesWith, DecalsOnEachSample) {
    DecalGarden garden;
    garden.world.instances.resize(1); // the floor
    for (int i = 0; i < 5; ++i) {
        glm::dmat4 m = glm::translate(glm::dmat4(1), {-4.0 + 2 * i, 1, i % 2 ? -1.2 : 0.8});
        m = glm::rotate(m, 0.3 * i - 0.7, glm::dvec3(0.2, 1, 0.1));
        garden.add(square(1), glm::rotate(m, 0.2 * i, glm::dvec3(0, 0, 1)));
    }
    garden.add_lights(6, 5, 6);
    Decal over{.material = garden.painted, .opacity = 0.2f};
    over.order = 9;
    garden.add_decal(over, {0, 0.5, 0}, garden.camera.axes[2], 0.1, {22, 22, 22});
    Shot shot = with_samples(garden.shot());
    shot.camera.camera.kind = ProjectionKind::orthographic;
    shot.camera.camera.ymag = 3;
    shot.camera.camera.zfar = 40;
    const Way ways[] = {{"light-prepass", {{"msaa-light", "samples"}}},
                        {"light-prepass", {{"msaa-light", "samples"}, {"normals", "oct32"}}},
                        {"deferred", {{"msaa-light", "samples"}}},
                        {"z-prepass", {}},
                        {"z-prepass", {{"lights", "grid"}}},
                        {"multipass", {}}};
    for (const Way& way : ways) {
        const Shot one = in_way(shot, way);
        SCOPED_TRACE(name_of(one));
        ReferenceForm form = form_of(one);
        form.samples = {.count = 4};
        const ReferencePicture reference =
            render_reference(garden.world, one.camera, one.width, one.height, one.exposure, form);
        const Image picture = render_linear(test_device(), one);
        save_when_wanted(picture, reference);
        expect_within_on_edges(picture, reference, half_float_bound, {.pixels = 300});
    }
    expect_validation_clean(test_device());
}

TEST(SamplesWith, AnEnvironmentAndItsBackground) {
    Garden garden;
    auto sky = std::make_shared<Environment>(Environment{.name = "sky", .image = Image(48, 24)});
    for (uint32_t y = 0; y < 24; ++y)
        for (uint32_t x = 0; x < 48; ++x)
            sky->image.at(x, y) = glm::mix(glm::vec3(0.2f, 0.4f, 1), glm::vec3(0.3f, 0.2f, 0.1f),
                                           (static_cast<float>(y) + 3 * std::sin(0.26f * static_cast<float>(x))) / 24);
    for (glm::vec3& texel : sky->image.pixels)
        texel = glm::max(texel, glm::vec3(0));
    garden.scene.environment = sky;
    garden.add_lights(4, 5, 4);
    const Way ways[] = {{"light-prepass", {}}, {"deferred", {}}, {"z-prepass", {}}, {"multipass", {}}};
    expect_agree(with_samples(garden.shot(), 112), ways, half_float_bound, {.pixels = 150});
}

TEST(SamplesWith, SpecularAntialiasingOff) {
    Garden garden;
    garden.add_lights(12, 4, 6);
    Shot shot = with_samples(garden.shot());
    shot.settings = {{"specular-antialiasing", "off"}};
    expect_agree(shot);
}

TEST(SamplesWith, MaterialsOfTheirOwn) {
    for (const char* name : {"skin", "reflection", "fresnel-rim"}) {
        SCOPED_TRACE(name);
        const ShadedGarden garden(find_material_shader(name));
        expect_agree(with_samples(garden.shot()));
    }
}

TEST(SamplesWith, MasksUnlitSurfacesAndBothSides) {
    const MixedMaterials world;
    expect_agree(with_samples(world.shot()), architectures, half_float_bound, {.pixels = 100});
}

TEST(SamplesWith, ThePhongModel) {
    Garden garden;
    garden.add_lights(12, 4, 6);
    Shot shot = with_samples(garden.shot());
    shot.shading = Shading::phong;
    const Way ways[] = {{"light-prepass", {}},
                        {"light-prepass", {{"light-buffer", "packed-rgba16f"}}},
                        {"light-prepass", {{"light-buffer", "packed-rgba16f"}, {"specular", "fifth-channel"}}},
                        {"deferred", {}},
                        {"z-prepass", {}},
                        {"multipass", {}}};
    expect_agree(shot, ways);
}

// Bounds of the formats, as tests of one sample have them.
TEST(SamplesWith, LightBuffersInFixedPoint) {
    const FewLights garden;
    Shot shot = with_samples(garden.shot());
    shot.exposure = 0.7;
    const auto buffer = [](const char* name, const char* writes) {
        return Way{"light-prepass",
                   {{"light-buffer", name},
                    {"light-writes", writes},
                    {"light-scale", std::string(writes) == "once" ? "8" : "2"}}};
    };
    const Bound coarse{.psnr = 37, .off_share = 1, .block = 255};
    const Way bytes[] = {buffer("rgba8", "blended"), buffer("rgba8", "once"), buffer("packed-rgba8", "once")};
    expect_agree(shot, bytes, coarse, {.pixels = 400, .psnr = 37});
    const Way ten[] = {buffer("rgb10a2", "blended"), buffer("rgb10a2", "once")};
    expect_agree(shot, ten, {.psnr = 48, .off_share = 1, .block = 255}, {.pixels = 400, .psnr = 45});
    const Way wide[] = {{"light-prepass", {{"light-sums", "float32"}}},
                        {"light-prepass", {{"light-writes", "once"}}},
                        {"light-prepass", {{"light-writes", "blended"}}},
                        {"light-prepass", {{"ambient", "light"}}}};
    expect_agree(shot, wide);
}

TEST(SamplesWith, EncodingsOfNormalsAndPositions) {
    Garden garden;
    garden.add_lights(12, 4, 6);
    const Way ways[] = {{"light-prepass", {{"normals", "oct32"}, {"normal-space", "view"}}},
                        {"light-prepass", {{"normals", "xy16f"}, {"normal-space", "view"}, {"position", "matrix"}}},
                        {"light-prepass", {{"normals", "rgb10a2"}, {"geometry", "two-passes"}}},
                        {"deferred", {{"position", "matrix"}}}};
    expect_agree(with_samples(garden.shot()), ways);
}

TEST(SamplesWith, EveryWayToFindLights) {
    Garden garden;
    garden.add_lights(20, 4, 6);
    garden.add_light(garden.spot(0.6f, 8, 20), garden.at(1, 4, 2), {0, -1, -0.2});
    garden.add_light({.kind = LightKind::directional, .intensity = 0.3f}, {0, 0, 0}, {-0.3, -1, -0.5});
    std::vector<Way> ways;
    for (const Shot& shot : every_way({}))
        ways.push_back({shot.renderer == "light-prepass" ? "light-prepass"
                        : shot.renderer == "deferred"    ? "deferred"
                        : shot.renderer == "z-prepass"   ? "z-prepass"
                                                         : "multipass",
                        shot.settings});
    expect_agree(with_samples(garden.shot(), 160), ways, half_float_bound, {.pixels = 200});
}

// What leaves out geometry leaves out none that shows in a sample.
TEST(SamplesWith, GeometryLeftOut) {
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
    EXPECT_GE(compare(picture, one, out).psnr, psnr);
}

// Occlusion is looked for once a pixel, and its own noise and blur are not the reference's: away from edges it is what
// it is with one sample.
TEST(SamplesWith, AmbientOcclusion) {
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
TEST(SamplesWith, MotionBlur) {
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
    EXPECT_GT(compare(render_linear(test_device(), shot), mean).psnr, compare(sharp, mean).psnr + 6);
    expect_validation_clean(test_device());
}

TEST(SamplesWith, EveryPresetTellsWhatGaveWay) {
    Garden garden;
    garden.add_lights(4, 5, 4);
    for (const RendererInfo& info : renderer_infos())
        for (const std::string& preset : info.presets) {
            if (!info.needs_device)
                continue;
            SCOPED_TRACE(preset);
            RenderOptions options{.width = 160, .height = 90, .msaa = 4, .preset = preset};
            options.settings = {{"shadows", "on"}};
            const auto renderer = create_renderer(info.name, &test_device(), options);
            renderer->set_world(garden.world);
            renderer->render(garden.camera);
            RenderOptions once = options;
            once.msaa = 1;
            const auto other = create_renderer(info.name, &test_device(), once);
            other->set_world(garden.world);
            other->render(garden.camera);
            EXPECT_GT(compare(renderer->read("linear"), other->read("linear")).psnr, 25);
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

TEST(SamplesWith, EveryViewOfEveryRenderer) {
    DecalGarden garden;
    garden.add_lights(4, 5, 4);
    for (const RendererInfo& info : renderer_infos()) {
        if (!info.needs_device)
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
