#include "gltf_builder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>

using namespace prelight;
using namespace prelight::test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

namespace {

GltfBuilder with_texture(const Bytes& picture) {
    GltfBuilder b = GltfBuilder::textured_triangle();
    b.add_image(picture);
    b.json["textures"] = Json::array({{{"source", 0}}});
    b.json["materials"][0]["emissiveTexture"]["index"] = 0;
    return b;
}

TEST(GltfMaterials, DefaultsAreTheSpecifications) {
    const Material m = GltfBuilder::textured_triangle().load().materials.at(0);
    EXPECT_EQ(m.base_colour, glm::vec4(1));
    EXPECT_EQ(m.metallic, 1);
    EXPECT_EQ(m.roughness, 1);
    EXPECT_EQ(m.emissive, glm::vec3(0));
    EXPECT_EQ(m.alpha_mode, AlphaMode::opaque);
    EXPECT_EQ(m.alpha_cutoff, 0.5f);
    EXPECT_FALSE(m.double_sided || m.unlit || m.base_colour_texture);
}

TEST(GltfMaterials, EveryProperty) {
    GltfBuilder b = GltfBuilder::textured_triangle();
    for (uint8_t i = 0; i < 5; ++i) {
        b.add_image(png(1, 1, solid(1, 1, {i, 0, 0, 255})));
        b.json["textures"].push_back({{"source", 4 - i}});
    }
    b.json["materials"][0] = {
        {"name", "all"},
        {"pbrMetallicRoughness",
         {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}},
          {"metallicFactor", 0.5},
          {"roughnessFactor", 0.6},
          {"baseColorTexture", {{"index", 0}, {"texCoord", 1}}},
          {"metallicRoughnessTexture", {{"index", 1}}}}},
        {"normalTexture", {{"index", 2}, {"scale", 0.7}}},
        {"occlusionTexture", {{"index", 3}, {"strength", 0.8}}},
        {"emissiveTexture", {{"index", 4}}},
        {"emissiveFactor", {0.5, 0.25, 0.125}},
        {"alphaMode", "MASK"},
        {"alphaCutoff", 0.25},
        {"doubleSided", true},
        {"extensions",
         {{"KHR_materials_unlit", Json::object()}, {"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}}}}};
    const Scene scene = b.load();
    const Material& m = scene.materials.at(0);
    EXPECT_EQ(m.name, "all");
    EXPECT_EQ(m.base_colour, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(m.metallic, 0.5f);
    EXPECT_EQ(m.roughness, 0.6f);
    EXPECT_EQ(m.normal_scale, 0.7f);
    EXPECT_EQ(m.occlusion_strength, 0.8f);
    EXPECT_EQ(m.emissive, glm::vec3(4, 2, 1));
    EXPECT_EQ(m.alpha_mode, AlphaMode::mask);
    EXPECT_EQ(m.alpha_cutoff, 0.25f);
    EXPECT_TRUE(m.double_sided && m.unlit);
    EXPECT_EQ(m.base_colour_texture.texcoord, 1u);
    const auto red = [&scene](const TextureRef& ref) { return scene.images.at(ref.image).rgba.at(0); };
    EXPECT_EQ(red(m.base_colour_texture), 4);
    EXPECT_EQ(red(m.metallic_roughness_texture), 3);
    EXPECT_EQ(red(m.normal_texture), 2);
    EXPECT_EQ(red(m.occlusion_texture), 1);
    EXPECT_EQ(red(m.emissive_texture), 0);
}

TEST(GltfMaterials, BlendIsKept) {
    GltfBuilder b = GltfBuilder::textured_triangle();
    b.json["materials"][0]["alphaMode"] = "BLEND";
    const Scene scene = b.load();
    EXPECT_EQ(scene.materials[0].alpha_mode, AlphaMode::blend);
    EXPECT_THAT(scene.warnings, testing::IsEmpty());
}

TEST(GltfMaterials, SamplersOfEveryKind) {
    GltfBuilder b = with_texture(png(1, 1, solid(1, 1, {0, 0, 0, 255})));
    b.json["textures"][0]["sampler"] = 0;
    const auto read = [&b](Json sampler) {
        b.json["samplers"] = Json::array({sampler});
        return b.load().materials[0].emissive_texture.sampler;
    };
    EXPECT_EQ(read(Json::object()), Sampler());
    EXPECT_EQ(read({{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9728}}),
              (Sampler{Wrap::clamp_to_edge, Wrap::mirrored_repeat, Filter::nearest, Filter::nearest, MipFilter::none}));
    const auto min = [&](int filter) { return read({{"minFilter", filter}}); };
    EXPECT_EQ(min(9729), (Sampler{.min = Filter::linear, .mip = MipFilter::none}));
    EXPECT_EQ(min(9984), (Sampler{.min = Filter::nearest, .mip = MipFilter::nearest}));
    EXPECT_EQ(min(9985), (Sampler{.min = Filter::linear, .mip = MipFilter::nearest}));
    EXPECT_EQ(min(9986), (Sampler{.min = Filter::nearest, .mip = MipFilter::linear}));
    EXPECT_EQ(min(9987), (Sampler{.min = Filter::linear, .mip = MipFilter::linear}));
}

TEST(GltfMaterials, TextureTransformTurnsAndOverridesTheSet) {
    GltfBuilder b = with_texture(png(1, 1, solid(1, 1, {0, 0, 0, 255})));
    b.attributes()["TEXCOORD_1"] = b.attributes()["TEXCOORD_0"];
    Json& transform = b.json["materials"][0]["emissiveTexture"]["extensions"]["KHR_texture_transform"];
    // The extension's own example: the lower left quadrant of the image, turned clockwise.
    transform = {{"offset", {0, 1}}, {"rotation", std::numbers::pi / 2}, {"scale", {0.5, 0.5}}, {"texCoord", 1}};
    const TextureRef ref = b.load().materials[0].emissive_texture;
    EXPECT_EQ(ref.texcoord, 1u);
    const auto apply = [&ref](float u, float v) { return ref.uv_linear * glm::vec2(u, v) + ref.uv_offset; };
    EXPECT_NEAR(apply(0, 0).x, 0, 1e-6);
    EXPECT_NEAR(apply(0, 0).y, 1, 1e-6);
    EXPECT_NEAR(apply(1, 0).x, 0, 1e-6);
    EXPECT_NEAR(apply(1, 0).y, 0.5, 1e-6);
    EXPECT_NEAR(apply(1, 1).x, 0.5, 1e-6);
    EXPECT_NEAR(apply(1, 1).y, 0.5, 1e-6);
}

TEST(GltfMaterials, SetsBeyondOneFallBackToZero) {
    GltfBuilder b = with_texture(png(1, 1, solid(1, 1, {0, 0, 0, 255})));
    b.json["materials"][0]["emissiveTexture"]["texCoord"] = 3;
    const Scene scene = b.load();
    EXPECT_EQ(scene.materials[0].emissive_texture.texcoord, 0u);
    EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("beyond set 1")));
}

TEST(GltfMaterials, PngIsReadExactly) {
    const Bytes pixels = {1, 2, 3, 4, 250, 240, 230, 220, 0, 0, 0, 0, 9, 8, 7, 6, 5, 4, 3, 2, 255, 0, 255, 0};
    const TextureImage image = with_texture(png(3, 2, pixels)).load().images.at(0);
    EXPECT_EQ(image.width, 3u);
    EXPECT_EQ(image.height, 2u);
    EXPECT_EQ(image.rgba, pixels);
}

TEST(GltfMaterials, JpegAndLossyWebpAreReadNearly) {
    const Bytes pixels = solid(16, 16, {200, 100, 50, 255});
    for (const Bytes& file : {jpeg(16, 16, pixels), webp_lossy(16, 16, pixels)}) {
        const TextureImage image = with_texture(file).load().images.at(0);
        ASSERT_EQ(image.rgba.size(), pixels.size());
        for (size_t i = 0; i < pixels.size(); ++i)
            ASSERT_NEAR(image.rgba[i], pixels[i], 4) << i;
    }
}

TEST(GltfMaterials, WebpExtensionIsPreferredToItsFallback) {
    const Bytes pixels = {1, 2, 3, 255, 250, 240, 230, 255, 0, 0, 0, 255, 9, 8, 7, 255};
    GltfBuilder b = with_texture({'n', 'o', ' ', 'p', 'i', 'c', 't', 'u', 'r', 'e'});
    b.json["extensionsRequired"] = {"EXT_texture_webp"};
    b.json["textures"][0]["extensions"]["EXT_texture_webp"]["source"] = b.add_image(webp_lossless(2, 2, pixels));
    const Scene scene = b.load();
    EXPECT_THAT(scene.images, SizeIs(1)); // the fallback is not used, so it is not decoded
    EXPECT_EQ(scene.images.at(0).rgba, pixels);
}

TEST(GltfMaterials, ImagesAreDecodedOnceAndOnlyWhenUsed) {
    GltfBuilder b = with_texture(png(1, 1, solid(1, 1, {7, 0, 0, 255})));
    b.add_image(png(1, 1, solid(1, 1, {8, 0, 0, 255})));
    b.json["textures"].push_back({{"source", 0}});
    b.json["materials"][0]["occlusionTexture"]["index"] = 1;
    const Scene scene = b.load();
    EXPECT_THAT(scene.images, SizeIs(1));
    EXPECT_EQ(scene.materials[0].occlusion_texture.image, scene.materials[0].emissive_texture.image);
}

TEST(GltfMaterials, TextureWithoutAReadableImageIsLeftOut) {
    GltfBuilder b = with_texture(png(1, 1, solid(1, 1, {7, 0, 0, 255})));
    b.json["textures"][0] = {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}};
    const Scene scene = b.load();
    EXPECT_FALSE(scene.materials[0].emissive_texture);
    EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("texture 0: has no image")));
}

} // namespace
