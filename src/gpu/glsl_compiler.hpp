#pragma once
#include "shader_key.hpp"
#include <fmt/format.h>
#include <glslang/build_info.h>
#include <shaderc/shaderc.hpp>
#include <spirv-tools/libspirv.h>
#include <string>

namespace prelight::gpu {

/// How GLSL becomes SPIR-V, whether the build compiles a shader or the program a custom material; without an includer.
inline shaderc::CompileOptions glsl_options(const ShaderKey& key, bool optimized = true) {
    shaderc::CompileOptions options;
    options.SetTargetEnvironment(shaderc_target_env_vulkan, shaderc_env_version_vulkan_1_3);
    options.SetOptimizationLevel(optimized ? shaderc_optimization_level_performance : shaderc_optimization_level_zero);
    for (const std::string_view macro : key.variants.macros())
        options.AddMacroDefinition(std::string(macro));
    return options;
}

/// What of that decides what comes out beside source and macros: compiler and options, for keys of caches.
inline std::string glsl_compiler_name(bool optimized = true) {
    return fmt::format("glslang {}.{}.{}, {}, vulkan1.3 {}", GLSLANG_VERSION_MAJOR, GLSLANG_VERSION_MINOR,
                       GLSLANG_VERSION_PATCH, spvSoftwareVersionDetailsString(), optimized ? "-O" : "-O0");
}

} // namespace prelight::gpu
