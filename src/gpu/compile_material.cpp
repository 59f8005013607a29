// A user's material, compiled at run time: `#include "material.glsl"` means the user's file, everything else
// is what this build was made of.
#include "compile_material.hpp"
#include "glsl_sources.hpp"
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <prelight/error.hpp>
#include <shaderc/shaderc.hpp>

namespace prelight::gpu {
namespace {

/// Lines NAME|SOURCE|DEFINES, as shaders/variants.cmake lists them.
constexpr std::string_view stage_list =
#include <material_stages.inc>
    ;

struct Stage {
    std::string_view name, source, defines;
};

std::string_view take_until(std::string_view& text, char end) {
    const std::string_view taken = text.substr(0, text.find(end));
    text.remove_prefix(std::min(taken.size() + 1, text.size()));
    return taken;
}

std::vector<Stage> material_stages() {
    std::vector<Stage> stages;
    for (std::string_view rest = stage_list; !rest.empty();) {
        std::string_view line = take_until(rest, '\n');
        const std::string_view name = take_until(line, '|'), source = take_until(line, '|');
        stages.push_back({name, source, line});
    }
    return stages;
}

std::optional<std::string_view> find_source(std::string_view name) {
    for (const auto& [known, text] : glsl_sources())
        if (known == name)
            return text;
    return {};
}

class Includer final : public shaderc::CompileOptions::IncluderInterface {
public:
    explicit Includer(const MaterialShader& shader) : shader_(shader) {}

    shaderc_include_result* GetInclude(const char* requested, shaderc_include_type, const char*, size_t) override {
        auto* result = new shaderc_include_result{};
        const std::string_view name(requested);
        if (name == "material.glsl")
            set(*result, shader_.file, shader_.source);
        else if (const auto found = find_source(name))
            set(*result, found_name(name), *found);
        else // no name: an error with this text
            set(*result, {}, "there is no such file to include; a material may include what shaders/shared/ has");
        return result;
    }
    void ReleaseInclude(shaderc_include_result* result) override { delete result; }

private:
    static std::string_view found_name(std::string_view name) {
        for (const auto& [known, text] : glsl_sources())
            if (known == name)
                return known; // outlives the request
        return {};
    }
    static void set(shaderc_include_result& result, std::string_view name, std::string_view text) {
        result.source_name = name.data();
        result.source_name_length = name.size();
        result.content = text.data();
        result.content_length = text.size();
    }
    const MaterialShader& shader_;
};

/// The first error of the compiler's, in one line: "FILE:LINE: error: REASON" → "FILE:LINE: REASON".
std::string first_mistake(const std::string& messages, const MaterialShader& shader) {
    std::string_view rest = messages;
    while (!rest.empty()) {
        const std::string_view line = take_until(rest, '\n');
        const size_t at = line.find(": error: ");
        if (at != std::string_view::npos)
            return fmt::format("{}: {}", line.substr(0, at), line.substr(at + 9));
    }
    return fmt::format("{}: {}", shader.file, messages.substr(0, messages.find('\n')));
}

void add_defines(shaderc::CompileOptions& options, std::string_view defines) {
    while (!defines.empty()) {
        std::string_view word = take_until(defines, ' ');
        if (!word.starts_with("-D"))
            continue;
        word.remove_prefix(2);
        const std::string_view name = take_until(word, '=');
        options.AddMacroDefinition(std::string(name), std::string(word));
    }
}

} // namespace

std::vector<uint32_t> compile_material(const MaterialShader& shader, std::string_view name) {
    for (const Stage& stage : material_stages()) {
        if (stage.name != name)
            continue;
        shaderc::CompileOptions options;
        options.SetTargetEnvironment(shaderc_target_env_vulkan, shaderc_env_version_vulkan_1_3);
        options.SetOptimizationLevel(shaderc_optimization_level_performance);
        options.SetSuppressWarnings();
        options.SetIncluder(std::make_unique<Includer>(shader));
        add_defines(options, stage.defines);
        const std::string_view source = find_source(stage.source).value();
        const shaderc::SpvCompilationResult result = shaderc::Compiler().CompileGlslToSpv(
            source.data(), source.size(), shaderc_fragment_shader, std::string(stage.source).c_str(), options);
        if (result.GetCompilationStatus() != shaderc_compilation_status_success)
            throw Error(first_mistake(result.GetErrorMessage(), shader));
        return {result.begin(), result.end()};
    }
    throw Error(fmt::format("{}: {} is compiled with no material", shader.name, name));
}

} // namespace prelight::gpu

namespace prelight {

void check_material_shader(const MaterialShader& shader) {
    if (shader.file.empty())
        return; // was compiled with this build
    for (const gpu::Stage& stage : gpu::material_stages())
        if (stage.name.find("+decals") == std::string_view::npos) // the same code of the file's, once more
            gpu::compile_material(shader, stage.name);
}

} // namespace prelight
