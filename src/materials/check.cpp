#include <fmt/format.h>
#include <fmt/ranges.h>
#include <prelight/error.hpp>
#include <prelight/material_shader.hpp>

namespace prelight {
namespace {

template <class Declared>
std::string names_of(const std::vector<Declared>& declared) {
    std::vector<std::string_view> names;
    for (const Declared& d : declared)
        names.push_back(d.name);
    return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

} // namespace

bool transmits(const Material& material) {
    if (!material.shader || material.shader->name != "layered" || !material.shader->file.empty() || material.unlit)
        return false;
    const auto factor = material.parameters.find("transmission");
    return factor != material.parameters.end() && factor->second.x > 0;
}

std::optional<std::string> material_fault(const Material& material) {
    if (!material.shader)
        return {};
    const MaterialShader& shader = *material.shader;
    for (const auto& [name, value] : material.parameters) {
        const MaterialParameter* parameter = shader.find_parameter(name);
        if (!parameter)
            return fmt::format("{} has no parameter {} ({})", shader.name, name, names_of(shader.parameters));
        for (uint32_t c = 0; c < parameter->components; ++c)
            if (const float v = value[static_cast<int>(c)]; !(v >= parameter->low && v <= parameter->high))
                return fmt::format("parameter {} of {}: {} is outside {} … {}", name, shader.name, v, parameter->low,
                                   parameter->high);
    }
    for (const auto& [name, texture] : material.textures)
        if (!shader.find_texture(name))
            return fmt::format("{} has no texture {} ({})", shader.name, name, names_of(shader.textures));
    for (const MaterialTexture& texture : shader.textures)
        if (texture.stand_in == MaterialTexture::StandIn::required) {
            const auto found = material.textures.find(texture.name);
            if (found == material.textures.end() || !found->second)
                return fmt::format("{} needs a texture {}", shader.name, texture.name);
        }
    return {};
}

void check_material(const Material& material, const std::string& object) {
    if (const auto fault = material_fault(material))
        throw Error(fmt::format("{}: {}", object, *fault));
}

} // namespace prelight
