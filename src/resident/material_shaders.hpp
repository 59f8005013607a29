#pragma once
#include <cstdint>
#include <map>
#include <prelight/material_shader.hpp>
#include <prelight/scene.hpp>
#include <span>
#include <string>
#include <vector>

namespace prelight::resident {

/// The shaders that a scene's materials are shaded with: 0 is the renderer's own, the others come in the order
/// of the materials. What is not built in is compiled once a stage, when it is asked for.
class MaterialShaders {
public:
    MaterialShaders() = default;
    explicit MaterialShaders(const Scene& scene);
    uint32_t index_of(const Material& material) const;
    /// Its file's name without ".glsl", which is the folder of what shaders/variants.cmake lists for it.
    const std::string& name(uint32_t shader) const { return names_[shader]; }
    /// SPIR-V for a stage of PRELIGHT_MATERIAL_STAGES. Throws Error: a mistake in a user's file.
    std::span<const uint32_t> code(uint32_t shader, const std::string& stage) const;

private:
    std::vector<std::shared_ptr<const MaterialShader>> shaders_{nullptr};
    std::vector<std::string> names_{""};
    mutable std::map<std::pair<uint32_t, std::string>, std::vector<uint32_t>> compiled_;
};

} // namespace prelight::resident
