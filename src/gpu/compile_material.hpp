#pragma once
#include <prelight/material_shader.hpp>

namespace prelight::gpu {

/// SPIR-V of a material of a user's own for one of PRELIGHT_MATERIAL_STAGES (shaders/variants.cmake), by that
/// stage's name ("material+bits.frag"). Compiled once and then found in cache_folder(), by its source and all that it
/// is compiled with. Throws Error: the first mistake, "FILE:LINE: REASON".
std::vector<uint32_t> compile_material(const MaterialShader& shader, std::string_view stage);

} // namespace prelight::gpu
