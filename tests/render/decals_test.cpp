// Decals in every architecture, against the reference's own form of them.
#include "decal_world.hpp"
#include <algorithm>
#include <prelight/error.hpp>
#include <prelight/material_shader.hpp>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

using testing::HasSubstr;
using Settings = std::map<std::string, std::string>;

struct DecalWay {
    const char* name;
    const char* renderer;
    Settings settings;
};

class Decals : public testing::TestWithParam<DecalWay> {
protected:
    Shot shot_of(const Garden& garden) const {
        Shot shot = garden.shot();
        shot.renderer = GetParam().renderer;
        shot.settings = GetParam().settings;
        return shot;
    }
};

TEST_P(Decals, AgreeWithTheReference) {
    DecalGarden garden;
    garden.add_lights(6, 5, 6);
    expect_agrees(shot_of(garden));
    // A decal's normals and colours are seen: the same world without them is another picture.
    const Image with = render_linear(test_device(), shot_of(garden));
    const auto none = std::vector<uint8_t>(with.pixels.size(), 0);
    for (const bool normals : {true, false}) {
        DecalGarden other;
        other.add_lights(6, 5, 6);
        for (PlacedDecal& placed : other.world.decals)
            (normals ? placed.decal.normal : placed.decal.colour) = false;
        EXPECT_LT(compare_pixels(with, render_linear(test_device(), shot_of(other)), none).psnr, 38)
            << (normals ? "normals" : "colours");
    }
}

TEST_P(Decals, AgreeWithTheReferenceOnMaterialsOfTheirOwn) {
    for (const char* material : {"skin", "reflection"}) {
        DecalGarden garden;
        garden.add_lights(5, 5, 6);
        for (size_t m = 1; m < 6; ++m)
            garden.scene.materials[m].shader = find_material_shader(material);
        expect_agrees(shot_of(garden));
    }
}

TEST_P(Decals, TheCameraMayStandInABox) {
    DecalGarden garden;
    garden.add_lights(4, 6, 8);
    garden.add_decal({.material = garden.painted, .opacity = 0.6f, .order = 7}, {0.4, 3, 6}, {0, 1, 0}, 0.2,
                     {14, 15, 7});
    expect_agrees(shot_of(garden));
    // The near plane cuts a box that the camera stands before.
    DecalGarden cut;
    cut.add_lights(4, 6, 8);
    cut.camera.camera.znear = 2.5;
    cut.add_decal({.material = cut.bumpy, .order = 7}, {0.3, 2.4, 4.6}, {0, 1, 0}, 0.2, {5, 6, 5.5});
    expect_agrees(shot_of(cut));
}

TEST_P(Decals, OrthographicFarAndFarFromTheOrigin) {
    DecalGarden garden({12000, -300, 7000});
    garden.add_lights(4, 6, 8);
    garden.camera = look_at({.kind = ProjectionKind::orthographic, .ymag = 4, .znear = 1, .zfar = 13},
                            garden.at(1, 6, 7), garden.at(0, 0, 0.5));
    expect_agrees(shot_of(garden));
}

TEST_P(Decals, WhatReceivesNoneIsAsWithoutThem) {
    DecalGarden garden;
    garden.add_lights(4, 5, 6);
    for (Instance& instance : garden.world.instances)
        instance.receives_decals = false;
    Shot shot = shot_of(garden);
    shot.width = 160, shot.height = 90;
    const Image refused = render_linear(test_device(), shot);
    for (Instance& instance : garden.world.instances)
        instance.receives_decals = true;
    for (Material& material : garden.scene.materials)
        material.receives_decals = false;
    EXPECT_TRUE(render_linear(test_device(), shot).pixels == refused.pixels);
    garden.world.decals.clear();
    EXPECT_TRUE(render_linear(test_device(), shot).pixels == refused.pixels);
    for (Material& material : garden.scene.materials)
        material.receives_decals = true;
    const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
    renderer->set_world(garden.world);
    renderer->render(shot.camera);
    for (const PassStats& pass : renderer->stats().passes)
        EXPECT_EQ(pass.name.find("decal"), std::string::npos) << pass.name << " runs without decals";
    expect_validation_clean(test_device());
}

// One sphere that receives none among others that do.
TEST_P(Decals, EachObjectDecidesForItself) {
    DecalGarden garden;
    garden.add_lights(4, 5, 6);
    garden.world.instances[3].receives_decals = false;
    garden.scene.materials[0].receives_decals = false;
    expect_agrees(shot_of(garden));
}

INSTANTIATE_TEST_SUITE_P(
    Architectures, Decals,
    testing::Values(DecalWay{"LightPrepass", "light-prepass", {}}, DecalWay{"Deferred", "deferred", {}},
                    DecalWay{"Multipass", "multipass", {}},
                    DecalWay{"MultipassPerObject", "multipass", {{"ambient", "per-object"}, {"order", "objects"}}},
                    DecalWay{"ZPrepass", "z-prepass", {}}, DecalWay{"ZPrepassGrid", "z-prepass", {{"lights", "grid"}}}),
    [](const auto& tested) { return tested.param.name; });

TEST(DecalSettings, EveryEncodingDepthAndFormAgrees) {
    DecalGarden garden;
    garden.add_lights(5, 5, 6);
    const Settings ways[] = {{{"normals", "oct32"}, {"normal-space", "view"}},
                             {{"normals", "xy16f"}, {"depth", "r32f"}, {"position", "matrix"}},
                             {{"normals", "spherical"}, {"geometry", "two-passes"}, {"light-culling", "stencil"}},
                             {{"normals", "rgb10a2"}, {"depth", "rgba8"}, {"model", "nv"}},
                             {{"light-buffer", "packed-rgba16f"}}};
    for (const Settings& settings : ways) {
        SCOPED_TRACE(settings.begin()->first + "=" + settings.begin()->second);
        Shot shot = garden.shot();
        shot.settings = settings;
        shot.width = 240, shot.height = 135;
        expect_agrees(shot);
    }
    Shot phong = garden.shot();
    phong.shading = Shading::phong;
    phong.exposure = -2;
    expect_agrees(phong);
}

TEST(DecalSettings, AUsersOwnMaterialIsCompiledForThemToo) {
    const auto built_in = find_material_shader("skin");
    const auto own = parse_material_shader("own.glsl", "own.glsl", built_in->source);
    const auto picture = [](const char* renderer, const auto& shader) {
        DecalGarden garden;
        garden.add_lights(3, 5, 6);
        for (size_t m = 1; m < 6; ++m)
            garden.scene.materials[m].shader = shader;
        Shot shot = garden.shot();
        shot.renderer = renderer;
        shot.width = 96, shot.height = 54;
        return render_linear(test_device(), shot);
    };
    for (const char* renderer : {"light-prepass", "deferred", "multipass", "z-prepass"})
        EXPECT_TRUE(picture(renderer, built_in).pixels == picture(renderer, own).pixels) << renderer;
    expect_validation_clean(test_device());
}

TEST(DecalSettings, SharedByAllThatLeavesOutGeometry) {
    DecalGarden garden;
    garden.add_lights(5, 5, 6);
    for (const char* renderer : {"light-prepass", "z-prepass"}) {
        Shot shot = garden.shot();
        shot.renderer = renderer;
        shot.width = 160, shot.height = 90;
        const Image plain = render_linear(test_device(), shot);
        shot.settings = {{"index-trimming", "device"}, {"material-trimming", "depth"}, {"occlusion", "queries"}};
        EXPECT_TRUE(render_linear(test_device(), shot).pixels == plain.pixels) << renderer;
    }
    expect_validation_clean(test_device());
}

/// A wall of unlit grey with two decals of plain colour: what is seen is the equation itself.
struct DecalWall : TestWorld {
    DecalWall() {
        add_material({.name = "wall", .base_colour = {0.5f, 0.5f, 0.5f, 1}, .unlit = true});
        add(square(2));
        add_material({.name = "red", .base_colour = {1, 0, 0, 0.5f}});
        add_material({.name = "blue", .base_colour = {0, 0, 1, 0.25f}});
    }
    void put(uint32_t material, glm::dmat4 box) { world.decals.push_back({{.material = material}, box}); }
    glm::vec3 seen(const char* renderer, uint32_t x, uint32_t y) {
        return render_linear(
                   test_device(),
                   {.world = &world, .camera = front_camera(3), .width = 32, .height = 32, .renderer = renderer})
            .at(x, y);
    }
};

TEST(DecalOrder, LaterOnesAreMixedOverEarlierOnes) {
    for (const char* renderer : {"light-prepass", "deferred", "multipass", "z-prepass"}) {
        DecalWall wall;
        wall.put(1, glm::dmat4(1));
        wall.put(2, glm::dmat4(1));
        const glm::vec3 over = wall.seen(renderer, 16, 16); // ((grey, red), blue)
        EXPECT_NEAR(over.r, 0.75 * 0.75, 1e-3) << renderer;
        EXPECT_NEAR(over.g, 0.75 * 0.25, 1e-3) << renderer;
        EXPECT_NEAR(over.b, 0.75 * 0.25 + 0.25, 1e-3) << renderer;
        std::swap(wall.world.decals[0], wall.world.decals[1]);
        const glm::vec3 under = wall.seen(renderer, 16, 16);
        EXPECT_NEAR(under.r, 0.5 * 0.375 + 0.5, 1e-3) << renderer;
        EXPECT_NEAR(under.b, 0.5 * 0.625, 1e-3) << renderer;
        EXPECT_NEAR(wall.seen(renderer, 2, 2).b, 0.5, 1e-3) << "outside of the box";
    }
    expect_validation_clean(test_device());
}

TEST(DecalOrder, FadesWithTheAngle) {
    const auto red_at = [](double degrees) {
        DecalWall wall;
        wall.put(1, glm::rotate(glm::dmat4(1), glm::radians(degrees), glm::dvec3(0, 1, 0)));
        return (wall.seen("light-prepass", 16, 16).r - 0.5) / 0.25;
    };
    EXPECT_NEAR(red_at(0), 1, 2e-3);
    EXPECT_NEAR(red_at(59), 1, 2e-3);
    const double x = (std::cos(glm::radians(70.0)) - std::cos(1.3962634)) / (0.5 - std::cos(1.3962634));
    EXPECT_NEAR(red_at(70), x * x * (3 - 2 * x), 4e-3);
    EXPECT_NEAR(red_at(81), 0, 2e-3);
    EXPECT_NEAR(red_at(180), 0, 2e-3) << "the back of the box lies on nothing";
}

/// A floor to the horizon with a fine noisy picture, as its own material or as a decal, seen with mip maps.
struct CheckedFloor : TestWorld {
    PlacedCamera camera = look_at({.yfov = 0.8}, {0, 1.2, 5}, {0, 0.4, 0});
    explicit CheckedFloor(bool as_decal, bool with_post = false) {
        std::vector<uint8_t> checks;
        for (uint32_t y = 0; y < 256; ++y)
            for (uint32_t x = 0; x < 256; ++x) {
                const uint32_t h =
                    (x * 73856093u ^ y * 19349663u) * 2654435761u; // noise: each level has another contrast
                const uint8_t c = (x / 16 + y / 16) % 3 == 0 ? 128 : static_cast<uint8_t>(h >> 24);
                checks.insert(checks.end(), {c, c, c, 255});
            }
        Material plain{.name = "floor", .base_colour = {1, 1, 1, 1}, .unlit = true}, checked = plain;
        checked.base_colour_texture = {.image = add_image(256, 256, checks),
                                       .sampler = {.mip = MipFilter::nearest}}; // not anisotropic
        checked.unlit = !as_decal;
        add_material(as_decal ? plain : checked);
        add(square(4), glm::rotate(glm::dmat4(1), -1.5707963267948966, glm::dvec3(1, 0, 0)));
        if (as_decal) {
            add_material(checked);
            world.decals.push_back({{.material = 1},
                                    glm::scale(glm::rotate(glm::dmat4(1), -1.5707963267948966, glm::dvec3(1, 0, 0)),
                                               glm::dvec3(8, 8, 1))});
        }
        if (with_post) {
            add_material({.name = "post", .base_colour = {0, 0, 0.9f, 1}, .unlit = true, .receives_decals = false});
            add(square(0.35f), glm::translate(glm::dmat4(1), {0.2, 0.9, 3.4}));
        }
    }
    Image picture(const char* renderer) {
        RenderOptions options{.width = 320, .height = 180};
        options.views = {"linear"};
        const auto made = create_renderer(renderer, &test_device(), options);
        made->set_world(world);
        made->render(camera);
        return made->read("linear");
    }
};

TEST(DecalTextures, MipLevelsAreThoseOfTheSamePictureOnTheSurface) {
    for (const char* renderer : {"light-prepass", "deferred"}) {
        const Image decal = CheckedFloor(true).picture(renderer), own = CheckedFloor(false).picture(renderer);
        const Comparison c = compare_pixels(decal, own, std::vector<uint8_t>(own.pixels.size(), 0));
        EXPECT_GE(c.psnr, 35) << renderer; // 32 dB when steps between pixels are taken for half as much again
        EXPECT_LE(c.block, 2) << renderer;
        std::printf("    %s: %.1f dB, block %.2f/255\n", renderer, c.psnr, c.block);
    }
}

// lavapipe chooses one level for each 2 × 2 pixels; beyond these nothing knows of the post.
TEST(DecalTextures, NoSeamBesideWhatStandsBefore) {
    const Image without = CheckedFloor(true).picture("light-prepass"),
                with = CheckedFloor(true, true).picture("light-prepass");
    const auto is_post = [&](uint32_t x, uint32_t y) { return with.at(x, y).b > 0.85f && with.at(x, y).r < 0.05f; };
    size_t covered = 0, beside = 0, beyond = 0;
    for (uint32_t y = 0; y < with.height; ++y)
        for (uint32_t x = 0; x < with.width; ++x) {
            const glm::vec3 change = glm::abs(with.at(x, y) - without.at(x, y));
            if (std::max({change.r, change.g, change.b}) < 1.0f / 255)
                continue;
            const uint32_t left = x & ~1u, top = y & ~1u;
            const bool quad =
                is_post(left, top) || is_post(left + 1, top) || is_post(left, top + 1) || is_post(left + 1, top + 1);
            ++(is_post(x, y) ? covered : quad ? beside : beyond);
        }
    EXPECT_GT(covered, 1000u);
    EXPECT_EQ(beyond, 0u) << "pixels of the floor that know of the post; in its quads: " << beside;
}

// The built-in scene at two moments: one of its decals moves, and so does what agrees with the reference.
TEST(DecalScene, AgreesWithTheReferenceWhileItMoves) {
    const Scene scene = make_scene("decals", 6, 1);
    glm::dvec3 before(0);
    for (const double time : {0.7, 2.9}) {
        const World world = resolve(scene, {}, Moment{time});
        EXPECT_NE(glm::dvec3(world.decals.back().transform[3]), before);
        before = glm::dvec3(world.decals.back().transform[3]);
        Shot shot{.world = &world, .camera = world.cameras[0], .width = 360, .height = 202};
        expect_agrees(shot);
        shot.renderer = "deferred";
        shot.settings = {{"g-buffer", "wide"}, {"light-culling", "tiles"}};
        expect_agrees(shot);
    }
}

// Valient's layout stores less: beside the same world without decals it is not farther from the reference's form of it.
TEST(DecalScene, InValientsLayout) {
    const auto psnr = [](bool decals) {
        DecalGarden garden;
        garden.add_lights(6, 5, 6);
        if (!decals)
            garden.world.decals.clear();
        Shot shot = garden.shot();
        shot.renderer = "deferred";
        shot.settings = {{"g-buffer", "killzone2"}};
        const ReferencePicture reference =
            render_reference(*shot.world, shot.camera, shot.width, shot.height, 0,
                             {.fresnel = ReferenceForm::Fresnel::full, .grey_reflectance = true});
        return compare_pixels(render_linear(test_device(), shot), reference.linear, reference.left_out()).psnr;
    };
    const double with = psnr(true), without = psnr(false);
    std::printf("    %.1f dB, %.1f dB without decals\n", with, without);
    EXPECT_GT(with, without - 3);
    expect_validation_clean(test_device());
}

TEST(DecalSettings, ASteadyFrameMakesNothing) {
    DecalGarden garden;
    garden.add_lights(4, 5, 6);
    for (const char* name : {"light-prepass", "deferred", "multipass", "z-prepass"}) {
        Shot shot = garden.shot();
        shot.renderer = name;
        shot.width = 160, shot.height = 90;
        const auto renderer = create_renderer(name, &test_device(), options_of(shot));
        renderer->set_world(garden.world);
        for (int frame = 0; frame < 6; ++frame) { // into one of the boxes and out again
            shot.camera.position = garden.at(-2.4 + 0.2 * frame, 1.2 - 0.35 * frame, 3.5 - 0.4 * frame);
            renderer->render(shot.camera);
            const CreatedObjects made = renderer->stats().created;
            if (frame > 2) {
                EXPECT_EQ(made.allocations + made.pipelines + made.buffers + made.images + made.descriptor_pools, 0u)
                    << name;
            }
        }
    }
    expect_validation_clean(test_device());
}

TEST(DecalErrors, NameTheDecal) {
    const auto error = [](const World& world, const char* renderer) -> std::string {
        try {
            render_linear(
                test_device(),
                {.world = &world, .camera = front_camera(3), .width = 16, .height = 16, .renderer = renderer});
        } catch (const Error& e) {
            return e.what();
        }
        return "none";
    };
    DecalWall wall;
    wall.put(9, glm::dmat4(1));
    EXPECT_THAT(error(wall.world, "light-prepass"), HasSubstr("decal 0: there is no material 9"));
    wall.world.decals[0].decal.material = 1;
    wall.scene.materials[1].shader = find_material_shader("skin");
    EXPECT_THAT(error(wall.world, "deferred"), HasSubstr("decal 0: material 1 has a shader of its own"));
}

} // namespace
} // namespace prelight
