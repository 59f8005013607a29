// SPIR-V that was made to run once a sample, or to know its coverage after the depth test, is still valid SPIR-V.
#include <algorithm>
#include <gpu/sample_shading.hpp>
#include <gpu/shaders.hpp>
#include <gtest/gtest.h>
#include <set>
#include <spirv-tools/libspirv.hpp>

namespace prelight {
namespace {

using gpu::Variant;
using Code = std::vector<uint32_t>;

/// What the validator says against it; empty: nothing.
std::string faults_of(const Code& code) {
    std::string faults;
    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_3);
    tools.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t& at, const char* message) {
        faults += std::to_string(at.index) + ": " + message + "\n";
    });
    if (!tools.Validate(code) && faults.empty())
        faults = "not valid";
    return faults;
}

/// As text, an instruction a line.
std::string text_of(const Code& code) {
    std::string text;
    spvtools::SpirvTools(SPV_ENV_VULKAN_1_3).Disassemble(code, &text, SPV_BINARY_TO_TEXT_OPTION_NO_HEADER);
    return text;
}

Code assembled(const std::string& text) {
    Code code;
    EXPECT_TRUE(spvtools::SpirvTools(SPV_ENV_VULKAN_1_3).Assemble(text, &code));
    return code;
}

size_t times(const std::string& text, const std::string& what) {
    size_t count = 0;
    for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + what.size()))
        ++count;
    return count;
}

/// Reads an interpolated input, a flat one, one that is per sample already and a built-in one.
std::string shader(const std::string& capabilities = "") {
    return "OpCapability Shader\n" + capabilities +
           "OpMemoryModel Logical GLSL450\n"
           "OpEntryPoint Fragment %main \"main\" %smooth %flat %each %place %out\n"
           "OpExecutionMode %main OriginUpperLeft\n"
           "OpDecorate %smooth Location 0\n"
           "OpDecorate %flat Location 1\n"
           "OpDecorate %flat Flat\n"
           "OpDecorate %each Sample\n"
           "OpDecorate %each Location 2\n"
           "OpDecorate %place BuiltIn FragCoord\n"
           "OpDecorate %out Location 0\n"
           "%void = OpTypeVoid\n%f = OpTypeFloat 32\n%v = OpTypeVector %f 4\n"
           "%in_v = OpTypePointer Input %v\n%out_v = OpTypePointer Output %v\n%fn = OpTypeFunction %void\n"
           "%smooth = OpVariable %in_v Input\n%flat = OpVariable %in_v Input\n%each = OpVariable %in_v Input\n"
           "%place = OpVariable %in_v Input\n%out = OpVariable %out_v Output\n"
           "%main = OpFunction %void None %fn\n%begin = OpLabel\n%a = OpLoad %v %smooth\nOpStore %out %a\n"
           "OpReturn\nOpFunctionEnd\n";
}
constexpr const char* has_samples = "OpCapability SampleRateShading\n";

TEST(SampleShading, OnceASampleDecoratesWhatIsInterpolatedAndNothingElse) {
    const Code code = assembled(shader(has_samples)), made = gpu::with_sample_inputs(code);
    EXPECT_EQ(faults_of(code), "");
    EXPECT_EQ(faults_of(made), "");
    EXPECT_EQ(times(text_of(made), " Sample\n"), 2u) << text_of(made);
    EXPECT_EQ(times(text_of(made), "SampleRateShading"), 1u) << "it was there";
    EXPECT_EQ(made.size(), code.size() + 3);
    std::string plain = shader();
    plain.replace(plain.find("OpDecorate %each Sample\n"), 24, "");
    const std::string text = text_of(gpu::with_sample_inputs(assembled(plain)));
    EXPECT_EQ(times(text, " Sample\n"), 2u) << text;
    EXPECT_EQ(times(text, "OpCapability SampleRateShading\n"), 1u) << text;
    EXPECT_EQ(faults_of(assembled(text)), "");
}

// All that draws objects, with the materials that are built in, as the build compiled it.
TEST(SampleShading, EveryShaderOfObjectsStaysValid) {
    const std::set<std::string_view> files{"material.frag",     "forward.frag",      "forward_grid.frag",
                                           "forward_base.frag", "gbuffer_fill.frag", "depth_normal.frag"};
    size_t seen = 0;
    for (const gpu::EmbeddedShader& one : gpu::all_shaders()) {
        if (!files.contains(one.file) || (!one.material.empty() && one.material != "skin"))
            continue;
        const gpu::ShaderKey key(std::string(one.file), gpu::Variants::from_bits(one.variants),
                                 std::string(one.material));
        if (key.variants.has(Variant::stencil_roughness) || key.variants.has(Variant::decals))
            continue; // fewer are enough
        ++seen;
        EXPECT_EQ(faults_of(gpu::with_sample_inputs(gpu::find_shader(key))), "") << key.text();
    }
    EXPECT_GT(seen, 20u);
}

TEST(SampleShading, CoverageAfterTheDepthTestIsTwoModesAndACapability) {
    const Code code = assembled(shader(has_samples)), made = gpu::with_post_depth_coverage(code);
    const std::string text = text_of(made);
    EXPECT_EQ(faults_of(made), "");
    EXPECT_EQ(times(text, "OpCapability SampleMaskPostDepthCoverage\n"), 1u) << text;
    EXPECT_EQ(times(text, "OpExtension \"SPV_KHR_post_depth_coverage\"\n"), 1u) << text;
    EXPECT_EQ(times(text, " EarlyFragmentTests\n"), 1u) << text;
    EXPECT_EQ(times(text, " PostDepthCoverage\n"), 1u) << text;
    std::string early = shader(has_samples);
    early.insert(early.find("OpDecorate"), "OpExecutionMode %main EarlyFragmentTests\n");
    const std::string same = text_of(gpu::with_post_depth_coverage(assembled(early)));
    EXPECT_EQ(same, text) << "it tested early by itself";
}

// The material pass of edge pixels, as the build compiled it.
TEST(SampleShading, EveryMaterialOfEdgePixelsMayKnowItsCoverageAfterTheDepthTest) {
    size_t seen = 0;
    for (const gpu::EmbeddedShader& one : gpu::all_shaders()) {
        const gpu::ShaderKey key(std::string(one.file), gpu::Variants::from_bits(one.variants),
                                 std::string(one.material));
        if (one.file != "material.frag" || !key.variants.has(Variant::sample_light) ||
            key.variants.has(Variant::decals) || (!one.material.empty() && one.material != "skin"))
            continue;
        ++seen;
        EXPECT_EQ(faults_of(gpu::with_post_depth_coverage(gpu::find_shader(key))), "") << key.text();
    }
    EXPECT_GT(seen, 4u);
}

} // namespace
} // namespace prelight
