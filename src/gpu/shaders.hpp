#pragma once
#include "shader_key.hpp"
#include <span>

namespace prelight::gpu {

/// SPIR-V that this build holds. Throws Error for a key that the shader's axes do not allow.
std::span<const uint32_t> find_shader(const ShaderKey& key);

/// One shader of a build: a row of the tables that tools/compile_shaders writes, in the order of (file, material,
/// variants).
struct EmbeddedShader {
    std::string_view file, material;
    uint64_t variants = 0;         ///< Variants::bits()
    uint32_t first = 0, words = 0; ///< of the code
};
/// Every shader that find_shader() finds.
std::span<const EmbeddedShader> all_shaders();
bool has_shader(const ShaderKey& key);

/// For the generated tables: empty where the table has no such shader.
std::span<const uint32_t> find_embedded(std::span<const EmbeddedShader> table, const uint32_t* code,
                                        const ShaderKey& key);

} // namespace prelight::gpu
