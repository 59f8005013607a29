// What stands at a shader's top is what the build compiles.
#include <compile_shaders/axes.hpp>
#include <gtest/gtest.h>
#include <stdexcept>

namespace prelight {
namespace {

std::vector<std::string> keys_of(const char* source) {
    std::vector<std::string> out;
    for (const gpu::ShaderKey& key : all_keys("a.frag", read_axes(source), {"skin", "velvet"}))
        out.push_back(key.text());
    return out;
}
using Keys = std::vector<std::string>;

TEST(ShaderAxes, WithoutAnyThereIsOneShader) { EXPECT_EQ(keys_of("#version 460\nvoid main() {}\n"), Keys{"a.frag"}); }

TEST(ShaderAxes, OneOfAChoiceOrNoneTimesEachOther) {
    EXPECT_EQ(keys_of("#version 460\n// variants: ONE_TARGET|COUNT_TARGET, SHADOWS\n"),
              (Keys{"a.frag", "a.frag SHADOWS", "a.frag ONE_TARGET", "a.frag ONE_TARGET SHADOWS", "a.frag COUNT_TARGET",
                    "a.frag COUNT_TARGET SHADOWS"}));
}

TEST(ShaderAxes, WhatNeverComesTogetherAndWhatComesOnlyWithAnother) {
    EXPECT_EQ(keys_of("// variants: ONE_TARGET, SHADOWS, DECALS\n// never: ONE_TARGET SHADOWS\n"
                      "// only: DECALS with SHADOWS\n"),
              (Keys{"a.frag", "a.frag SHADOWS", "a.frag SHADOWS DECALS", "a.frag ONE_TARGET"}));
    EXPECT_EQ(keys_of("// variants: DECALS|SOFT, SAMPLES\n// only: SAMPLES with DECALS|SOFT\n"),
              (Keys{"a.frag", "a.frag DECALS", "a.frag DECALS SAMPLES", "a.frag SOFT", "a.frag SAMPLES SOFT"}));
}

TEST(ShaderAxes, OnceForEachMaterial) {
    EXPECT_EQ(keys_of("// variants: OWN_MATERIAL|ONLY_WEIGHTED\n"
                      "// materials: all with OWN_MATERIAL, blinn_phong with ONLY_WEIGHTED\n"),
              (Keys{"a.frag", "skin/a.frag OWN_MATERIAL", "velvet/a.frag OWN_MATERIAL",
                    "blinn_phong/a.frag ONLY_WEIGHTED", "a.frag ONLY_WEIGHTED"}));
}

TEST(ShaderAxes, ForOneMaterialAlone) {
    EXPECT_EQ(keys_of("// variants: OWN_MATERIAL, SHADOWS\n"
                      "// materials: all with OWN_MATERIAL, only skin with OWN_MATERIAL SHADOWS\n"),
              (Keys{"a.frag", "a.frag SHADOWS", "skin/a.frag OWN_MATERIAL", "velvet/a.frag OWN_MATERIAL",
                    "skin/a.frag SHADOWS OWN_MATERIAL"}));
}

TEST(ShaderAxes, OtherCommentsAreNoAxes) {
    EXPECT_EQ(keys_of("// Two variants: none of this counts\n// note: SHADOWS\n"), Keys{"a.frag"});
    EXPECT_EQ(keys_of("#version 460\nvoid main() {}\n// variants: SHADOWS\n"), Keys{"a.frag"}) << "not at the top";
}

TEST(ShaderAxes, AnUnknownVariantIsNamed) {
    for (const char* line : {"// variants: SHADOW", "// never: SHADOWS SHADOW", "// only: SHADOW with SHADOWS",
                             "// materials: all with SHADOW"})
        try {
            read_axes(line);
            ADD_FAILURE() << line;
        } catch (const std::runtime_error& error) {
            EXPECT_NE(std::string(error.what()).find("no variant SHADOW"), std::string::npos) << error.what();
        }
    EXPECT_THROW(read_axes("// only: SHADOWS"), std::runtime_error);
}

} // namespace
} // namespace prelight
