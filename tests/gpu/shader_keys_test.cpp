// Every shader that a pass may ask for is in the build: all keys that passes make of their inputs.
#include <algorithm>
#include <fstream>
#include <gpu/shaders.hpp>
#include <gtest/gtest.h>
#include <map>
#include <passes/lighting.hpp>
#include <prelight/error.hpp>
#include <prelight/material_shader.hpp>
#include <sstream>
#include <string_view>

namespace prelight {
namespace {

using gpu::ShaderKey;
using gpu::Variant;

void expect_shader(const ShaderKey& key) { EXPECT_TRUE(gpu::has_shader(key)) << key.text(); }

TEST(ShaderKeys, TheTableIsSortedAndHoldsWhatItNames) {
    const auto place = [](const auto& s) { return std::tuple(s.file, s.material, s.variants); };
    const std::span<const gpu::EmbeddedShader> all = gpu::all_shaders();
    ASSERT_GT(all.size(), 100u);
    for (size_t i = 0; i < all.size(); ++i) {
        if (i > 0) {
            EXPECT_LT(place(all[i - 1]), place(all[i]));
        }
        const ShaderKey key(std::string(all[i].file), gpu::Variants::from_bits(all[i].variants),
                            std::string(all[i].material));
        const std::span<const uint32_t> code = gpu::find_shader(key);
        ASSERT_EQ(code.size(), all[i].words);
        EXPECT_EQ(code[0], 0x07230203u) << key.text() << ": SPIR-V's magic number";
    }
}

TEST(ShaderKeys, WhatComesOutTheSameIsStoredOnce) {
    std::map<std::string_view, const uint32_t*> places;
    size_t shared = 0;
    for (const gpu::EmbeddedShader& one : gpu::all_shaders()) {
        const ShaderKey key(std::string(one.file), gpu::Variants::from_bits(one.variants), std::string(one.material));
        const std::span<const uint32_t> code = gpu::find_shader(key);
        const auto [place, is_new] = places.emplace(
            std::string_view(reinterpret_cast<const char*>(code.data()), code.size_bytes()), code.data());
        EXPECT_EQ(place->second, code.data()) << key.text();
        shared += !is_new;
    }
    EXPECT_GT(shared, 0u)
        << "a material that leaves normals as they are writes depth and normal as the built-in one does";
}

// A shader takes another pass's value where two constants share a number.
TEST(ShaderKeys, EachConstantHasANumberOfItsOwn) {
    std::ifstream file(PRELIGHT_SOURCE_DIR "/shaders/shared/bindings.h");
    std::map<int, std::string> names;
    std::string define, name;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        int number = 0;
        if (words >> define >> name >> number && define == "#define" && name.starts_with("CONSTANT_")) {
            const auto [found, is_new] = names.emplace(number, name);
            EXPECT_TRUE(is_new) << name << " and " << found->second << " are both " << number;
        }
    }
    EXPECT_GT(names.size(), 50u);
}

TEST(ShaderKeys, AnotherCombinationIsAnErrorThatNamesIt) {
    try {
        gpu::find_shader({"light.frag", Variant::count_target | Variant::shadows});
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "shader light.frag COUNT_TARGET SHADOWS: not one of this build's");
    }
    EXPECT_THROW(gpu::find_shader("lights.frag"), Error);
}

TEST(ShaderKeys, WhatNoPassAsksForIsNotThere) {
    for (const gpu::Variants own : {gpu::Variants(), gpu::Variants(Variant::own_material)}) // decals of several samples
        EXPECT_FALSE(gpu::has_shader(
            {"material.frag", own | Variant::sample_light | Variant::decals, own.empty() ? "" : "skin"}));
}

TEST(ShaderKeys, OfPassesThatEvaluateLights) {
    for (const gpu::Variants target :
         {gpu::Variants(), gpu::Variants(Variant::one_target), gpu::Variants(Variant::light_pair),
          gpu::Variants(Variant::count_target), gpu::Variants(Variant::deferred_target)})
        for (const bool shadows : {false, true})
            for (const bool stencil : {false, true})
                for (const bool added : {false, true}) {
                    passes::LightingInputs inputs;
                    inputs.target.variant = target;
                    inputs.target.added = added;
                    inputs.surface.format.roughness_in_stencil = stencil;
                    if (shadows)
                        inputs.shadows.atlas = graph::ImageId{1};
                    if (stencil && inputs.target.deferred())
                        continue; // a G-buffer has room for roughness
                    const bool pair = target.has(Variant::light_pair);
                    if (!added || !inputs.target.deferred()) // its target is kept, not added to
                        expect_shader(passes::lighting_shader(inputs, "light_list.comp"));
                    if (!inputs.target.deferred())
                        expect_shader({"light_list_clear.comp", target});
                    if (!stencil && !inputs.target.counts()) { // light of edge pixels' samples
                        passes::LightingInputs samples = inputs;
                        samples.edges.emplace();
                        expect_shader(passes::lighting_shader(samples, "light_list.comp"));
                        if (!added && !pair)
                            for (const char* file : {"light_list.frag", "light_loop.frag"})
                                expect_shader(passes::lighting_shader(samples, file));
                    }
                    if (added || pair)
                        continue; // of the compute pass
                    expect_shader(passes::lighting_shader(inputs, "light.frag"));
                    expect_shader(passes::lighting_shader(inputs, "light_list.frag"));
                    if (!inputs.target.deferred())
                        expect_shader(passes::lighting_shader(inputs, "light_loop.frag"));
                    if (!inputs.target.deferred() && !inputs.target.counts())
                        expect_shader({"light_ambient.frag", target});
                    if (target.empty() || inputs.target.deferred())
                        expect_shader(passes::lighting_shader(inputs, "light_peaks.comp"));
                }
}

TEST(ShaderKeys, OfPassesThatDrawObjectsWithEachMaterial) {
    std::vector<std::string> materials;
    for (const auto& shader : built_in_material_shaders())
        materials.push_back(shader->name);
    ASSERT_GT(materials.size(), 3u);
    for (std::string material : materials) {
        std::replace(material.begin(), material.end(), '-', '_');
        const auto own = [&](const char* file, gpu::Variants variants) {
            expect_shader({file, variants | Variant::own_material, material});
        };
        for (const gpu::Variants shadows : {gpu::Variants(), gpu::Variants(Variant::shadows)})
            own("forward_grid.frag", shadows | Variant::weighted);
        for (const bool decals : {false, true}) {
            const gpu::Variants with = gpu::when(decals, Variant::decals);
            for (const gpu::Variants shadows : {gpu::Variants(), gpu::Variants(Variant::shadows)}) {
                own("forward.frag", with | shadows);
                own("forward_grid.frag", with | shadows);
            }
            own("forward_base.frag", with);
            for (const gpu::Variants occlusion : {gpu::Variants(), gpu::Variants(Variant::occlusion)}) {
                own("gbuffer_fill.frag", with | occlusion);
                for (const gpu::Variants texels :
                     {gpu::Variants(), gpu::Variants(Variant::light_bits), gpu::Variants(Variant::light_pair)})
                    own("material.frag", with | occlusion | texels);
            }
            for (const gpu::Variants roughness : {gpu::Variants(), gpu::Variants(Variant::roughness_target),
                                                  gpu::Variants(Variant::stencil_roughness)}) {
                own("depth_normal.frag", with | roughness);
                own("depth_normal.frag", roughness | Variant::depth_target);
            }
        }
        own("depth_normal.frag", Variant::no_normal_target | Variant::depth_target);
        own("material.frag", Variant::sample_light);
        own("material.frag", Variant::sample_light | Variant::decals | Variant::samples);
        own("depth_mask.frag", {});
    }
    for (const gpu::Variants world : {gpu::Variants(), gpu::Variants(Variant::no_world)})
        for (const gpu::Variants normal : {gpu::Variants(), gpu::Variants(Variant::no_normal)})
            for (const gpu::Variants textures : {gpu::Variants(), gpu::Variants(Variant::no_textures)})
                expect_shader({"surface.vert", world | normal | textures});
}

} // namespace
} // namespace prelight
