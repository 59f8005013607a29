#include "built_in.hpp"
#include <algorithm>
#include <prelight/material_shader.hpp>

namespace prelight {

const std::vector<std::shared_ptr<const MaterialShader>>& built_in_material_shaders() {
    static const auto all = [] {
        std::vector<std::shared_ptr<const MaterialShader>> shaders;
        for (const auto& [file, text] : materials::built_in_sources()) {
            std::string name(file);
            std::replace(name.begin(), name.end(), '_', '-');
            shaders.push_back(parse_material_shader(name, {}, std::string(text)));
        }
        return shaders;
    }();
    return all;
}

std::shared_ptr<const MaterialShader> find_material_shader(std::string_view name) {
    for (const auto& shader : built_in_material_shaders())
        if (shader->name == name)
            return shader;
    return nullptr;
}

} // namespace prelight
