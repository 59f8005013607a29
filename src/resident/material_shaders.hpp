#pragma once
#include <cstdint>
#include <gpu/shader_key.hpp>
#include <map>
#include <memory>
#include <mutex>
#include <prelight/material_shader.hpp>
#include <prelight/scene.hpp>
#include <span>
#include <string>
#include <vector>

namespace prelight::resident {

/// The shaders that a scene's materials are shaded with: 0 is the renderer's own, the others come in the order
/// of the materials. What is not built in is compiled once a stage, when it is asked for, by any thread.
class MaterialShaders {
public:
    MaterialShaders() = default;
    explicit MaterialShaders(const Scene& scene);
    uint32_t index_of(const Material& material) const;
    /// Its file's name without ".glsl": ShaderKey::material.
    const std::string& name(uint32_t shader) const { return names_[shader]; }
    /// SPIR-V for a stage that the build compiles with each material. Throws Error: a mistake in a user's file.
    std::span<const uint32_t> code(uint32_t shader, const gpu::ShaderKey& stage) const;

private:
    std::vector<std::shared_ptr<const MaterialShader>> shaders_{nullptr};
    std::vector<std::string> names_{""};
    mutable std::map<std::pair<uint32_t, gpu::ShaderKey>, std::vector<uint32_t>> compiled_;
    std::unique_ptr<std::mutex> mutex_ = std::make_unique<std::mutex>(); ///< of `compiled_`
};

} // namespace prelight::resident
