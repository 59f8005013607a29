#include "material_shaders.hpp"
#include <algorithm>
#include <gpu/compile_material.hpp>
#include <gpu/shaders.hpp>

namespace prelight::resident {
namespace {

std::string folder_of(const MaterialShader& shader) {
    std::string name = shader.name.substr(0, shader.name.rfind(".glsl"));
    if (shader.file.empty())
        std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

} // namespace

MaterialShaders::MaterialShaders(const Scene& scene) {
    for (const Material& material : scene.materials) {
        if (std::find(shaders_.begin(), shaders_.end(), material.shader) != shaders_.end())
            continue;
        shaders_.push_back(material.shader);
        names_.push_back(folder_of(*material.shader));
    }
}

uint32_t MaterialShaders::index_of(const Material& material) const {
    return static_cast<uint32_t>(std::find(shaders_.begin(), shaders_.end(), material.shader) - shaders_.begin());
}

std::span<const uint32_t> MaterialShaders::code(uint32_t index, const gpu::ShaderKey& stage) const {
    const MaterialShader& shader = *shaders_[index];
    if (shader.file.empty())
        return gpu::find_shader({stage.file, stage.variants | gpu::Variant::own_material, names_[index]});
    {
        const std::scoped_lock lock(*mutex_);
        if (const auto found = compiled_.find({index, stage}); found != compiled_.end())
            return found->second;
    }
    std::vector<uint32_t> code = gpu::compile_material(shader, stage); // beside other stages
    const std::scoped_lock lock(*mutex_);
    return compiled_.emplace(std::pair(index, stage), std::move(code)).first->second;
}

} // namespace prelight::resident
