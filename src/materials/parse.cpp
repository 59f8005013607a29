// What a material's file declares: its parameters and textures. Its code is the compiler's business.
#include "scanner.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <prelight/material_shader.hpp>

namespace prelight {
namespace {

using materials::Scanner;

constexpr uint32_t own_textures = 8; // MATERIAL_OWN_TEXTURES of bindings.h
constexpr uint32_t most_parameter_bytes = 1024;

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    for (size_t start = 0; start <= text.size();) {
        const size_t end = std::min(text.find('\n', start), text.size());
        lines.push_back(text.substr(start, end - start));
        start = end + 1;
    }
    return lines;
}

/// What stands behind "//", without blanks around it.
std::string comment_of(std::string_view line) {
    const size_t at = line.find("//");
    if (at == std::string_view::npos)
        return {};
    line.remove_prefix(at + 2);
    const size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string_view::npos)
        return {};
    return std::string(line.substr(first, line.find_last_not_of(" \t\r") - first + 1));
}

class Parser {
public:
    Parser(MaterialShader& shader)
        : shader_(shader), code_(materials::without_comments(shader.source)), lines_(lines_of(code_)),
          original_(lines_of(shader.source)) {}

    void parse() {
        take_description();
        for (line_ = 0; line_ < lines_.size(); ++line_) {
            Scanner scanner(lines_[line_]);
            const std::string_view word = scanner.word();
            if (word == "PARAMETERS")
                take_parameters(scanner);
            else if (word == "TEXTURE_COLOUR" || word == "TEXTURE_LINEAR")
                take_texture(scanner, word == "TEXTURE_COLOUR");
        }
        expect_function("Surface", "surface", "Surface surface(Point p)");
        expect_function("vec3", "shade", "vec3 shade(Point p, Surface s, Light light)");
    }

private:
    [[noreturn]] void fail(std::string_view reason) const {
        throw Error(fmt::format("{}:{}: {}", shader_.file.empty() ? shader_.name : shader_.file, line_ + 1, reason));
    }

    void take_description() {
        for (size_t i = 0; i < original_.size() && original_[i].starts_with("//"); ++i)
            shader_.description += fmt::format("{}{}", i > 0 ? " " : "", comment_of(original_[i]));
    }

    void take_parameters(Scanner scanner) {
        if (shader_.parameter_bytes > 0)
            fail("there is a second PARAMETERS block");
        if (!scanner.take("{") || !scanner.done())
            fail("a block of parameters begins with \"PARAMETERS {\" and has one parameter a line");
        for (++line_; line_ < lines_.size(); ++line_) {
            Scanner line(lines_[line_]);
            if (line.done())
                continue;
            if (line.take("}")) {
                if (shader_.parameters.empty())
                    fail("PARAMETERS without a parameter");
                if (shader_.parameter_bytes > most_parameter_bytes)
                    fail(fmt::format("parameters take {} bytes, and there is room for {}", shader_.parameter_bytes,
                                     most_parameter_bytes));
                return;
            }
            take_parameter(line);
        }
        --line_;
        fail("PARAMETERS has no end: \"};\"");
    }

    void take_parameter(Scanner& line) {
        MaterialParameter parameter;
        const std::string_view type = line.word();
        parameter.components = type == "float" ? 1 : type == "vec2" ? 2 : type == "vec3" ? 3 : type == "vec4" ? 4 : 0;
        parameter.name = line.word();
        const auto read = [&] {
            if (parameter.components == 0 || parameter.name.empty() || !line.take("DEFAULT") || !line.take("("))
                return false;
            if (!take_value(line, parameter) || !line.take(")") || !line.take("RANGE") || !line.take("("))
                return false;
            const auto low = line.number();
            const bool comma = line.take(",");
            const auto high = line.number();
            if (!low || !comma || !high || !line.take(")") || !line.take(";") || !line.done())
                return false;
            parameter.low = *low;
            parameter.high = *high;
            return true;
        };
        if (!read())
            fail("a parameter reads TYPE NAME DEFAULT(VALUE) RANGE(LOW, HIGH); with float, vec2, vec3 or vec4");
        if (shader_.find_parameter(parameter.name))
            fail(fmt::format("parameter {} is there twice", parameter.name));
        for (uint32_t c = 0; c < parameter.components; ++c) {
            const float value = parameter.default_value[static_cast<int>(c)];
            if (!(value >= parameter.low && value <= parameter.high))
                fail(fmt::format("parameter {}: its default {} is outside {} … {}", parameter.name, value,
                                 parameter.low, parameter.high));
        }
        // std140: a vec3 begins at a multiple of 16 bytes, and the next float may follow it at once.
        const uint32_t alignment = parameter.components == 3 ? 16 : 4 * parameter.components;
        parameter.offset = (shader_.parameter_bytes + alignment - 1) / alignment * alignment;
        parameter.description = comment_of(original_[line_]);
        shader_.parameter_bytes = parameter.offset + 4 * parameter.components;
        shader_.parameters.push_back(std::move(parameter));
    }

    /// A number, or vecN of one or N numbers.
    static bool take_value(Scanner& line, MaterialParameter& parameter) {
        const std::string_view type = line.word();
        if (!type.empty() && (type != fmt::format("vec{}", parameter.components) || !line.take("(")))
            return false;
        if (type.empty() && parameter.components > 1)
            return false;
        uint32_t count = 0;
        do {
            const auto value = line.number();
            if (!value || count == parameter.components)
                return false;
            parameter.default_value[static_cast<int>(count++)] = *value;
        } while (parameter.components > 1 && line.take(","));
        for (uint32_t c = 1; count == 1 && c < parameter.components; ++c)
            parameter.default_value[static_cast<int>(c)] = parameter.default_value.x;
        return (count == 1 || count == parameter.components) && (type.empty() || line.take(")"));
    }

    void take_texture(Scanner& line, bool colour) {
        using StandIn = MaterialTexture::StandIn;
        MaterialTexture texture{.colour = colour};
        std::optional<float> slot;
        if (!line.take("(") || !(slot = line.number()) || !line.take(")") || (texture.name = line.word()).empty() ||
            !line.take("DEFAULT") || !line.take("("))
            fail("a texture reads TEXTURE_LINEAR(SLOT) NAME DEFAULT(white); or TEXTURE_COLOUR(…)");
        if (!(*slot >= 0 && *slot < own_textures) || *slot != std::floor(*slot))
            fail(fmt::format("texture {}: slots are 0 … {}", texture.name, own_textures - 1));
        texture.slot = static_cast<uint32_t>(*slot);
        const std::string_view stand_in = line.word();
        if (stand_in == "black")
            texture.stand_in = StandIn::black;
        else if (stand_in == "flat")
            texture.stand_in = StandIn::flat;
        else if (stand_in == "required")
            texture.stand_in = StandIn::required;
        else if (stand_in != "white")
            fail(fmt::format("texture {}: DEFAULT is white, black, flat or required", texture.name));
        if (!line.take(")") || !line.take(";"))
            fail(fmt::format("texture {}: \");\" is missing", texture.name));
        for (const MaterialTexture& other : shader_.textures)
            if (other.name == texture.name || other.slot == texture.slot)
                fail(fmt::format("texture {}: name or slot {} is there twice", texture.name, texture.slot));
        texture.description = comment_of(original_[line_]);
        shader_.textures.push_back(std::move(texture));
    }

    void expect_function(std::string_view type, std::string_view name, std::string_view form) {
        for (const std::string_view text : lines_) {
            Scanner line(text);
            if (line.word() == type && line.word() == name && line.take("("))
                return;
        }
        line_ = lines_.size() - 1;
        fail(fmt::format("has no {}() that begins a line with \"{}\"", name, form));
    }

    MaterialShader& shader_;
    std::string code_;
    std::vector<std::string_view> lines_, original_;
    size_t line_ = 0;
};

} // namespace

const MaterialParameter* MaterialShader::find_parameter(std::string_view parameter) const {
    const auto found = std::find_if(parameters.begin(), parameters.end(),
                                    [&](const MaterialParameter& p) { return p.name == parameter; });
    return found == parameters.end() ? nullptr : &*found;
}

const MaterialTexture* MaterialShader::find_texture(std::string_view texture) const {
    const auto found =
        std::find_if(textures.begin(), textures.end(), [&](const MaterialTexture& t) { return t.name == texture; });
    return found == textures.end() ? nullptr : &*found;
}

std::shared_ptr<const MaterialShader> parse_material_shader(std::string name, std::string file, std::string source) {
    auto shader = std::make_shared<MaterialShader>();
    shader->name = std::move(name);
    shader->file = std::move(file);
    shader->source = std::move(source);
    Parser(*shader).parse();
    return shader;
}

} // namespace prelight
