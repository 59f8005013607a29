#pragma once
#include "shader_key.hpp"
#include <fmt/format.h>
#include <glslang/build_info.h>
#include <prelight/error.hpp>
#include <shaderc/shaderc.hpp>
#include <span>
#include <spirv-tools/libspirv.h>
#include <spirv-tools/optimizer.hpp>
#include <string>
#include <vector>

namespace prelight::gpu {

/// How GLSL becomes SPIR-V, whether the build compiles a shader or the program a custom material; without an includer.
inline shaderc::CompileOptions glsl_options(const ShaderKey& key) {
    shaderc::CompileOptions options;
    options.SetTargetEnvironment(shaderc_target_env_vulkan, shaderc_env_version_vulkan_1_3);
    options.SetOptimizationLevel(shaderc_optimization_level_zero);
    for (const std::string_view macro : key.variants.macros())
        options.AddMacroDefinition(std::string(macro));
    return options;
}

/// The same SPIR-V without names and without functions, variables and code that nothing needs. Functions are not
/// inlined: drivers do that anyway, and with it this takes ten times as long (docs/notes/performance-log.md#shaders).
inline std::vector<uint32_t> optimize_spirv(std::span<const uint32_t> code) {
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_3);
    optimizer.RegisterPass(spvtools::CreateStripDebugInfoPass())
        .RegisterPass(spvtools::CreateDeadBranchElimPass())
        .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
        .RegisterPass(spvtools::CreatePrivateToLocalPass())
        .RegisterPass(spvtools::CreateLocalSingleBlockLoadStoreElimPass())
        .RegisterPass(spvtools::CreateLocalSingleStoreElimPass())
        .RegisterPass(spvtools::CreateAggressiveDCEPass())
        .RegisterPass(spvtools::CreateScalarReplacementPass(100))
        .RegisterPass(spvtools::CreateSSARewritePass())
        .RegisterPass(spvtools::CreateCCPPass())
        .RegisterPass(spvtools::CreateDeadBranchElimPass())
        .RegisterPass(spvtools::CreateSimplificationPass())
        .RegisterPass(spvtools::CreateAggressiveDCEPass())
        .RegisterPass(spvtools::CreateBlockMergePass());
    spvtools::OptimizerOptions options;
    options.set_run_validator(false); // the compiler's output, not a file's
    std::vector<uint32_t> out;
    if (!optimizer.Run(code.data(), code.size(), &out, options))
        throw Error("SPIR-V of the GLSL compiler cannot be optimised");
    return out;
}

/// What beside source and macros decides what comes out: the compiler, its options and the passes above, for keys of
/// caches.
inline std::string glsl_compiler_name() {
    return fmt::format("glslang {}.{}.{}, {}, vulkan1.3, optimize_spirv 1", GLSLANG_VERSION_MAJOR,
                       GLSLANG_VERSION_MINOR, GLSLANG_VERSION_PATCH, spvSoftwareVersionDetailsString());
}

} // namespace prelight::gpu
