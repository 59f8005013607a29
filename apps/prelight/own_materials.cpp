#include "own_materials.hpp"

#include <fmt/format.h>
#include <prelight/error.hpp>

namespace prelight::app {
OwnMaterials::OwnMaterials(const Files& files) : files_(files) {
    for (const auto& [name, file] : files)
        shaders_.push_back(load_material_shader(file));
}

void OwnMaterials::check() const {
    for (const auto& shader : shaders_)
        check_material_shader(*shader);
}

std::vector<std::string> OwnMaterials::take_changes() {
    std::vector<std::string> mistakes;
    for (size_t i = 0; i < files_.size(); ++i) {
        try {
            auto shader = load_material_shader(files_[i].second);
            if (shader->source == shaders_[i]->source)
                continue;
            check_material_shader(*shader);
            shaders_[i] = std::move(shader);
        } catch (const Error& error) {
            mistakes.push_back(fmt::format("{}; {} stays as it was", error.what(), escaped(files_[i].first)));
        }
    }
    return mistakes;
}

void OwnMaterials::assign(Scene& scene) const {
    for (size_t i = 0; i < files_.size(); ++i)
        assign_material_shader(scene, files_[i].first, shaders_[i]);
}

} // namespace prelight::app
