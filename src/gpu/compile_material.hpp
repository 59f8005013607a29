#pragma once
#include "shader_key.hpp"
#include <prelight/material_shader.hpp>

namespace prelight::gpu {

/// SPIR-V of a material of a user's own for a stage that the build compiles with each material. Compiled once and then
/// found in cache_folder(), by its source and all that it is compiled with. Throws Error: the first mistake,
/// "FILE:LINE: REASON".
std::vector<uint32_t> compile_material(const MaterialShader& shader, const ShaderKey& stage);

} // namespace prelight::gpu
