#include "commands.hpp"
#include "options/suggestion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <prelight/error.hpp>
#include <prelight/material_shader.hpp>

namespace prelight::app {
namespace {

std::string value_text(const MaterialParameter& parameter) {
    std::string text;
    for (uint32_t c = 0; c < parameter.components; ++c)
        text += fmt::format("{}{}", c > 0 ? ", " : "", parameter.default_value[static_cast<int>(c)]);
    return parameter.components > 1 ? "[" + text + "]" : text;
}

void print(const MaterialShader& shader) {
    constexpr const char* stand_ins[]{"white without", "black without", "flat without", "required"};
    fmt::print("{}: {}\n", shader.name, shader.description);
    for (const MaterialParameter& p : shader.parameters)
        fmt::print("  {} = {}   ({} … {})\n{}", p.name, value_text(p), p.low, p.high,
                   p.description.empty() ? "" : fmt::format("      {}\n", p.description));
    for (const MaterialTexture& t : shader.textures)
        fmt::print("  {}: texture, {}, {}\n{}", t.name, t.colour ? "sRGB colour" : "linear",
                   stand_ins[static_cast<size_t>(t.stand_in)],
                   t.description.empty() ? "" : fmt::format("      {}\n", t.description));
}

} // namespace

void run(const MaterialsCommand& command) {
    if (!command.name.empty()) {
        const auto shader = find_material_shader(command.name);
        if (!shader) {
            std::vector<std::string> names;
            for (const auto& known : built_in_material_shaders())
                names.emplace_back(known->name);
            throw UsageError(fmt::format("{}: not a built-in material ({}){}", command.name, fmt::join(names, ", "),
                                         did_you_mean(command.name, names)));
        }
        return print(*shader);
    }
    for (const auto& shader : built_in_material_shaders())
        print(*shader);
}

} // namespace prelight::app
