#include <platform/read_file.hpp>
#include <prelight/material_shader.hpp>

namespace prelight {

std::shared_ptr<const MaterialShader> load_material_shader(const std::filesystem::path& file) {
    return parse_material_shader(file.filename().string(), file.string(), read_text_file(file, largest_file::material));
}

} // namespace prelight
