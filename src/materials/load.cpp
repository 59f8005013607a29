#include <fmt/format.h>
#include <fstream>
#include <prelight/error.hpp>
#include <prelight/material_shader.hpp>

namespace prelight {
namespace {

constexpr uintmax_t most_bytes = 1u << 20;

} // namespace

std::shared_ptr<const MaterialShader> load_material_shader(const std::filesystem::path& file) {
    const std::string name = file.string();
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
        throw Error(fmt::format("{}: no such file", name));
    if (std::filesystem::file_size(file, error) > most_bytes || error)
        throw Error(fmt::format("{}: a material's file has at most {} bytes", name, most_bytes));
    std::ifstream stream(file, std::ios::binary);
    std::string source(std::istreambuf_iterator<char>(stream), {});
    if (!stream)
        throw Error(fmt::format("{}: cannot be read", name));
    return parse_material_shader(file.filename().string(), name, std::move(source));
}

} // namespace prelight
