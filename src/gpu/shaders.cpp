#include "shaders.hpp"
#include <algorithm>
#include <tuple>

namespace prelight::gpu {
namespace {

auto place(const EmbeddedShader& shader) { return std::tuple(shader.file, shader.material, shader.variants); }

/// Null: none.
const EmbeddedShader* find_row(std::span<const EmbeddedShader> table, const ShaderKey& key) {
    const EmbeddedShader wanted{key.file, key.material, key.variants.bits()};
    const auto found = std::lower_bound(table.begin(), table.end(), wanted,
                                        [](const auto& a, const auto& b) { return place(a) < place(b); });
    return found != table.end() && place(*found) == place(wanted) ? &*found : nullptr;
}

} // namespace

std::span<const uint32_t> find_embedded(std::span<const EmbeddedShader> table, const uint32_t* code,
                                        const ShaderKey& key) {
    if (const EmbeddedShader* row = find_row(table, key))
        return {code + row->first, row->words};
    return {};
}

bool has_shader(const ShaderKey& key) { return find_row(all_shaders(), key) != nullptr; }

} // namespace prelight::gpu
