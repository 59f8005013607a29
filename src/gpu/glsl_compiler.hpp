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

/// spirv-opt's passes that take out names, and functions, variables and code that nothing needs. Functions are not
/// inlined: drivers do that anyway, and with it this takes ten times as long (docs/notes/performance-log.md#shaders).
inline const std::vector<std::string> spirv_passes = {
    "--strip-debug",
    "--eliminate-dead-branches",
    "--eliminate-dead-functions",
    "--private-to-local",
    "--eliminate-local-single-block",
    "--eliminate-local-single-store",
    "--eliminate-dead-code-aggressive",
    "--scalar-replacement=100",
    "--ssa-rewrite",
    "--ccp",
    "--eliminate-dead-branches",
    "--simplify-instructions",
    "--eliminate-dead-code-aggressive",
    "--merge-blocks",
};

inline std::vector<uint32_t> optimize_spirv(std::span<const uint32_t> code) {
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_3);
    spvtools::OptimizerOptions options;
    options.set_run_validator(false); // the compiler's output, not a file's
    std::vector<uint32_t> out;
    if (!optimizer.RegisterPassesFromFlags(spirv_passes) || !optimizer.Run(code.data(), code.size(), &out, options))
        throw Error("SPIR-V of the GLSL compiler cannot be optimised");
    return out;
}

/// What beside source and macros decides what comes out: the compiler, its options and the passes above, for keys of
/// caches.
inline std::string glsl_compiler_name() {
    return fmt::format("glslang {}.{}.{}, {}, vulkan1.3, {}", GLSLANG_VERSION_MAJOR, GLSLANG_VERSION_MINOR,
                       GLSLANG_VERSION_PATCH, spvSoftwareVersionDetailsString(), fmt::join(spirv_passes, " "));
}

} // namespace prelight::gpu
