// compile_shaders FOLDER INCLUDES OUT FUNCTION: compiles every shader of FOLDER in all variants that stand at its top,
// and writes OUT/FUNCTION.bin (SPIR-V), OUT/FUNCTION.cpp (which holds it and defines gpu::FUNCTION(key)) and
// OUT/FUNCTION.d (what all that was made of). INCLUDES: the folder that #include looks into; "material.glsl" is the
// file of the material in its folder materials/.
//
// What comes out of a preprocessed text is kept in OUT/cache, so that an edit compiles only what it concerns.
#include "axes.hpp"
#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <gpu/cache_file.hpp>
#include <gpu/glsl_compiler.hpp>
#include <iostream>
#include <map>
#include <mutex>
#include <platform/read_file.hpp>
#include <set>
#include <span>
#include <stdexcept>
#include <thread>
#include <tuple>

namespace {

using namespace prelight;
namespace fs = std::filesystem;

void write(const fs::path& path, std::string_view text) {
    std::ofstream file(path, std::ios::binary);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    if (!file.flush())
        throw std::runtime_error(path.string() + ": cannot be written");
}

/// As a depfile names a path.
std::string depfile_path(const std::string& path) {
    std::string out;
    for (const char c : path) {
        if (c == ' ' || c == '#')
            out += '\\';
        if (c == '$')
            out += '$';
        out += c;
    }
    return out;
}

/// Files by path, each read once; all that were asked for are what the output depends on.
class Files {
public:
    const std::string* find(const fs::path& path) {
        const std::lock_guard lock(mutex_);
        auto found = texts_.find(path);
        if (found == texts_.end()) {
            if (!fs::exists(path))
                return nullptr;
            found = texts_.emplace(path, read_text_file(path, largest_file::material)).first;
        }
        return &found->second;
    }
    std::string names() const {
        std::string out;
        for (const auto& [path, text] : texts_)
            out += " " + depfile_path(path.string());
        return out;
    }

private:
    std::mutex mutex_;
    std::map<fs::path, std::string> texts_;
};

class Includer final : public shaderc::CompileOptions::IncluderInterface {
public:
    Includer(Files& files, fs::path folder, const std::string& material)
        : files_(files), folder_(std::move(folder)), material_(material) {}

    shaderc_include_result* GetInclude(const char* requested, shaderc_include_type, const char*, size_t) override {
        auto* include = new Include;
        include->path = (folder_ / (std::string_view(requested) == "material.glsl" ? "materials/" + material_ + ".glsl"
                                                                                   : std::string(requested)))
                            .string();
        const std::string* text = files_.find(include->path);
        static const std::string missing = "there is no such file to include";
        if (!text)
            include->path.clear(); // no name: an error with this text
        text = text ? text : &missing;
        include->result = {include->path.data(), include->path.size(), text->data(), text->size(), include};
        return &include->result;
    }
    void ReleaseInclude(shaderc_include_result* result) override { delete static_cast<Include*>(result->user_data); }

private:
    struct Include {
        std::string path;
        shaderc_include_result result;
    };
    Files& files_;
    fs::path folder_;
    std::string material_;
};

class Build {
public:
    Build(fs::path folder, fs::path includes, fs::path out)
        : folder_(std::move(folder)), includes_(std::move(includes)), out_(std::move(out)) {
        fs::create_directories(out_ / "cache");
    }

    void run(const std::string& function) {
        find_keys();
        codes_.resize(keys_.size());
        std::vector<std::thread> threads;
        for (unsigned t = 0; t < std::max(std::thread::hardware_concurrency(), 1u); ++t)
            threads.emplace_back([this] { compile_all(); });
        for (std::thread& thread : threads)
            thread.join();
        if (!mistakes_.empty())
            throw std::runtime_error(mistakes_);
        for (const fs::directory_entry& kept : fs::directory_iterator(out_ / "cache"))
            if (!used_.contains(kept.path()))
                fs::remove(kept.path());
        write_all(function);
        std::cout << keys_.size() << " shaders, " << compiled_ << " compiled\n";
    }

private:
    /// Not what an editor leaves beside it.
    static bool is_source(const fs::directory_entry& file) {
        return file.is_regular_file() && !file.path().filename().string().starts_with('.');
    }

    void find_keys() {
        std::vector<std::string> materials;
        if (fs::exists(includes_ / "materials"))
            for (const fs::directory_entry& file : fs::directory_iterator(includes_ / "materials"))
                if (is_source(file) && file.path().extension() == ".glsl")
                    materials.push_back(file.path().stem().string());
        for (const fs::directory_entry& file : fs::directory_iterator(folder_)) {
            if (!is_source(file) || !kinds_.contains(file.path().extension().string()))
                continue;
            try {
                const auto keys =
                    all_keys(file.path().filename().string(), read_axes(*files_.find(file.path())), materials);
                keys_.insert(keys_.end(), keys.begin(), keys.end());
            } catch (const std::runtime_error& error) {
                throw std::runtime_error(file.path().string() + ": " + error.what());
            }
        }
        std::sort(keys_.begin(), keys_.end(), [](const auto& a, const auto& b) {
            return std::tuple(a.file, a.material, a.variants) < std::tuple(b.file, b.material, b.variants);
        });
    }

    void compile_all() {
        for (size_t k = next_++; k < keys_.size(); k = next_++)
            try {
                codes_[k] = compile(keys_[k]);
            } catch (const std::exception& error) {
                const std::lock_guard lock(mutex_);
                mistakes_ += keys_[k].text() + ":\n" + error.what() + "\n";
            }
    }

    std::vector<std::byte> compile(const gpu::ShaderKey& key) {
        shaderc::CompileOptions options = gpu::glsl_options(key);
        options.SetWarningsAsErrors();
        options.SetIncluder(
            std::make_unique<Includer>(files_, includes_, key.material.empty() ? "metallic_roughness" : key.material));
        const fs::path path = folder_ / key.file;
        const std::string& source = *files_.find(path);
        const shaderc_shader_kind kind = kinds_.at(path.extension().string());
        const auto text = compiler_.PreprocessGlsl(source, kind, path.c_str(), options);
        if (text.GetCompilationStatus() != shaderc_compilation_status_success)
            throw std::runtime_error(text.GetErrorMessage());
        gpu::CacheKey all;
        all.add(gpu::glsl_compiler_name());
        all.add(path.extension().string());
        all.add({text.begin(), text.end()});
        const fs::path kept = out_ / "cache" / (all.text() + ".spv");
        {
            const std::lock_guard lock(mutex_);
            used_.insert(kept);
        }
        if (std::vector<std::byte> code = gpu::read_cache(kept); !code.empty())
            return code;
        const auto result = compiler_.CompileGlslToSpv(source, kind, path.c_str(), options);
        if (result.GetCompilationStatus() != shaderc_compilation_status_success)
            throw std::runtime_error(result.GetErrorMessage());
        ++compiled_;
        const std::vector<uint32_t> optimized = gpu::optimize_spirv({result.begin(), result.end()});
        const std::span<const std::byte> code = std::as_bytes(std::span(optimized));
        gpu::write_cache(kept, code);
        return {code.begin(), code.end()};
    }

    void write_all(const std::string& function) const {
        std::string blob, table;
        std::map<std::string_view, size_t> places; // what several keys have stands there once
        for (size_t k = 0; k < keys_.size(); ++k) {
            const std::string_view code(reinterpret_cast<const char*>(codes_[k].data()), codes_[k].size());
            const auto [place, is_new] = places.emplace(code, blob.size() / 4);
            if (is_new)
                blob += code;
            table += "    {\"" + keys_[k].file + "\", \"" + keys_[k].material + "\", " +
                     std::to_string(keys_[k].variants.bits()) + ", " + std::to_string(place->second) + ", " +
                     std::to_string(code.size() / 4) + "},\n";
        }
        const fs::path bin = out_ / (function + ".bin"), cpp = out_ / (function + ".cpp");
        write(bin, blob);
        write(out_ / (function + ".d"), depfile_path(cpp.string()) + ":" + files_.names() + "\n");
        const std::string all = function == "find_shader"
                                    ? "std::span<const EmbeddedShader> all_shaders() { return table; }\n\n"
                                    : "std::span<const uint32_t> " + function + "(const ShaderKey& key);\n\n";
        gpu::CacheKey hash; // another blob is another text
        hash.add(blob);
        write(cpp, "// Written by tools/compile_shaders. " + hash.text() + R"(
#include <gpu/shaders.hpp>
#include <prelight/error.hpp>

asm(".section .rodata\n.balign 4\n.globl prelight_)" +
                       function + R"(_code\n.hidden prelight_)" + function + R"(_code\nprelight_)" + function +
                       R"(_code:\n.incbin \")" + bin.string() +
                       R"(\"\n.previous\n");
extern "C" const uint32_t prelight_)" +
                       function + R"(_code[];

namespace prelight::gpu {
namespace {
const EmbeddedShader table[] = {
)" + table + R"(};
} // namespace

)" + all + "std::span<const uint32_t> " +
                       function + R"((const ShaderKey& key) {
    const std::span<const uint32_t> code = find_embedded(table, prelight_)" +
                       function + R"(_code, key);
    if (code.empty())
        throw Error("shader " + key.text() + ": not one of this build's");
    return code;
}

} // namespace prelight::gpu
)");
    }

    static inline const std::map<std::string, shaderc_shader_kind> kinds_{
        {".vert", shaderc_vertex_shader}, {".frag", shaderc_fragment_shader}, {".comp", shaderc_compute_shader}};
    fs::path folder_, includes_, out_;
    const shaderc::Compiler compiler_; // one for all: without any, glslang forgets what GLSL itself declares
    Files files_;
    std::vector<gpu::ShaderKey> keys_;
    std::vector<std::vector<std::byte>> codes_;
    std::atomic<size_t> next_ = 0, compiled_ = 0;
    std::mutex mutex_;
    std::string mistakes_;
    std::set<fs::path> used_;
};

} // namespace

int main(int argc, char** argv) {
    if (argc != 5) {
        std::cerr << "usage: compile_shaders FOLDER INCLUDES OUT FUNCTION\n";
        return 2;
    }
    try {
        Build(argv[1], argv[2], argv[3]).run(argv[4]);
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
}
