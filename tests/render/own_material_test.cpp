// Materials with a shader of their own, built in and a user's, in every architecture.
#include "garden.hpp"
#include <algorithm>
#include <prelight/error.hpp>
#include <prelight/material_shader.hpp>

namespace prelight {
namespace {

using testing::HasSubstr;
using Settings = std::map<std::string, std::string>;

/// The same source as a user's own file: compiled now, not with the build.
std::shared_ptr<const MaterialShader> as_users_own(const char* name) {
    return parse_material_shader("own.glsl", "own.glsl", find_material_shader(name)->source);
}

class OwnMaterial : public testing::TestWithParam<const char*> {};

TEST_P(OwnMaterial, AgreesWithTheReferenceInGgx) {
    const ShadedGarden garden(find_material_shader(GetParam()));
    expect_agrees(garden.shot());
}

TEST_P(OwnMaterial, AgreesWithTheReferenceInPhong) {
    const ShadedGarden garden(find_material_shader(GetParam()));
    Shot shot = garden.shot();
    shot.shading = Shading::phong;
    shot.exposure = -1;
    expect_agrees(shot);
}

TEST_P(OwnMaterial, AgreesWhereLampsAreSummedInALoop) {
    const ShadedGarden garden(find_material_shader(GetParam()));
    Shot shot = garden.shot();
    shot.renderer = "z-prepass"; // six lamps are one draw
    expect_agrees(shot);
    shot.settings = {{"lights", "grid"}};
    expect_agrees(shot);
}

TEST_P(OwnMaterial, AgreesWhereEachLampIsADraw) {
    const ShadedGarden garden(find_material_shader(GetParam()));
    Shot shot = garden.shot();
    shot.renderer = "multipass";
    expect_agrees(shot);
}

TEST_P(OwnMaterial, KeepsInAGBufferWhatNeedsNoLamp) {
    const ShadedGarden garden(find_material_shader(GetParam()));
    Shot shot = garden.shot();
    shot.renderer = "deferred";
    expect_agrees(shot);
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, OwnMaterial,
                         testing::Values("metallic-roughness", "blinn-phong", "skin", "minnaert", "reflection",
                                         "fresnel-rim"),
                         [](const auto& tested) {
                             std::string name = tested.param;
                             name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
                             return name;
                         });

void expect_same_pixels(Shot a, Shot b, const Settings& settings, const char* renderer) {
    a.renderer = b.renderer = renderer;
    a.settings = b.settings = settings;
    a.width = b.width = 128;
    a.height = b.height = 72;
    EXPECT_TRUE(render_linear(test_device(), a).pixels == render_linear(test_device(), b).pixels) << renderer;
}

TEST(UsersOwnMaterial, CompiledAtRunTimeIsTheSamePicture) {
    const ShadedGarden built_in(find_material_shader("skin")), own(as_users_own("skin"));
    for (const char* renderer : {"light-prepass", "multipass", "z-prepass", "deferred"})
        expect_same_pixels(built_in.shot(), own.shot(), {}, renderer);
    expect_same_pixels(built_in.shot(), own.shot(), {{"lights", "grid"}}, "z-prepass");
    for (const Settings& settings : {Settings{{"normals", "oct32"}},
                                     {{"depth", "r32f"}},
                                     {{"normals", "oct32"}, {"depth", "r32f"}},
                                     {{"geometry", "two-passes"}, {"depth", "r32f"}},
                                     {{"light-buffer", "rgba8"}}})
        expect_same_pixels(built_in.shot(), own.shot(), settings, "light-prepass");
    expect_validation_clean(test_device());
}

TEST(UsersOwnMaterial, ReadsItsParametersAndTexturesAndTheMaskDiscards) {
    // Parameters behind each other as std140 has them, a texture in the last slot, alpha from the file.
    const auto shader = parse_material_shader("holes.glsl", "holes.glsl", R"(
PARAMETERS {
    float first DEFAULT(0.25) RANGE(0.0, 1.0);
    vec3 colour DEFAULT(vec3(0.1, 0.2, 0.3)) RANGE(0.0, 1.0);
    float last DEFAULT(0.5) RANGE(0.0, 1.0);
};
TEXTURE_LINEAR(5) stripes DEFAULT(required);
Surface surface(Point p) {
    Surface s = gltf_surface(p);
    s.alpha = texture(stripes, texture_place(p, 5)).r;
    return s;
}
vec3 shade(Point p, Surface s, Light light) { return vec3(first, colour.g, last); }
)");
    TestWorld world;
    Material material{.name = "wall", .alpha_mode = AlphaMode::mask};
    material.shader = shader;
    material.parameters["first"] = glm::vec4(0.75f);
    material.textures["stripes"] = {.image = world.add_image(2, 1, {255, 255, 255, 255, 0, 0, 0, 255}),
                                    .sampler = {.wrap_s = Wrap::clamp_to_edge}};
    world.add_material(material);
    world.add(square(2));
    for (const char* renderer : {"light-prepass", "multipass", "z-prepass", "deferred"}) {
        const Image picture = render_linear(
            test_device(),
            {.world = &world.world, .camera = front_camera(2), .width = 32, .height = 16, .renderer = renderer});
        const glm::vec3 left = picture.at(8, 8), right = picture.at(24, 8);
        EXPECT_NEAR(left.r, 0.75f, 1e-3) << renderer;
        EXPECT_NEAR(left.g, 0.2f, 1e-3) << renderer;
        EXPECT_NEAR(left.b, 0.5f, 1e-3) << renderer;
        EXPECT_EQ(right, glm::vec3(0)) << renderer;
    }
    expect_validation_clean(test_device());
}

std::string mistake_in(const std::string& body) {
    const auto shader = parse_material_shader("toon.glsl", "my/toon.glsl",
                                              "// toon\nSurface surface(Point p) { return gltf_surface(p); }\n" + body);
    try {
        check_material_shader(*shader);
    } catch (const Error& error) {
        return error.what();
    }
    return "nothing";
}

TEST(UsersOwnMaterial, AMistakeNamesTheUsersFileAndLine) {
    const std::string head = "vec3 shade(Point p, Surface s, Light light) {\n";
    EXPECT_EQ(mistake_in(head + "return s.base * stepps;\n}\n"), "my/toon.glsl:4: 'stepps' : undeclared identifier");
    EXPECT_THAT(mistake_in(head + "return s.base\n}\n"), HasSubstr("my/toon.glsl:5: "));
    EXPECT_THAT(mistake_in("#include \"shared/no.glsl\"\n" + head + "return s.base;\n}\n"),
                HasSubstr("my/toon.glsl:3: "));
    EXPECT_EQ(mistake_in(head + "return s.base;\n}\n"), "nothing");
}

TEST(OwnMaterialErrors, AreTold) {
    ShadedGarden garden(find_material_shader("skin"));
    garden.set("roll_off", glm::vec4(3));
    const auto error_of = [&](const Shot& shot) -> std::string {
        try {
            render_linear(test_device(), shot);
        } catch (const Error& error) {
            return error.what();
        }
        return "nothing";
    };
    EXPECT_THAT(error_of(garden.shot()),
                HasSubstr("material 1 (clay): parameter roll_off of skin: 3 is outside 0 … 2"));
    const ShadedGarden own(as_users_own("skin"));
    try {
        render_reference(own.world, own.camera, 16, 9, 0, {});
        ADD_FAILURE() << "the reference knows no GLSL";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("own.glsl"));
    }
    ShadedGarden narrow(find_material_shader("reflection"));
    auto environment = std::make_shared<Environment>(Environment{.name = "sky.exr", .image = Image(4, 4)});
    narrow.scene.environment = environment;
    EXPECT_THAT(error_of(narrow.shot()),
                HasSubstr("sky.exr: an environment map is twice as wide as high, and this one has 4x4"));
    environment->image = Image(4, 2);
    environment->image.at(1, 1).g = -1;
    EXPECT_THAT(error_of(narrow.shot()), HasSubstr("sky.exr: a pixel of the environment map is negative"));
}

} // namespace
} // namespace prelight
