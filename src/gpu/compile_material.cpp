// A user's material, compiled at run time: `#include "material.glsl"` means the user's file, everything else
// is what this build was made of. What comes out is kept on disk, for the compiler takes an eighth of a second a stage.
#include "compile_material.hpp"
#include "cache_file.hpp"
#include "glsl_compiler.hpp"
#include "glsl_sources.hpp"
#include "shaders.hpp"
#include <cstring>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <prelight/error.hpp>

namespace prelight::gpu {
namespace {

std::string_view take_until(std::string_view& text, char end) {
    const std::string_view taken = text.substr(0, text.find(end));
    text.remove_prefix(std::min(taken.size() + 1, text.size()));
    return taken;
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

/// What a stage is compiled to: SPIR-V for the device, or only a judgement of the source.
enum class Aim { draw, check };

/// The stage as the build compiles it with each material.
ShaderKey stage_of(const MaterialShader& shader, ShaderKey stage) {
    stage.variants |= Variant::own_material;
    stage.material = "metallic_roughness";
    if (!has_shader(stage))
        throw Error(fmt::format("{}: {} is compiled with no material", shader.name, stage.text()));
    return stage;
}

std::vector<uint32_t> compile(const MaterialShader& shader, const ShaderKey& stage, Aim aim) {
    shaderc::CompileOptions options = glsl_options(stage);
    options.SetSuppressWarnings();
    options.SetIncluder(std::make_unique<Includer>(shader));
    const std::string_view source = find_source(stage.file).value();
    const shaderc::SpvCompilationResult result = shaderc::Compiler().CompileGlslToSpv(
        source.data(), source.size(), shaderc_fragment_shader, stage.file.c_str(), options);
    if (result.GetCompilationStatus() != shaderc_compilation_status_success)
        throw Error(first_mistake(result.GetErrorMessage(), shader));
    const std::vector<uint32_t> code(result.begin(), result.end());
    return aim == Aim::draw ? optimize_spirv(code) : code;
}

std::string hash_of(std::string_view text) {
    CacheKey key;
    key.add(text);
    return key.text();
}

/// Everything that this build adds to a user's source.
const std::string& hash_of_own_sources() {
    static const std::string hash = [] {
        std::string all;
        for (const auto& [name, text] : glsl_sources())
            all += fmt::format("{} {}\n{}\n", name, text.size(), text);
        return hash_of(all);
    }();
    return hash;
}

/// All that decides what comes out: the compiler, its options, every source. The file's name does not.
std::string key_of(const MaterialShader& shader, const ShaderKey& stage, Aim aim) {
    return fmt::format("{}, {}\n{}\n{}\n{}", glsl_compiler_name(), aim == Aim::draw ? "to draw" : "to check",
                       hash_of_own_sources(), stage.text(), shader.source);
}

/// A file holds the length of its key, the key, and then SPIR-V: two keys of one hash don't meet.
struct KeptCode {
    std::string key;
    std::filesystem::path file; ///< empty: nothing is kept

    KeptCode(const MaterialShader& shader, const ShaderKey& stage, Aim aim) : key(key_of(shader, stage, aim)) {
        if (const std::filesystem::path folder = cache_folder(); !folder.empty())
            file = folder / "materials" / (hash_of(key) + ".spv");
    }

    std::optional<std::vector<uint32_t>> find() const {
        const std::vector<std::byte> payload = read_cache(file);
        uint64_t length = 0;
        if (payload.size() < sizeof length)
            return {};
        std::memcpy(&length, payload.data(), sizeof length);
        const std::span<const std::byte> rest = std::span(payload).subspan(sizeof length);
        if (length != key.size() || rest.size() < length || (rest.size() - length) % 4 != 0 ||
            std::memcmp(rest.data(), key.data(), key.size()) != 0)
            return {};
        std::vector<uint32_t> code((rest.size() - length) / 4);
        if (!code.empty())
            std::memcpy(code.data(), rest.data() + length, code.size() * 4);
        return code;
    }

    void keep(std::span<const uint32_t> code) const {
        if (file.empty())
            return;
        const uint64_t length = key.size();
        std::vector<std::byte> payload(sizeof length + key.size() + code.size_bytes());
        std::memcpy(payload.data(), &length, sizeof length);
        std::memcpy(payload.data() + sizeof length, key.data(), key.size());
        if (!code.empty())
            std::memcpy(payload.data() + sizeof length + key.size(), code.data(), code.size_bytes());
        write_cache(file, payload);
        trim_cache(file.parent_path(), most_kept);
    }

    /// Somebody who edits a material leaves a few files with every version.
    static constexpr size_t most_kept = 500;
};

} // namespace

std::vector<uint32_t> compile_material(const MaterialShader& shader, const ShaderKey& wanted) {
    const ShaderKey stage = stage_of(shader, wanted);
    const KeptCode kept(shader, stage, Aim::draw);
    if (auto code = kept.find(); code && !code->empty())
        return std::move(*code);
    std::vector<uint32_t> code = compile(shader, stage, Aim::draw);
    kept.keep(code);
    return code;
}

} // namespace prelight::gpu

namespace prelight {

void check_material_shader(const MaterialShader& shader) {
    if (shader.file.empty())
        return; // was compiled with this build
    for (const char* file : {"material.frag", "forward.frag"}) {
        const gpu::ShaderKey stage = gpu::stage_of(shader, file);
        const gpu::KeptCode kept(shader, stage, gpu::Aim::check);
        if (kept.find())
            continue;
        gpu::compile(shader, stage, gpu::Aim::check);
        kept.keep({}); // that it compiles is all there is to know
    }
}

} // namespace prelight
